#include "pipeline/improve/face_surface.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"
#include "surface/repair/orient.hpp"
#include "surface/repair/sheets.hpp"
#include "surface/repair/surface_edges.hpp"
#include "surface/repair/weld.hpp"

namespace quarry {
namespace {

using EdgeKey = std::uint64_t;

EdgeKey key_of(std::uint32_t a, std::uint32_t b) { return (EdgeKey{std::min(a, b)} << 32) | std::max(a, b); }

bool contains(const std::vector<EdgeKey>& sorted, EdgeKey key) {
  return std::binary_search(sorted.begin(), sorted.end(), key);
}

std::size_t corner_count(const FaceCorners& face) { return face[3].valid() ? 4 : 3; }

// Which diagonal divides each quad: 0 from its first corner, 1 from its second.
class Diagonals {
 public:
  Diagonals(const std::string& path, const ReadCells& cells, const std::vector<Vec3>& points)
      : path_(path), faces_(cells.faces), points_(points), choice_(cells.faces.size(), 0) {}

  std::vector<std::uint8_t> run() {
    parallel::for_each(faces_.size(), [&](std::size_t f) {
      if (faces_[f][3].valid()) choice_[f] = preferred(faces_[f]);
    });
    collect_edges();
    keys_.resize(quads_.size());
    parallel::for_each(keys_.size(), [&](std::size_t i) { keys_[i] = key(quads_[i], choice_[quads_[i]]); });
    parallel::stable_sort_by_key(keys_, quads_);
    std::vector<std::uint32_t> barred;
    for (std::size_t i = 0; i < keys_.size(); ++i)
      if ((i > 0 && keys_[i] == keys_[i - 1]) || contains(edges_, keys_[i])) barred.push_back(quads_[i]);
    std::sort(barred.begin(), barred.end());
    for (const std::uint32_t f : barred) take_other(f);
    return std::move(choice_);
  }

 private:
  [[nodiscard]] Vec3 corner(const FaceCorners& face, std::size_t k) const {
    return points_[face[k % 4].value()];
  }

  // Whether both triangles beside the diagonal look the same way.
  [[nodiscard]] bool divides(const FaceCorners& face, std::size_t from) const {
    const Vec3 a = corner(face, from), c = corner(face, from + 2);
    return dot(cross(corner(face, from + 1) - a, c - a), cross(c - a, corner(face, from + 3) - a)) > 0;
  }

  [[nodiscard]] std::uint8_t preferred(const FaceCorners& face) const {
    const bool first = divides(face, 0), second = divides(face, 1);
    if (first != second) return first ? 0 : 1;
    const Vec3 p = corner(face, 2) - corner(face, 0), q = corner(face, 3) - corner(face, 1);
    return dot(p, p) <= dot(q, q) ? 0 : 1;
  }

  [[nodiscard]] EdgeKey key(std::uint32_t f, std::uint8_t from) const {
    return key_of(faces_[f][from].value(), faces_[f][from + 2U].value());
  }

  void collect_edges() {
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      const std::size_t count = corner_count(faces_[f]);
      if (count == 4) quads_.push_back(f);
      for (std::size_t k = 0; k < count; ++k)
        edges_.push_back(key_of(faces_[f][k].value(), faces_[f][(k + 1) % count].value()));
    }
    std::vector<std::uint32_t> none(edges_.size());
    parallel::stable_sort_by_key(edges_, none);
  }

  // Two quads may share two sides, and with them a diagonal.
  void take_other(std::uint32_t f) {
    const EdgeKey other = key(f, choice_[f] == 0 ? 1 : 0);
    if (contains(edges_, other) || contains(keys_, other) || !taken_.insert(other).second) {
      const Vec3 p = corner(faces_[f], 0);
      throw Error(ErrorKind::kGeometry,
                  fmt::format("{}: face {} at ({:.10g}, {:.10g}, {:.10g}) lies on others: leave it out",
                              path_, f + 1, p.x, p.y, p.z));
    }
    choice_[f] ^= 1;
  }

  const std::string& path_;
  const std::vector<FaceCorners>& faces_;
  const std::vector<Vec3>& points_;
  std::vector<std::uint8_t> choice_;
  std::vector<EdgeKey> edges_;        // of all faces, ascending
  std::vector<std::uint32_t> quads_;  // in the order of their diagonals
  std::vector<EdgeKey> keys_;         // of the preferred diagonals, ascending
  std::set<EdgeKey> taken_;           // of others in their place
};

void require_points(const std::string& path, const ReadCells& cells) {
  for (std::size_t f = 0; f < cells.faces.size(); ++f)
    for (const VertexId v : cells.faces[f])
      if (v.valid() && v.value() >= cells.x.size())
        throw Error(ErrorKind::kInput,
                    fmt::format("{}: face {} names a point that does not exist", path, f + 1));
}

// Leaves out corners that repeat the one before them; false if fewer than three are left, or one is met
// again.
bool narrow(FaceCorners& face) {
  std::array<VertexId, 4> kept;
  std::size_t count = 0;
  for (std::size_t k = 0; k < corner_count(face); ++k)
    if (face[k] != face[(k + 1) % corner_count(face)]) kept[count++] = face[k];
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (kept[j] == kept[k]) return false;
  for (std::size_t k = 0; k < 4; ++k) face[k] = k < count ? kept[k] : VertexId();
  return count >= 3;
}

void weld(const std::string& path, const std::vector<Vec3>& points, ReadCells& cells, FaceSurface& result) {
  const std::vector<std::uint32_t> first = weld_points(points, 0);
  for (std::uint32_t p = 0; p < first.size(); ++p)
    if (first[p] != p) ++result.welded;
  const auto follow = [&](VertexId& v) {
    if (v.valid() && v.value() < first.size()) v = VertexId(first[v.value()]);
  };
  for (std::size_t f = 0; f < cells.faces.size(); ++f) {
    FaceCorners& face = cells.faces[f];
    for (VertexId& v : face) follow(v);
    const std::size_t corners = corner_count(face);
    if (!narrow(face))
      throw Error(ErrorKind::kGeometry,
                  fmt::format("{}: face {} has fewer than {} places: leave it out", path, f + 1, corners));
    if (corner_count(face) < corners) ++result.narrowed;
  }
  for (auto& [a, b] : cells.edges) {
    follow(a);
    follow(b);
  }
  for (VertexId& v : cells.points) follow(v);
}

void add_triangles(const FaceCorners& face, std::uint8_t from, std::int32_t group, FaceSurface& result) {
  TriangleSurface& surface = result.triangles.surface;
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    surface.triangles.push_back({face[a].value(), face[b].value(), face[c].value()});
    surface.groups.push_back(group);
  };
  if (!face[3].valid()) return add(0, 1, 2);
  add(from, from + 1U, from + 2U);
  add(from, from + 2U, (from + 3U) % 4);
  result.within.push_back(join_of(face[from].value(), face[from + 2U].value()));
}

