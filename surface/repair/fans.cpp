#include "surface/repair/fans.hpp"

#include <algorithm>
#include <numeric>

namespace quarry {
namespace {

std::uint32_t target(std::uint32_t side) { return side - side % 3 + (side + 1) % 3; }

}  // namespace

Fans::Fans(const TriangleSurface& surface, const SurfaceEdges& edges) : root_(3 * surface.triangles.size()) {
  std::iota(root_.begin(), root_.end(), 0U);
  for (std::size_t e = 0; e < edges.count(); ++e) {
    if (edges.use_of(surface, e) != EdgeUse::kInner) continue;
    const std::uint32_t a = edges.sides(e)[0];
    const std::uint32_t b = edges.sides(e)[1];
    join(a, target(b));
    join(target(a), b);
  }
}

std::uint32_t Fans::of(std::uint32_t corner) {
  while (root_[corner] != corner) corner = root_[corner] = root_[root_[corner]];
  return corner;
}

void Fans::join(std::uint32_t a, std::uint32_t b) {
  a = of(a);
  b = of(b);
  root_[std::max(a, b)] = std::min(a, b);
}

}  // namespace quarry
