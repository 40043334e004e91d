#include "surface/repair/caps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

// The height of a flat triangle by its longest edge; and the same by the largest coordinate.
constexpr double kCapHeight = 1e-10;
constexpr double kCapRounding = 4 * std::numeric_limits<double>::epsilon();
// Two points are at one place with so much of the longest edge between them.
constexpr double kTogether = 1e-6;

class CapCutter {
 public:
  explicit CapCutter(TriangleSurface& surface) : surface_(surface) {
    for (const Vec3 p : surface.points)
      precision_ = std::max({precision_, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    precision_ *= kCapRounding;
  }

  std::vector<Vec3> run() {
    std::vector<std::uint8_t> flat(surface_.triangles.size());
    parallel::for_each(flat.size(), [&](std::size_t t) { flat[t] = apex_of(surface_.triangles[t]) ? 1 : 0; });
    const auto count = std::count(flat.begin(), flat.end(), 1);
    if (count == 0 || count == std::ssize(flat)) return {};
    around_.resize(surface_.points.size());
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
      for (const std::uint32_t p : surface_.triangles[t]) around_[p].push_back(t);
    // What is cut may be flat too: the longest edge of a flat one is longer than those of its parts.
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
      const SurfaceTriangle corners = surface_.triangles[t];
      if (corners == kGone) continue;
      if (const auto apex = apex_of(corners)) cut(t, *apex);
    }
    keep_triangles(surface_, [&](std::size_t t) { return surface_.triangles[t] != kGone; });
    return std::move(places_);
  }

 private:
  static constexpr SurfaceTriangle kGone = {0, 0, 0};

  // The corner across the longest edge, of a flat triangle.
  [[nodiscard]] std::optional<std::size_t> apex_of(const SurfaceTriangle& t) const {
    std::array<double, 3> across;
    for (std::size_t k = 0; k < 3; ++k)
      across[k] = length(surface_.points[t[(k + 2) % 3]] - surface_.points[t[(k + 1) % 3]]);
    const auto [shortest, longest] = std::minmax_element(across.begin(), across.end());
    const bool flat =
        length(doubled_area(surface_, t)) <= *longest * std::max(kCapHeight * *longest, precision_);
    if (!flat || *shortest <= std::max(kTogether * *longest, precision_)) return std::nullopt;
    return static_cast<std::size_t>(longest - across.begin());
  }

  void cut(std::uint32_t cap, std::size_t apex) {
    const SurfaceTriangle corners = surface_.triangles[cap];
    const std::uint32_t c = corners[apex], a = corners[(apex + 1) % 3], b = corners[(apex + 2) % 3];
    remove(cap);
    places_.push_back(surface_.points[c]);
    const std::vector<std::uint32_t> at_a = around_[a];
    for (const std::uint32_t t : at_a) {
      const SurfaceTriangle whole = surface_.triangles[t];
      if (std::find(whole.begin(), whole.end(), b) == whole.end()) continue;
      remove(t);
      if (std::find(whole.begin(), whole.end(), c) != whole.end()) continue;  // flat too, the other way round
      for (const std::uint32_t gone : {a, b}) {
        SurfaceTriangle part = whole;
        std::replace(part.begin(), part.end(), gone, c);
        add(part, surface_.groups[t]);
      }
    }
  }

  void remove(std::uint32_t t) {
    for (const std::uint32_t p : surface_.triangles[t]) std::erase(around_[p], t);
    surface_.triangles[t] = kGone;
  }

  void add(const SurfaceTriangle& corners, std::int32_t group) {
    for (const std::uint32_t p : corners)
      around_[p].push_back(static_cast<std::uint32_t>(surface_.triangles.size()));
    surface_.triangles.push_back(corners);
    surface_.groups.push_back(group);
  }

  TriangleSurface& surface_;
  double precision_ = 0;
  std::vector<std::vector<std::uint32_t>> around_;  // triangles, by point
  std::vector<Vec3> places_;
};

}  // namespace

std::vector<Vec3> cut_at_caps(TriangleSurface& surface) { return CapCutter(surface).run(); }

}  // namespace quarry
