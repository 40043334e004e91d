#include "kernels/cleanup/patch_layout.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace quarry {
namespace {

std::vector<std::uint32_t> reversed(std::span<const std::uint32_t> chain) {
  return {chain.rbegin(), chain.rend()};
}

}  // namespace

void PatchLayout::build(const PatchFill& fill, std::uint32_t rim, std::span<const PatchCut> cuts,
                        std::span<const std::uint32_t> corners) {
  rim_ = vertices_ = rim;
  centre_ = {};
  quads_.clear();
  lines_.clear();
  grids_.clear();
  chains_.clear();
  grid_ids_.clear();
  ring_.ids.resize(rim);
  std::iota(ring_.ids.begin(), ring_.ids.end(), 0U);
  ring_.targets.assign(rim, 0);
  for (const PatchCut& cut : cuts) add_cut(cut);
  std::vector<Chain> sides;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sides.push_back(side_chain(corners, (i + fill.first) % corners.size()));
  switch (fill.kind) {
    case FillKind::kGrid:
      add_grid(sides[0], reversed(sides[2]), reversed(sides[3]), sides[1]);
      break;
    case FillKind::kPair:
      add_pair(fill, sides);
      break;
    default:
      add_star(sides, std::span(fill.spokes).first(sides.size()));
  }
}

void PatchLayout::add_cut(const PatchCut& cut) {
  const std::size_t first = cut.across, second = first + cut.along, end = second + cut.across;
  const Chain near = ring_.run(cut, 0, first), side = ring_.run(cut, first, second),
              far = ring_.run(cut, second, end);
  const std::uint32_t next = vertices_;
  const Chain wall = new_line(near.front(), far.back(), cut.along);
  if (cut.mirrored)
    add_grid(reversed(near), far, side, wall);
  else
    add_grid(near, reversed(far), wall, side);
  cut_off(ring_, cut, next, left_);
  std::swap(ring_, left_);
}

PatchLayout::Chain PatchLayout::side_chain(std::span<const std::uint32_t> corners, std::size_t side) const {
  const std::size_t end = corners[(side + 1) % corners.size()];
  std::size_t at = corners[side];
  Chain chain{ring_.ids[at]};
  do {
    at = (at + 1) % ring_.size();
    chain.push_back(ring_.ids[at]);
  } while (at != end);
  return chain;
}

PatchLayout::Chain PatchLayout::new_line(std::uint32_t from, std::uint32_t to, std::uint32_t edges) {
  Chain chain{from};
  for (std::uint32_t i = 1; i < edges; ++i) chain.push_back(vertices_++);
  chain.push_back(to);
  if (edges > 1) {
    lines_.push_back({static_cast<std::uint32_t>(chains_.size()), edges + 1});
    chains_.insert(chains_.end(), chain.begin(), chain.end());
  }
  return chain;
}

// bottom and top run from left to right, left and right from bottom to top.
void PatchLayout::add_grid(std::span<const std::uint32_t> bottom, std::span<const std::uint32_t> top,
                           std::span<const std::uint32_t> left, std::span<const std::uint32_t> right) {
  assert(bottom.size() == top.size() && left.size() == right.size());
  const std::size_t columns = bottom.size() - 1;
  const std::size_t rows = left.size() - 1;
  const std::size_t begin = grid_ids_.size();
  grid_ids_.insert(grid_ids_.end(), bottom.begin(), bottom.end());
  for (std::size_t row = 1; row < rows; ++row) {
    grid_ids_.push_back(left[row]);
    for (std::size_t column = 1; column < columns; ++column) grid_ids_.push_back(vertices_++);
    grid_ids_.push_back(right[row]);
  }
  grid_ids_.insert(grid_ids_.end(), top.begin(), top.end());
  grids_.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(columns),
                    static_cast<std::uint32_t>(rows)});
  const auto id = [&](std::size_t column, std::size_t row) {
    return grid_ids_[begin + row * (columns + 1) + column];
  };
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column)
      quads_.push_back({id(column, row), id(column + 1, row), id(column + 1, row + 1), id(column, row + 1)});
}

// Each corner quad of the star is a grid between two half sides and two spokes.
void PatchLayout::add_star(std::span<const Chain> sides, std::span<const std::uint32_t> spokes) {
  const std::size_t n = sides.size();
  const std::uint32_t centre = vertices_++;
  centre_ = {centre, {}, static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(lines_.size())};
  std::vector<Chain> lines;
  for (std::size_t i = 0; i < n; ++i) {
    centre_.ends[i] = sides[i][spokes[(i + n - 1) % n]];
    lines.push_back(new_line(centre_.ends[i], centre, spokes[i]));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n;
    const Chain back = reversed(sides[before]);
    add_grid(std::span(sides[i]).first(spokes[before] + 1), lines[before],
             std::span(back).first(spokes[i] + 1), lines[i]);
  }
}

void PatchLayout::add_pair(const PatchFill& fill, std::span<const Chain> sides) {
  const Chain& near = sides[0];
  const Chain far = reversed(sides[2]);
  const std::size_t split = fill.split;
  const std::size_t rest = near.size() - 1 - split;  // edges of the second grid along the near side
  const std::size_t far_end = far.size() - 1 - rest;
  const Chain left = reversed(sides[3]);
  const Chain& right = sides[1];
  const auto edges = [](const Chain& chain) { return static_cast<std::uint32_t>(chain.size() - 1); };
  const Chain first_wall = new_line(near[split], far[split], edges(left));
  const Chain second_wall = new_line(near[split], far[far_end], edges(right));
  add_grid(std::span(near).first(split + 1), std::span(far).first(split + 1), left, first_wall);
  add_grid(std::span(near).subspan(split), std::span(far).subspan(far_end), second_wall, right);
  const std::array<Chain, 3> between = {
      second_wall, reversed(std::span(far).subspan(split, far_end - split + 1)), reversed(first_wall)};
  add_star(between, std::span(fill.spokes).first(3));
}

}  // namespace quarry