// A face turns as its first triangle does: on a one-sided band they may disagree, and the seam that is found
// afterwards runs beside the face.
void turn_faces(ReadCells& cells, FaceSurface& result) {
  TriangleSurface& surface = result.triangles.surface;
  const Orientation orientation = orient(surface, SurfaceEdges(surface));
  std::size_t t = 0;
  for (FaceCorners& face : cells.faces) {
    const std::size_t count = corner_count(face);
    if (orientation.turn[t] != 0) {
      ++result.turned;
      std::swap(face[1], face[count - 1]);
      for (std::size_t i = t; i < t + count - 2; ++i)
        std::swap(surface.triangles[i][1], surface.triangles[i][2]);
    }
    t += count - 2;
  }
}

// Finds the edges in which sheets end, and the mean side.
void look_at_edges(FaceSurface& result) {
  const TriangleSurface& surface = result.triangles.surface;
  const SurfaceEdges edges(surface);
  double sum = 0;
  for (std::size_t e = 0; e < edges.count(); ++e) {
    const auto [a, b] = SurfaceEdges::ends(surface, edges.sides(e)[0]);
    const SheetJoin ends = join_of(a, b);
    const EdgeUse use = edges.use_of(surface, e);
    if (use == EdgeUse::kSeam || use == EdgeUse::kBranch) result.triangles.joins.push_back(ends);
    if (!std::binary_search(result.within.begin(), result.within.end(), ends))
      sum += length(surface.points[b] - surface.points[a]);
  }
  result.mean_side = sum / static_cast<double>(edges.count() - result.within.size());
}

}  // namespace

FaceSurface make_face_surface(const std::string& path, ReadCells& cells) {
  require_points(path, cells);
  FaceSurface result;
  TriangleSurface& surface = result.triangles.surface;
  for (std::size_t i = 0; i < cells.x.size(); ++i)
    surface.points.push_back({cells.x[i], cells.y[i], cells.z[i]});
  weld(path, surface.points, cells, result);
  const std::vector<std::uint8_t> diagonals = Diagonals(path, cells, surface.points).run();
  for (std::size_t f = 0; f < cells.faces.size(); ++f)
    add_triangles(cells.faces[f], diagonals[f], cells.regions[f], result);
  std::sort(result.within.begin(), result.within.end());
  turn_faces(cells, result);
  look_at_edges(result);
  return result;
}

Mesh make_face_mesh(const FaceSurface& surface, const Mesh& sheets, const std::vector<FaceCorners>& faces) {
  const std::vector<SurfaceTriangle>& triangles = surface.triangles.surface.triangles;
  std::vector<FaceCorners> corners(faces.size());
  std::size_t t = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::size_t count = corner_count(faces[f]);
    for (std::size_t i = t; i < t + count - 2; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t c = 0; c < count; ++c)
          if (faces[f][c].value() == triangles[i][k])
            corners[f][c] = sheets.corner(FaceId(i), static_cast<int>(k));
    t += count - 2;
  }
  std::vector<double> x, y, z;
  for (const VertexId v : sheets.vertices()) {
    const Vec3 p = sheets.point3(v);
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
  }
  Mesh mesh = build_mesh(std::move(x), std::move(y), std::move(z), corners);
  const auto from = sheets.find_tag<VertexId, std::uint32_t>(kSurfacePointTag);
  auto point = mesh.add_tag<VertexId, std::uint32_t>(kSurfacePointTag);
  for (const VertexId v : mesh.vertices()) point[v] = from[v];
  return mesh;
}

double rounding_of(const TriangleSurface& surface) {
  Vec3 low = surface.points[surface.triangles.front()[0]], high = low;
  for (const SurfaceTriangle& t : surface.triangles)
    for (const std::uint32_t i : t) {
      const Vec3 p = surface.points[i];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  const double side = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const double largest = std::max({-low.x, -low.y, -low.z, high.x, high.y, high.z});
  return std::max(1e-9 * side, 4 * std::numeric_limits<double>::epsilon() * largest);
}

}  // namespace quarry
