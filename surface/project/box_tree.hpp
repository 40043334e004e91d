// A bounding volume hierarchy of boxes, four children a node, built by Embree (which is named nowhere else)
// and searched here: Embree's own point queries call back for every triangle, and took twice as long. It
// finds candidates; what is in the boxes, and how exactly it is judged, only the caller knows. Its shape and
// the order of visits may depend on the processor, so no result may depend on them.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "surface/project/float_frame.hpp"
#include "surface/project/lanes.hpp"

namespace quarry {

class BoxTree {
 public:
  // Boxes that are visited together, by their numbers; kNone in the places left over.
  static constexpr std::size_t kBlockSize = 2;
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  using Block = std::array<std::uint32_t, kBlockSize>;

  // instruction_set: "sse2", "sse4.2", "avx", "avx2" or "avx512" of those that the processor has, for the
  // build; empty: the best one. Built in parallel by the threads at hand; starts none and limits none. At
  // most 2^31 boxes. Throws std::bad_alloc, or Error(kBug) if Embree refuses.
  explicit BoxTree(std::span<const FloatBox> boxes, const std::string& instruction_set = {});

  // Each box is in one block. Blocks that are near in space are near in number.
  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }

  // Calls visit(block) for each block with a box within the radius of the point, and for some others. visit
  // returns the radius from then on, which never grows.
  template <class Visit>
  void visit_near(const FloatPoint& point, float radius, Visit&& visit) const;

  // Calls visit(block) for each block with a box that the segment origin + [0, length] * direction meets, and
  // for some others; direction has a length of about 1. Rounding may make it miss a box that it meets by less
  // than FloatFrame::kRayMargin. visit returns the length from then on, which never grows.
  template <class Visit>
  void visit_along(const FloatPoint& origin, const FloatPoint& direction, float length, Visit&& visit) const;

 private:
  struct BuildNode;
  struct Callbacks;

  // A node, or with this bit a block.
  static constexpr std::uint32_t kBlockBit = std::uint32_t{1} << 31;
  static constexpr int kMostLevels = 64;
  static constexpr std::size_t kScratch = 3 * kMostLevels + 1;

  struct alignas(64) Node {
    std::array<Float4, 3> low, high;  // by axis; a lane a child
    std::array<std::uint32_t, 4> child;
  };

  // What is still to be visited, the nearest on top. Each entry is a distance, as the bits of a float that is
  // not negative, above a child: entries compare as distances do.
  struct Stack {
    std::array<std::uint64_t, kScratch + 1> entries;  // the last one takes what is not wanted
    std::size_t size = 0;

    static float distance_of(std::uint64_t entry) {
      return std::bit_cast<float>(static_cast<std::uint32_t>(entry >> 32));
    }
    void push_children(const Node& node, const Float4& distances, float limit);
    // The next one within the limit.
    bool pop(float limit, std::uint64_t& entry) {
      while (size > 0) {
        entry = entries[--size];
        if (distance_of(entry) <= limit) return true;
      }
      return false;
    }
  };

  std::uint32_t flatten(const BuildNode& node, int level);
  // Has the nodes on top of the stack brought into the cache while others are looked at.
  void fetch(const Stack& stack, std::size_t first) const {
    for (std::size_t i = first; i < stack.size; ++i) {
      const auto child = static_cast<std::uint32_t>(stack.entries[i]);
      if ((child & kBlockBit) != 0) continue;
      __builtin_prefetch(&nodes_[child].low);
      __builtin_prefetch(&nodes_[child].high[1]);  // the second line
    }
  }

  std::vector<Node> nodes_;
  std::vector<Block> blocks_;
  std::uint32_t root_ = kBlockBit;
};

// Those within the limit, sorted. Without branches, which nobody could predict.
inline void BoxTree::Stack::push_children(const Node& node, const Float4& distances, float limit) {
  std::array<std::uint64_t, 4> sorted;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    sorted[i] = std::uint64_t{std::bit_cast<std::uint32_t>(distances[i])} << 32 | node.child[i];
    count += distances[i] <= limit ? 1 : 0;
  }
  const auto order = [&](std::size_t i, std::size_t j) {
    const std::uint64_t low = sorted[i] < sorted[j] ? sorted[i] : sorted[j];
    sorted[j] = sorted[i] < sorted[j] ? sorted[j] : sorted[i];
    sorted[i] = low;
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  for (std::size_t i = 0; i < 4; ++i) entries[i < count ? size + count - 1 - i : kScratch] = sorted[i];
  size += count;
}

template <class Visit>
void BoxTree::visit_near(const FloatPoint& point, float radius, Visit&& visit) const {
  const Float4 zero{};
  const std::array<Float4, 3> p{zero + point[0], zero + point[1], zero + point[2]};
  const auto squared_distances = [&](const Node& node) {
    Float4 sum = zero;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Float4 below = node.low[axis] - p[axis], above = p[axis] - node.high[axis];
      const Float4 farther = below > above ? below : above;
      const Float4 outside = farther > zero ? farther : zero;
      sum += outside * outside;
    }
    return sum;
  };
  float limit = radius * radius;
  Stack stack;
  std::uint64_t entry = root_;
  do {
    const auto child = static_cast<std::uint32_t>(entry);
    if ((child & kBlockBit) == 0) {
      const std::size_t below_children = stack.size;
      stack.push_children(nodes_[child], squared_distances(nodes_[child]), limit);
      fetch(stack, below_children);
    } else {
      const float shorter = visit(child & ~kBlockBit);
      limit = shorter * shorter;
    }
  } while (stack.pop(limit, entry));
}

template <class Visit>
void BoxTree::visit_along(const FloatPoint& origin, const FloatPoint& direction, float length,
                          Visit&& visit) const {
  constexpr float kSmallest = 1e-18F;  // so that no inverse is infinite
  const Float4 zero{};
  std::array<Float4, 3> from, inverse;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    from[axis] = zero + origin[axis];
    inverse[axis] = zero + 1 / (std::abs(direction[axis]) < kSmallest ? kSmallest : direction[axis]);
  }
  constexpr float kMissed = std::numeric_limits<float>::infinity();
  const auto entries = [&](const Node& node, float limit) {
    Float4 enter = zero, leave = zero + limit;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Float4 low = (node.low[axis] - from[axis]) * inverse[axis];
      const Float4 high = (node.high[axis] - from[axis]) * inverse[axis];
      const Float4 first = low < high ? low : high, last = low < high ? high : low;
      enter = first > enter ? first : enter;
      leave = last < leave ? last : leave;
    }
    return enter <= leave ? enter : zero + kMissed;
  };
  Stack stack;
  std::uint64_t entry = root_;
  do {
    const auto child = static_cast<std::uint32_t>(entry);
    if ((child & kBlockBit) == 0)
      stack.push_children(nodes_[child], entries(nodes_[child], length), length);
    else
      length = visit(child & ~kBlockBit);
  } while (stack.pop(length, entry));
}

}  // namespace quarry
