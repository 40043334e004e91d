#include "surface/repair/repair.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"
#include "surface/repair/caps.hpp"
#include "surface/repair/fans.hpp"
#include "surface/repair/fill_holes.hpp"
#include "surface/repair/orient.hpp"
#include "surface/repair/surface_edges.hpp"
#include "surface/repair/weld.hpp"

namespace quarry {
namespace {

// A triangle that is no higher than this share of its longest edge has no extent: single precision gives no
// less.
constexpr double kFlat = 1e-6;

class Repair {
 public:
  Repair(TriangleSurface surface, const RepairOptions& options)
      : surface_(std::move(surface)), options_(options) {}

  RepairedSurface run() {
    require_points();
    weld();
    drop(degenerate(), report_.degenerate);
    drop(duplicates(), report_.duplicate);
    if (surface_.triangles.empty()) throw Error(ErrorKind::kInput, "the surface has no triangle");
    SurfaceEdges edges(surface_);
    drop(hanging(edges), report_.hanging);
    cut_caps();
    if (report_.hanging.count + report_.caps.count > 0) edges = SurfaceEdges(surface_);
    drop_unused_points();
    turn(edges);
    if (options_.fill_holes > 0) fill();
    return finish();
  }

 private:
  [[nodiscard]] Vec3 middle(const SurfaceTriangle& t) const {
    return (1.0 / 3) * (surface_.points[t[0]] + surface_.points[t[1]] + surface_.points[t[2]]);
  }

  void require_points() const {
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
      for (const std::uint32_t p : surface_.triangles[t])
        if (p >= surface_.points.size())
          throw Error(ErrorKind::kInput,
                      fmt::format("triangle {} names point {}, of {}", t + 1, p + 1, surface_.points.size()));
  }

  void weld() {
    const std::vector<std::uint32_t> first = weld_points(surface_.points, options_.weld);
    welded_.assign(first.size(), 0);
    for (std::uint32_t i = 0; i < first.size(); ++i) {
      if (first[i] == i) continue;
      welded_[i] = 1;
      report_.welded.add(surface_.points[i]);
    }
    parallel::for_each(surface_.triangles.size(), [&](std::size_t t) {
      for (std::uint32_t& p : surface_.triangles[t]) p = first[p];
    });
  }

  [[nodiscard]] std::vector<std::uint8_t> degenerate() const {
    std::vector<std::uint8_t> bad(surface_.triangles.size());
    parallel::for_each(bad.size(), [&](std::size_t i) {
      const SurfaceTriangle& t = surface_.triangles[i];
      bad[i] = t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ? 1 : 0;
    });
    return bad;
  }

  // Triangles of the same points, in any order, beyond the first.
  [[nodiscard]] std::vector<std::uint8_t> duplicates() const {
    std::vector<std::uint8_t> bad(surface_.triangles.size(), 0);
    std::vector<SurfaceTriangle> corners = surface_.triangles;
    parallel::for_each(corners.size(),
                       [&](std::size_t i) { std::sort(corners[i].begin(), corners[i].end()); });
    // By the two smallest points; the few triangles of one edge are compared one by one.
    std::vector<std::uint64_t> keys(corners.size());
    std::vector<std::uint32_t> order(corners.size());
    parallel::for_each(corners.size(), [&](std::size_t i) {
      keys[i] = (std::uint64_t{corners[i][0]} << 32) | corners[i][1];
      order[i] = static_cast<std::uint32_t>(i);
    });
    parallel::stable_sort_by_key(keys, order);
    for (std::size_t i = 1; i < order.size(); ++i)
      for (std::size_t j = i; j > 0 && keys[j - 1] == keys[i]; --j)
        if (corners[order[j - 1]] == corners[order[i]]) bad[order[i]] = 1;
    return bad;
  }

  // Triangles without extent beside their longest edge, which two others have, while nothing else has the
  // edges that lie upon it: what cutting programs leave behind. They would make the edge one in which sheets
  // meet.
  [[nodiscard]] std::vector<std::uint8_t> hanging(const SurfaceEdges& edges) const {
    std::vector<std::uint8_t> bad(surface_.triangles.size(), 0);
    parallel::for_each(bad.size(), [&](std::size_t i) {
      const SurfaceTriangle& t = surface_.triangles[i];
      std::array<double, 3> lengths;
      std::array<std::size_t, 3> uses;
      for (std::size_t k = 0; k < 3; ++k) {
        lengths[k] = length(surface_.points[t[(k + 1) % 3]] - surface_.points[t[k]]);
        uses[k] = edges.sides(edges.of_side(static_cast<std::uint32_t>(3 * i + k))).size();
      }
      const auto longest =
          static_cast<std::size_t>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
      const double height = length(doubled_area(surface_, t)) / lengths[longest];
      bad[i] = height <= kFlat * lengths[longest] && uses[longest] >= 3 && uses[(longest + 1) % 3] == 1 &&
                       uses[(longest + 2) % 3] == 1
                   ? 1
                   : 0;
    });
    return bad;
  }

