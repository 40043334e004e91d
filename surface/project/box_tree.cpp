#include "surface/project/box_tree.hpp"

#include <new>

#include <embree3/rtcore.h>

#include "engine/base/error.hpp"
#include "engine/parallel/loop_order.hpp"

namespace quarry {
namespace {

void throw_error_of(RTCDevice device) {
  switch (rtcGetDeviceError(device)) {
    case RTC_ERROR_NONE:
      return;
    case RTC_ERROR_OUT_OF_MEMORY:
      throw std::bad_alloc();
    case RTC_ERROR_UNSUPPORTED_CPU:
      throw Error(ErrorKind::kBug, "Embree: the processor lacks the instruction set that was asked for");
    default:
      throw Error(ErrorKind::kBug, "Embree refused to build the tree of boxes");
  }
}

// What the callbacks of a build need. The loop is Embree's own; its order is that of any other.
struct Build {
  std::span<const FloatBox> boxes;
  parallel::detail::LoopOrder order;
};

void bounds_of(const RTCBoundsFunctionArguments* arguments) {
  auto& build = *static_cast<Build*>(arguments->geometryUserPtr);
  const parallel::detail::LoopOrder::Chunk inside(build.order);
  const FloatBox& box = build.boxes[arguments->primID];
  RTCBounds& bounds = *arguments->bounds_o;
  bounds.lower_x = box.low[0];
  bounds.lower_y = box.low[1];
  bounds.lower_z = box.low[2];
  bounds.upper_x = box.high[0];
  bounds.upper_y = box.high[1];
  bounds.upper_z = box.high[2];
}

bool visit_point(RTCPointQueryFunctionArguments* arguments) {
  const float radius = (*static_cast<const BoxTree::Visitor*>(arguments->userPtr))(arguments->primID);
  if (!(radius < arguments->query->radius)) return false;
  arguments->query->radius = radius;
  return true;
}

struct RayContext : RTCIntersectContext {
  const BoxTree::Visitor* visit;
};

// Shortening the ray is all that tells Embree of a hit; what was hit, the visitor keeps.
void visit_ray(const RTCIntersectFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) return;
  const auto& context = *static_cast<const RayContext*>(arguments->context);
  RTCRay& ray = reinterpret_cast<RTCRayHit*>(arguments->rayhit)->ray;
  const float length = (*context.visit)(arguments->primID);
  if (length < ray.tfar) ray.tfar = length;
}

}  // namespace

struct BoxTree::Scene {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  Scene() = default;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

BoxTree::BoxTree(std::span<const FloatBox> boxes, const std::string& instruction_set)
    : scene_(std::make_unique<Scene>()) {
  // Never threads=: that would limit the whole process for as long as the device lives.
  const std::string settings = instruction_set.empty() ? "" : "isa=" + instruction_set;
  scene_->device = rtcNewDevice(settings.c_str());
  if (scene_->device == nullptr) throw_error_of(nullptr);
  scene_->scene = rtcNewScene(scene_->device);
  rtcSetSceneFlags(scene_->scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene_->scene, RTC_BUILD_QUALITY_HIGH);
  const RTCGeometry geometry = rtcNewGeometry(scene_->device, RTC_GEOMETRY_TYPE_USER);
  Build build{boxes, {}};
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
  rtcSetGeometryUserData(geometry, &build);
  rtcSetGeometryBoundsFunction(geometry, bounds_of, nullptr);
  rtcSetGeometryIntersectFunction(geometry, visit_ray);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_->scene);
  rtcSetGeometryUserData(geometry, nullptr);  // the build is over
  throw_error_of(scene_->device);
}

BoxTree::~BoxTree() = default;
BoxTree::BoxTree(BoxTree&&) noexcept = default;
BoxTree& BoxTree::operator=(BoxTree&&) noexcept = default;

void BoxTree::near(const FloatPoint& point, float radius, const Visitor& visit) const {
  RTCPointQuery query{point[0], point[1], point[2], 0, radius};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(scene_->scene, &query, &context, visit_point, const_cast<Visitor*>(&visit));
}

void BoxTree::along(const FloatPoint& origin, const FloatPoint& direction, float length,
                    const Visitor& visit) const {
  RayContext context;
  rtcInitIntersectContext(&context);
  context.visit = &visit;
  RTCRayHit ray{};
  ray.ray.org_x = origin[0];
  ray.ray.org_y = origin[1];
  ray.ray.org_z = origin[2];
  ray.ray.dir_x = direction[0];
  ray.ray.dir_y = direction[1];
  ray.ray.dir_z = direction[2];
  ray.ray.tnear = 0;
  ray.ray.tfar = length;
  ray.ray.mask = ~0U;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_->scene, &context, &ray);
}

}  // namespace quarry
