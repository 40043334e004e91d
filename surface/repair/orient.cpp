#include "surface/repair/orient.hpp"

namespace quarry {
namespace {

class Orienter {
 public:
  Orienter(const TriangleSurface& surface, const SurfaceEdges& edges)
      : surface_(surface), edges_(edges), seen_(surface.triangles.size(), 0) {
    result_.turn.assign(surface.triangles.size(), 0);
  }

  Orientation run() {
    for (std::uint32_t t = 0; t < seen_.size(); ++t)
      if (seen_[t] == 0) spread(t);
    for (std::uint32_t e = 0; e < edges_.count(); ++e)
      if (edges_.sides(e).size() == 2 && !agree(edges_.sides(e)[0], edges_.sides(e)[1]))
        result_.conflicts.push_back(e);
    return std::move(result_);
  }

 private:
  // Two sides of one edge agree if they run in opposite directions, or in one and one of them is turned.
  [[nodiscard]] bool agree(std::uint32_t a, std::uint32_t b) const {
    const bool same_way = SurfaceEdges::ends(surface_, a).first == SurfaceEdges::ends(surface_, b).first;
    return same_way == (result_.turn[a / 3] != result_.turn[b / 3]);
  }

  // Breadth first: the cut of a one-sided surface is then about as short as can be.
  void spread(std::uint32_t first) {
    part_.assign(1, first);
    seen_[first] = 1;
    std::size_t turned = 0;
    for (std::size_t i = 0; i < part_.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t side = 3 * part_[i] + k;
        const auto sides = edges_.sides(edges_.of_side(side));
        if (sides.size() != 2) continue;
        const std::uint32_t across = sides[0] == side ? sides[1] : sides[0];
        if (seen_[across / 3] != 0) continue;
        seen_[across / 3] = 1;
        if (!agree(side, across)) {
          result_.turn[across / 3] = 1;
          ++turned;
        }
        part_.push_back(across / 3);
      }
    }
    if (2 * turned > part_.size())
      for (const std::uint32_t t : part_) result_.turn[t] ^= 1;
  }

  const TriangleSurface& surface_;
  const SurfaceEdges& edges_;
  std::vector<std::uint8_t> seen_;
  std::vector<std::uint32_t> part_;
  Orientation result_;
};

}  // namespace

Orientation orient(const TriangleSurface& surface, const SurfaceEdges& edges) {
  return Orienter(surface, edges).run();
}

}  // namespace quarry
