#include "pipeline/surface/surface_lines.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "engine/base/log.hpp"
#include "pipeline/surface/elements.hpp"
#include "surface/feature/edge_chains.hpp"
#include "surface/feature/polyline3.hpp"

namespace quarry {
namespace {

// How lines are led, in edges of triangles; and by default, in sizes, what they snap to and how far from the
// surface they may lie.
constexpr double kImprintStep = 0.5;
constexpr double kDefaultSnap = 0.05;
constexpr double kImprintReach = 1;

std::vector<SurfaceLine> surface_lines(const LineSet& input) {
  std::vector<SurfaceLine> lines;
  for (const InputLine& line : input.lines) {
    SurfaceLine on_surface;
    on_surface.has_heights = !line.heights.empty();
    for (std::size_t i = 0; i < line.points.size(); ++i)
      on_surface.points.push_back(
          {line.points[i].x, line.points[i].y, on_surface.has_heights ? line.heights[i] : 0});
    lines.push_back(std::move(on_surface));
  }
  return lines;
}

std::pair<LineFate, std::string> fate_of(const ImprintedLine& line) {
  if (line.edges + line.shared == 0)
    return {LineFate::kDropped,
            line.lost > 0 ? "it could not be followed across the surface" : "it lies nowhere on the surface"};
  if (line.lost > 0)
    return {LineFate::kClipped,
            fmt::format("{} of its stretches could not be followed across the surface", line.lost)};
  if (line.outside > 0)
    return {LineFate::kClipped, fmt::format("it leaves the surface or comes to it {} times", line.outside)};
  if (line.shared > 0)
    return {LineFate::kJoined, line.edges == 0
                                   ? "all of it lies on lines before it, whose number its edges have"
                                   : "a part of it lies on lines before it"};
  if (line.lends) return {LineFate::kJoined, "lines behind it share edges that have its number"};
  return {line.meets ? LineFate::kSplit : LineFate::kKept, ""};
}

using Courses = std::vector<Polyline3>;

// What the mesh has of each line.
std::vector<Courses> courses_of_lines(const Mesh& mesh, std::size_t lines) {
  const auto constraint = mesh.find_tag<EdgeId, std::int32_t>("constraint");
  std::vector<std::array<std::uint32_t, 2>> ends;
  std::vector<std::size_t> line_of;
  std::vector<std::uint32_t> edges_at(mesh.vertex_slots(), 0);
  for (const EdgeId e : mesh.edges()) {
    if (constraint[e] < 0 || static_cast<std::size_t>(constraint[e]) >= lines) continue;
    const auto [a, b] = mesh.edge_ends(e);
    ends.push_back({a.value(), b.value()});
    line_of.push_back(static_cast<std::size_t>(constraint[e]));
    for (const VertexId v : {a, b}) ++edges_at[v.value()];
  }
  std::vector<std::uint8_t> node(mesh.vertex_slots());
  for (std::size_t v = 0; v < node.size(); ++v) node[v] = edges_at[v] != 2 ? 1 : 0;
  // Where one line ends and another begins.
  std::vector<std::size_t> first(mesh.vertex_slots(), lines);
  for (std::size_t e = 0; e < ends.size(); ++e)
    for (const std::uint32_t v : ends[e]) {
      if (first[v] == lines) first[v] = line_of[e];
      if (first[v] != line_of[e]) node[v] = 1;
    }
  std::vector<Courses> courses(lines);
  for (const EdgeChain& chain : edge_chains(ends, node)) {
    std::vector<Vec3> points;
    for (const std::uint32_t v : chain.points) points.push_back(mesh.point3(VertexId(v)));
    courses[line_of[chain.first_edge]].emplace_back(std::move(points));
  }
  return courses;
}

double distance_to(const Courses& courses, Vec3 place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Polyline3& course : courses) nearest = std::min(nearest, length(course.nearest(place) - place));
  return nearest;
}

}  // namespace

std::vector<LineEdge> imprint_input(RepairedSurface& repaired, const SurfaceOptions& options,
                                    SurfaceResult& result) {
  result.imprint = {};
  if (result.lines.lines.empty()) return {};
  if (!result.lines.points.empty())
    log::warn("{} points of --lines are left out: on surfaces they are planned", result.lines.points.size());
  ImprintOptions imprint;
  imprint.step = kImprintStep * first_edge(options.elements, result.method) * result.size;
  imprint.snap = options.snap.value_or(kDefaultSnap * result.size);
  imprint.reach = kImprintReach * result.size;
  return imprint_lines(repaired, surface_lines(result.lines), imprint, result.imprint);
}

IdVector<LineId, LedgerEntry> ledger_of(const ImprintReport& imprint) {
  IdVector<LineId, LedgerEntry> ledger(imprint.lines.size());
  for (std::size_t i = 0; i < ledger.size(); ++i) {
    const ImprintedLine& line = imprint.lines[i];
    LedgerEntry& entry = ledger[LineId(i)];
    std::tie(entry.fate, entry.why) = fate_of(line);
    for (const std::int32_t other : line.with)
      entry.with.push_back(LineId(static_cast<std::uint32_t>(other)));
  }
  return ledger;
}

IdVector<LineId, double> line_distances(const SurfaceResult& result) {
  const std::vector<ImprintedLine>& lines = result.imprint.lines;
  const std::vector<Courses> courses = courses_of_lines(result.mesh, lines.size());
  IdVector<LineId, double> distances(lines.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].edges + lines[i].shared == 0) continue;
    double largest = 0;
    for (const Vec3 place : lines[i].places) {
      double nearest = distance_to(courses[i], place);
      if (lines[i].shared > 0)
        for (const std::int32_t other : lines[i].with)
          nearest = std::min(nearest, distance_to(courses[static_cast<std::size_t>(other)], place));
      largest = std::max(largest, nearest);
    }
    distances[LineId(i)] = largest;
  }
  return distances;
}

}  // namespace quarry
