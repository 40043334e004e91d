#include "kernels/cleanup/patch_ring.hpp"

#include <algorithm>
#include <cassert>

namespace quarry {

std::vector<std::uint32_t> PatchRing::run(const PatchCut& cut, std::size_t from, std::size_t to) const {
  std::vector<std::uint32_t> run;
  for (std::size_t i = from; i <= to; ++i) run.push_back(ids[place(cut, i)]);
  return run;
}

std::optional<PatchCut> find_cut(const PatchRing& ring, std::uint32_t at, bool mirrored) {
  PatchCut cut{at, 0, 0, mirrored};
  // Steps to the next corner, or 0 if something else comes first.
  const auto to_corner = [&](std::size_t from) -> std::uint32_t {
    for (std::size_t i = from + 1; i < ring.size(); ++i) {
      const std::uint8_t target = ring.targets[ring.place(cut, i)];
      if (target == 1) return static_cast<std::uint32_t>(i - from);
      if (target != 2) return 0;
    }
    return 0;
  };
  cut.across = to_corner(0);
  if (cut.across == 0) return std::nullopt;
  cut.along = to_corner(cut.across);
  const std::size_t corner = cut.across + cut.along;
  const std::size_t end = corner + cut.across;
  if (cut.along == 0 || end + 2 > ring.size()) return std::nullopt;
  for (std::size_t i = corner + 1; i < end; ++i)
    if (ring.targets[ring.place(cut, i)] != 2) return std::nullopt;
  if (ring.targets[ring.place(cut, end)] < 2) return std::nullopt;
  return cut;
}

void cut_off(const PatchRing& ring, const PatchCut& cut, std::uint32_t next, PatchRing& left) {
  assert(&left != &ring);
  left.ids.clear();
  left.targets.clear();
  const std::size_t end = 2 * std::size_t{cut.across} + cut.along;
  const auto add = [&](std::size_t steps, int fewer) {
    const std::size_t at = ring.place(cut, steps);
    left.ids.push_back(ring.ids[at]);
    left.targets.push_back(static_cast<std::uint8_t>(ring.targets[at] - fewer));
  };
  // In the order of the steps: from r along the wall to q, then on to r.
  add(0, 1);
  for (std::uint32_t i = 1; i < cut.along; ++i) {
    left.ids.push_back(next++);
    left.targets.push_back(2);
  }
  add(end, 1);
  for (std::size_t i = end + 1; i < ring.size(); ++i) add(i, 0);
  if (cut.mirrored) {
    std::reverse(left.ids.begin(), left.ids.end());
    std::reverse(left.targets.begin(), left.targets.end());
  }
}

}  // namespace quarry
