#include "surface/join/coarsen_joins.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "engine/geometry/space_segment.hpp"

namespace quarry {
namespace {

// The cosine of the turn that a triangle may make.
constexpr double kLeastTurnCosine = 0.5;

class JoinCoarsener {
 public:
  JoinCoarsener(RepairedSurface& repaired, std::span<const std::uint8_t> kept, double deviation)
      : surface_(repaired.surface),
        repaired_(repaired),
        kept_(kept),
        deviation_(deviation),
        around_(surface_.points.size()) {
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
      for (const std::uint32_t p : surface_.triangles[t]) around_[p].push_back(t);
    for (const SheetJoin& join : repaired.joins) {
      passed_[join] = {};
      for (std::size_t k = 0; k < 2; ++k) along_[join[k]].push_back(join[1 - k]);
    }
  }

  std::uint64_t run() {
    for (const auto& [join, passed] : passed_) enqueue(join);
    std::uint64_t collapses = 0;
    while (!queue_.empty()) {
      const SheetJoin join = queue_.begin()->second;
      queue_.erase(queue_.begin());
      if (passed_.count(join) == 0) continue;
      if (collapse(join[0], join[1]) || collapse(join[1], join[0])) ++collapses;
    }
    finish();
    return collapses;
  }

 private:
  [[nodiscard]] Vec3 point(std::uint32_t p) const { return surface_.points[p]; }

  void enqueue(const SheetJoin& join) {
    if (kept_[join[0]] == 0 || kept_[join[1]] == 0)
      queue_.insert({length(point(join[1]) - point(join[0])), join});
  }

  [[nodiscard]] std::set<std::uint32_t> neighbours(std::uint32_t p) const {
    std::set<std::uint32_t> found;
    for (const std::uint32_t t : around_[p])
      for (const std::uint32_t q : surface_.triangles[t])
        if (q != p) found.insert(q);
    return found;
  }

  [[nodiscard]] bool has(std::uint32_t triangle, std::uint32_t p) const {
    const SurfaceTriangle& corners = surface_.triangles[triangle];
    return std::find(corners.begin(), corners.end(), p) != corners.end();
  }

  // Moves a point of a join into its neighbour along it.
  bool collapse(std::uint32_t gone, std::uint32_t kept) {
    const std::vector<std::uint32_t>& along = along_[gone];
    if (kept_[gone] != 0 || along[0] == along[1]) return false;
    const std::uint32_t before = along[0] == kept ? along[1] : along[0];
    const SheetJoin fresh = join_of(before, kept);
    std::vector<std::uint32_t> passed = passed_[join_of(before, gone)];
    const std::vector<std::uint32_t>& more = passed_[join_of(gone, kept)];
    passed.insert(passed.end(), more.begin(), more.end());
    passed.push_back(gone);
    if (!keeps_curve(before, kept, passed) || !may_collapse(gone, kept)) return false;
    if (neighbours(before).count(kept) > 0) return false;
    apply(gone, kept);
    passed_.erase(join_of(before, gone));
    passed_.erase(join_of(gone, kept));
    passed_[fresh] = std::move(passed);
    std::replace(along_[before].begin(), along_[before].end(), gone, kept);
    std::replace(along_[kept].begin(), along_[kept].end(), gone, before);
    along_[gone].clear();
    enqueue(fresh);
    return true;
  }

  [[nodiscard]] bool keeps_curve(std::uint32_t a, std::uint32_t b,
                                 const std::vector<std::uint32_t>& passed) const {
    return std::all_of(passed.begin(), passed.end(), [&](std::uint32_t p) {
      return length(point(p) - closest_on_segment(point(p), point(a), point(b))) <= deviation_;
    });
  }

  // Common neighbours are those of the triangles that vanish, and all others turn little and keep an area.
  [[nodiscard]] bool may_collapse(std::uint32_t gone, std::uint32_t kept) const {
    const auto of_kept = neighbours(kept);
    std::set<std::uint32_t> opposite;
    for (const std::uint32_t t : around_[gone]) {
      SurfaceTriangle corners = surface_.triangles[t];
      if (has(t, kept)) {
        for (const std::uint32_t p : corners)
          if (p != gone && p != kept) opposite.insert(p);
        continue;
      }
      const Vec3 was = doubled_area(surface_, corners);
      std::replace(corners.begin(), corners.end(), gone, kept);
      const Vec3 now = doubled_area(surface_, corners);
      if (!(length(now) > 0) || dot(was, now) < kLeastTurnCosine * length(was) * length(now)) return false;
    }
    for (const std::uint32_t p : neighbours(gone))
      if (p != kept && of_kept.count(p) > 0 && opposite.count(p) == 0) return false;
    return true;
  }

  void apply(std::uint32_t gone, std::uint32_t kept) {
    for (const std::uint32_t t : around_[gone]) {
      SurfaceTriangle& corners = surface_.triangles[t];
      if (has(t, kept)) {
        for (const std::uint32_t p : corners)
          if (p != gone) std::erase(around_[p], t);
        corners = {kGone, kGone, kGone};
      } else {
        std::replace(corners.begin(), corners.end(), gone, kept);
        around_[kept].push_back(t);
      }
    }
    around_[gone].clear();
  }

  void finish() {
    keep_triangles(surface_, [&](std::size_t t) { return surface_.triangles[t][0] != kGone; });
    repaired_.joins.clear();
    for (const auto& [join, passed] : passed_) repaired_.joins.push_back(join);
  }

  static constexpr std::uint32_t kGone = 0xffffffffU;

  TriangleSurface& surface_;
  RepairedSurface& repaired_;
  std::span<const std::uint8_t> kept_;
  double deviation_;
  std::vector<std::vector<std::uint32_t>> around_;             // triangles, by point
  std::map<SheetJoin, std::vector<std::uint32_t>> passed_;     // the joins, and the points that were on them
  std::map<std::uint32_t, std::vector<std::uint32_t>> along_;  // the points that joins lead to
  std::set<std::pair<double, SheetJoin>> queue_;               // by length
};

}  // namespace

std::uint64_t coarsen_joins(RepairedSurface& repaired, std::span<const std::uint8_t> kept, double deviation) {
  return JoinCoarsener(repaired, kept, deviation).run();
}

}  // namespace quarry
