#include "pipeline/section/region_names.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/geometry/predicates.hpp"
#include "io/lines/ring.hpp"
#include "io/number_text.hpp"

namespace quarry {
namespace {

// A polygon with what is said of it.
struct NamedPolygon {
  std::vector<const InputLine*> rings;  // the outer one first
  LineAttributes attributes;
  Box2 box;
  double area = 0;  // of the outer ring

  [[nodiscard]] bool holds(Vec2 p) const {
    if (!box.contains(p)) return false;
    const auto around = [&](const InputLine* ring) { return ring_holds(ring->points, p); };
    return std::ranges::count_if(rings, around) % 2 == 1;
  }
};

// Those with a name or a material, small ones first.
std::vector<NamedPolygon> named_polygons(const std::vector<const LineSet*>& sets) {
  std::vector<NamedPolygon> polygons;
  for (const LineSet* set : sets) {
    bool named = false;
    for (const LineId id : IdRange<LineId>(set->lines.size())) {
      const InputLine& line = set->lines[id];
      if (!line.polygon_ring || line.points.size() < 4) continue;
      if (line.hole) {
        if (named) polygons.back().rings.push_back(&line);
        continue;
      }
      const LineAttributes attributes = set->attributes_of(id);
      named = !attributes.name.empty() || !attributes.material.empty();
      if (!named) continue;
      NamedPolygon polygon{{&line}, attributes, {}, std::abs(doubled_area(line.points)) / 2};
      for (const Vec2 p : line.points) polygon.box.extend(p);
      polygons.push_back(std::move(polygon));
    }
  }
  std::ranges::stable_sort(polygons, {}, &NamedPolygon::area);
  return polygons;
}

Vec2 centre_of(const Mesh& mesh, FaceId f) {
  Vec2 sum;
  for (int k = 0; k < mesh.corner_count(f); ++k) sum = sum + mesh.point(mesh.corner(f, k));
  return (1.0 / mesh.corner_count(f)) * sum;
}

double area_of(const Mesh& mesh, FaceId f) {
  const Vec2 first = mesh.point(mesh.corner(f, 0));
  double twice = 0;
  for (int k = 1; k + 1 < mesh.corner_count(f); ++k)
    twice += cross(mesh.point(mesh.corner(f, k)) - first, mesh.point(mesh.corner(f, k + 1)) - first);
  return twice / 2;
}

// A point well within each region: the middle of its largest face.
std::vector<Vec2> points_within(const Mesh& mesh, Tag<FaceId, std::int32_t> region) {
  std::vector<FaceId> largest;
  std::vector<double> areas;
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    const auto at = static_cast<std::size_t>(region[f]);
    if (at >= largest.size()) {
      largest.resize(at + 1);
      areas.resize(at + 1, -1);
    }
    const double area = area_of(mesh, f);
    if (area <= areas[at]) continue;
    areas[at] = area;
    largest[at] = f;
  }
  std::vector<Vec2> points;
  for (const FaceId f : largest) points.push_back(f.valid() ? centre_of(mesh, f) : Vec2());
  return points;
}

FaceId face_at(const Mesh& mesh, Vec2 p) {
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    bool inside = true;
    for (int k = 0; k < mesh.corner_count(f) && inside; ++k) {
      const SideId s(f, k);
      inside = orient2d(mesh.point(mesh.origin(s)), mesh.point(mesh.target(s)), p) >= 0;
    }
    if (inside) return f;
  }
  return {};
}

void name_by_seeds(const Mesh& mesh, Tag<FaceId, std::int32_t> region, const std::vector<SeedPoint>& seeds,
                   std::vector<std::string>& names) {
  std::vector<const SeedPoint*> seed_of(names.size(), nullptr);
  for (const SeedPoint& seed : seeds) {
    const std::string text =
        fmt::format("--seed-point {} at {}", seed.name, format_point(seed.place.x, seed.place.y));
    const FaceId face = face_at(mesh, seed.place);
    if (!face.valid()) throw Error(ErrorKind::kInput, text + " lies in no region of the mesh");
    const SeedPoint*& other = seed_of[static_cast<std::size_t>(region[face])];
    if (other != nullptr && other->name != seed.name)
      throw Error(ErrorKind::kInput,
                  fmt::format("{} and {} at {} lie in one region: no line parts them", text, other->name,
                              format_point(other->place.x, other->place.y)));
    other = &seed;
    names[static_cast<std::size_t>(region[face])] = seed.name;
  }
}

// Tags the faces of regions with the places of their names in the grouping, to which new ones are added.
void tag_faces(Mesh& mesh, Tag<FaceId, std::int32_t> region, const std::vector<std::string>& names,
               const char* tag_name, std::vector<Grouping>& groups) {
  if (std::ranges::all_of(names, &std::string::empty)) return;
  auto grouping = std::ranges::find(groups, tag_name, &Grouping::tag);
  if (grouping == groups.end()) grouping = groups.insert(groups.end(), {tag_name, {}});
  std::vector<std::int32_t> index;
  for (const std::string& name : names) {
    auto at = std::ranges::find(grouping->names, name);
    if (at == grouping->names.end() && !name.empty()) at = grouping->names.insert(at, name);
    index.push_back(name.empty() ? -1 : static_cast<std::int32_t>(at - grouping->names.begin()));
  }
  auto tag = mesh.add_tag<FaceId, std::int32_t>(tag_name, -1);
  for (const FaceId f : mesh.faces())
    if (mesh.alive(f)) tag[f] = index[static_cast<std::size_t>(region[f])];
}

}  // namespace

std::vector<SeedPoint> parse_seed_points(const std::vector<std::string>& texts) {
  std::vector<SeedPoint> seeds;
  for (const std::string& text : texts) {
    const std::size_t first = text.find(','), second = text.find(',', first + 1);
    if (first != std::string::npos && second != std::string::npos && second + 1 < text.size()) {
      const auto x = parse_finite(std::string_view(text).substr(0, first));
      const auto y = parse_finite(std::string_view(text).substr(first + 1, second - first - 1));
      if (x && y) {
        seeds.push_back({{*x, *y}, text.substr(second + 1)});
        continue;
      }
    }
    throw Error(ErrorKind::kUsage, fmt::format("--seed-point {}: give a place and a name as X,Y,NAME", text));
  }
  return seeds;
}

void name_regions(Mesh& mesh, const std::vector<const LineSet*>& sets, const std::vector<SeedPoint>& seeds,
                  std::vector<Grouping>& groups) {
  const std::vector<NamedPolygon> polygons = named_polygons(sets);
  if (polygons.empty() && seeds.empty()) return;
  const auto region = mesh.find_tag<FaceId, std::int32_t>("region");
  const std::vector<Vec2> points = points_within(mesh, region);
  std::vector<std::string> names(points.size()), materials(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const NamedPolygon& polygon : polygons) {
      if (!polygon.holds(points[i])) continue;
      if (names[i].empty()) names[i] = polygon.attributes.name;
      if (materials[i].empty()) materials[i] = polygon.attributes.material;
      if (!names[i].empty() && !materials[i].empty()) break;
    }
  name_by_seeds(mesh, region, seeds, names);
  tag_faces(mesh, region, names, kZoneTag, groups);
  tag_faces(mesh, region, materials, "material", groups);
}

}  // namespace quarry