  void cut_caps() {
    for (const Vec3 place : cut_at_caps(surface_)) report_.caps.add(place);
    if (report_.caps.count > 0) drop(duplicates(), report_.duplicate);
    if (surface_.triangles.empty()) throw Error(ErrorKind::kGeometry, "the surface has no area");
  }

  void drop(const std::vector<std::uint8_t>& bad, RepairCount& count) {
    for (std::size_t i = 0; i < bad.size(); ++i)
      if (bad[i] != 0) count.add(middle(surface_.triangles[i]));
    keep_triangles(surface_, [&](std::size_t t) { return bad[t] == 0; });
  }

  void drop_unused_points() {
    constexpr std::uint32_t kUnused = 0xffffffffU;
    std::vector<std::uint32_t> number(surface_.points.size(), kUnused);
    for (const SurfaceTriangle& t : surface_.triangles)
      for (const std::uint32_t p : t) number[p] = 0;
    std::uint32_t count = 0;
    for (std::size_t p = 0; p < number.size(); ++p) {
      if (number[p] == kUnused) {
        if (welded_[p] == 0) report_.unused.add(surface_.points[p]);
        continue;
      }
      number[p] = count;
      surface_.points[count++] = surface_.points[p];
    }
    surface_.points.resize(count);
    for (SurfaceTriangle& t : surface_.triangles)
      for (std::uint32_t& p : t) p = number[p];
  }

  void turn(const SurfaceEdges& edges) {
    const Orientation orientation = orient(surface_, edges);
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
      if (orientation.turn[t] == 0) continue;
      std::swap(surface_.triangles[t][1], surface_.triangles[t][2]);
      report_.turned.add(middle(surface_.triangles[t]));
    }
  }

  void fill() {
    for (const FilledHole& hole : fill_holes(surface_, options_.fill_holes)) {
      report_.filled_holes.add(surface_.points[hole.rim.front()]);
      for (const SurfaceTriangle& t : hole.triangles) {
        surface_.triangles.push_back(t);
        surface_.groups.push_back(hole.group);
      }
    }
  }

  // Counts what is left, and names the edges in which sheets meet.
  RepairedSurface finish() {
    const SurfaceEdges edges(surface_);
    RepairedSurface result;
    for (std::uint32_t e = 0; e < edges.count(); ++e) {
      const EdgeUse use = edges.use_of(surface_, e);
      if (use == EdgeUse::kRim) ++report_.open_edges;
      if (use == EdgeUse::kRim || use == EdgeUse::kInner) continue;
      const auto [a, b] = SurfaceEdges::ends(surface_, edges.sides(e)[0]);
      RepairCount& count = use == EdgeUse::kSeam ? report_.seams : report_.branches;
      count.add(0.5 * (surface_.points[a] + surface_.points[b]));
      result.joins.push_back(join_of(a, b));
    }
    for (const SurfaceTriangle& t : surface_.triangles)
      if (doubled_area(surface_, t) == Vec3()) report_.flat.add(middle(t));
    count_pinches(edges, result.joins);
    report_.holes = rims_of(surface_).size();
    result.surface = std::move(surface_);
    result.report = std::move(report_);
    return result;
  }

  // Points of several fans that lie on no join.
  void count_pinches(const SurfaceEdges& edges, const std::vector<SheetJoin>& joins) {
    constexpr std::uint32_t kNone = 0xffffffffU;
    enum : std::uint8_t { kPlain, kOnJoin, kCounted };
    std::vector<std::uint8_t> state(surface_.points.size(), kPlain);
    for (const SheetJoin& join : joins)
      for (const std::uint32_t p : join) state[p] = kOnJoin;
    Fans fans(surface_, edges);
    std::vector<std::uint32_t> fan(surface_.points.size(), kNone);
    for (std::uint32_t corner = 0; corner < 3 * surface_.triangles.size(); ++corner) {
      const std::uint32_t p = surface_.triangles[corner / 3][corner % 3];
      const std::uint32_t mine = fans.of(corner);
      if (fan[p] == kNone) fan[p] = mine;
      if (fan[p] == mine || state[p] != kPlain) continue;
      state[p] = kCounted;
      report_.pinches.add(surface_.points[p]);
    }
  }

  TriangleSurface surface_;
  RepairOptions options_;
  RepairReport report_;
  std::vector<std::uint8_t> welded_;  // by the number that a point came with: it went into another
};

}  // namespace

RepairedSurface repair_surface(TriangleSurface surface, const RepairOptions& options) {
  return Repair(std::move(surface), options).run();
}

}  // namespace quarry
