#include "surface/project/box_tree.hpp"

#include <new>

#include <embree3/rtcore.h>

#include "engine/base/error.hpp"
#include "engine/parallel/loop_order.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

class Device {
 public:
  explicit Device(const std::string& instruction_set)
      // Never threads=: that would limit the whole process for as long as the device lives.
      : device_(rtcNewDevice(instruction_set.empty() ? "" : ("isa=" + instruction_set).c_str())) {
    if (device_ == nullptr) throw_error();
    bvh_ = rtcNewBVH(device_);
  }
  ~Device() {
    rtcReleaseBVH(bvh_);
    rtcReleaseDevice(device_);
  }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  [[nodiscard]] RTCBVH bvh() const { return bvh_; }

  [[noreturn]] void throw_error() const {
    const RTCError error = rtcGetDeviceError(device_);
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    throw Error(ErrorKind::kBug, error == RTC_ERROR_UNSUPPORTED_CPU
                                     ? "Embree: the processor lacks the instruction set that was asked for"
                                     : "Embree refused to build the tree of boxes");
  }

 private:
  RTCDevice device_ = nullptr;
  RTCBVH bvh_ = nullptr;
};

std::vector<RTCBuildPrimitive> primitives_of(std::span<const FloatBox> boxes) {
  std::vector<RTCBuildPrimitive> primitives(boxes.size());
  parallel::for_each(boxes.size(), [&](std::size_t i) {
    const auto& [low, high] = boxes[i];
    primitives[i] = {low[0], low[1], low[2], 0, high[0], high[1], high[2], static_cast<unsigned>(i)};
  });
  return primitives;
}

}  // namespace

// As Embree builds them, in its own memory: an inner node if it has children, else a block.
struct BoxTree::BuildNode {
  unsigned child_count = 0;
  std::array<const BuildNode*, 4> children{};
  std::array<RTCBounds, 4> bounds{};
  Block block{};
};

// Called by Embree on many threads at once.
struct BoxTree::Callbacks {
  static BuildNode* make(RTCThreadLocalAllocator allocator) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(BuildNode), alignof(BuildNode))) BuildNode;
  }
  static void* create_node(RTCThreadLocalAllocator allocator, unsigned, void*) { return make(allocator); }
  static void set_children(void* node, void** children, unsigned count, void*) {
    auto& parent = *static_cast<BuildNode*>(node);
    parent.child_count = count;
    for (unsigned i = 0; i < count; ++i) parent.children[i] = static_cast<const BuildNode*>(children[i]);
  }
  static void set_bounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i) static_cast<BuildNode*>(node)->bounds[i] = *bounds[i];
  }
  static void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives,
                           std::size_t count, void*) {
    BuildNode* leaf = make(allocator);
    leaf->block.fill(kNone);
    for (std::size_t i = 0; i < count; ++i) leaf->block[i] = primitives[i].primID;
    return leaf;
  }

  static const BuildNode* build(RTCBVH bvh, std::vector<RTCBuildPrimitive>& primitives) {
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.maxBranchingFactor = 4;
    arguments.maxDepth = kMostLevels;
    arguments.maxLeafSize = kBlockSize;
    arguments.bvh = bvh;
    arguments.primitives = primitives.data();
    arguments.primitiveCount = primitives.size();
    arguments.primitiveArrayCapacity = primitives.size();
    arguments.createNode = create_node;
    arguments.setNodeChildren = set_children;
    arguments.setNodeBounds = set_bounds;
    arguments.createLeaf = create_leaf;
    return static_cast<const BuildNode*>(rtcBuildBVH(&arguments));
  }
};

BoxTree::BoxTree(std::span<const FloatBox> boxes, const std::string& instruction_set) {
  // The first block is empty: what a node without four children has in their place.
  blocks_.emplace_back().fill(kNone);
  if (boxes.empty()) return;
  const Device device(instruction_set);
  std::vector<RTCBuildPrimitive> primitives = primitives_of(boxes);
  const BuildNode* root = nullptr;
  const auto build = [&] { root = Callbacks::build(device.bvh(), primitives); };
#ifdef QUARRY_THREAD_SANITIZER
  // It cannot see into Embree's library, and would report each of its tasks.
  parallel::with_threads(1, build);
#else
  build();
#endif
  if (root == nullptr) device.throw_error();
  root_ = flatten(*root, 0);
}

// Depth first: as deep as the tree, which Embree bounds.
std::uint32_t BoxTree::flatten(const BuildNode& node, int level) {
  if (level > kMostLevels) throw Error(ErrorKind::kBug, "Embree built a tree of boxes that is too deep");
  if (node.child_count == 0) {
    blocks_.push_back(node.block);
    return kBlockBit | static_cast<std::uint32_t>(blocks_.size() - 1);
  }
  const std::size_t at = nodes_.size();
  nodes_.emplace_back();
  for (std::size_t i = 0; i < 4; ++i) {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    RTCBounds bounds{kFar, kFar, kFar, 0, -kFar, -kFar, -kFar, 0};
    std::uint32_t child = kBlockBit;
    if (i < node.child_count) {
      bounds = node.bounds[i];
      child = flatten(*node.children[i], level + 1);
    }
    Node& made = nodes_[at];
    made.child[i] = child;
    made.low[0][i] = bounds.lower_x;
    made.low[1][i] = bounds.lower_y;
    made.low[2][i] = bounds.lower_z;
    made.high[0][i] = bounds.upper_x;
    made.high[1][i] = bounds.upper_y;
    made.high[2][i] = bounds.upper_z;
  }
  return static_cast<std::uint32_t>(at);
}

}  // namespace quarry
