#include "pipeline/surface/surface_lines.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "engine/base/log.hpp"
#include "pipeline/surface/elements.hpp"

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

double distance_to_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 d = b - a;
  const double squared = dot(d, d);
  const double share = squared > 0 ? std::clamp(dot(p - a, d) / squared, 0.0, 1.0) : 0.0;
  return length(p - (a + share * d));
}

using Segments = std::vector<std::pair<Vec3, Vec3>>;

// By line.
std::vector<Segments> edges_of_lines(const Mesh& mesh, std::size_t lines) {
  std::vector<Segments> edges(lines);
  const auto constraint = mesh.find_tag<EdgeId, std::int32_t>("constraint");
  for (const EdgeId e : mesh.edges()) {
    if (constraint[e] < 0 || static_cast<std::size_t>(constraint[e]) >= lines) continue;
    const auto [a, b] = mesh.edge_ends(e);
    edges[static_cast<std::size_t>(constraint[e])].emplace_back(mesh.point3(a), mesh.point3(b));
  }
  return edges;
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
  const std::vector<Segments> edges = edges_of_lines(result.mesh, lines.size());
  IdVector<LineId, double> distances(lines.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].edges + lines[i].shared == 0) continue;
    Segments own = edges[i];
    if (lines[i].shared > 0)
      for (const std::int32_t other : lines[i].with)
        own.insert(own.end(), edges[static_cast<std::size_t>(other)].begin(),
                   edges[static_cast<std::size_t>(other)].end());
    double largest = 0;
    for (const Vec3 place : lines[i].places) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& [a, b] : own) nearest = std::min(nearest, distance_to_segment(place, a, b));
      largest = std::max(largest, nearest);
    }
    distances[LineId(i)] = largest;
  }
  return distances;
}

}  // namespace quarry
