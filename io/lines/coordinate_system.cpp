#include "io/lines/coordinate_system.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/lines/proj_context.hpp"

namespace quarry {
namespace {

bool is_geographic(PJ_CONTEXT* context, const PJ* system) {
  switch (proj_get_type(system)) {
    case PJ_TYPE_GEOGRAPHIC_2D_CRS:
    case PJ_TYPE_GEOGRAPHIC_3D_CRS:
      return true;
    // With heights, or with a shift to WGS 84: what they are made on.
    case PJ_TYPE_BOUND_CRS: {
      const ProjObject source(proj_get_source_crs(context, system));
      return source && is_geographic(context, source.get());
    }
    case PJ_TYPE_COMPOUND_CRS: {
      const ProjObject plane(proj_crs_get_sub_crs(context, system, 0));
      return plane && is_geographic(context, plane.get());
    }
    default:
      return false;
  }
}

// Decimals that survey coordinates in metres have.
constexpr double kFewDecimals = 1000;

bool has_many_decimals(double value) {
  const double scaled = value * kFewDecimals;
  return std::abs(scaled - std::round(scaled)) > 1e-6;
}

}  // namespace

CoordinateSystem describe_system(std::string definition) {
  CoordinateSystem result{std::move(definition)};
  if (result.definition.empty()) return result;
  const ProjContext context = make_proj_context();
  const ProjObject system(proj_create(context.get(), result.definition.c_str()));
  result.geographic = system && is_geographic(context.get(), system.get());
  return result;
}

bool same_system(const std::string& a, const std::string& b) {
  if (a == b) return true;
  const ProjContext context = make_proj_context();
  const ProjObject first(proj_create(context.get(), a.c_str())),
      second(proj_create(context.get(), b.c_str()));
  return first && second &&
         proj_is_equivalent_to_with_ctx(context.get(), first.get(), second.get(),
                                        PJ_COMP_EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS) != 0;
}

std::string system_urn(const std::string& definition) {
  const ProjContext context = make_proj_context();
  ProjObject system(definition.empty() ? nullptr : proj_create(context.get(), definition.c_str()));
  if (!system) return {};
  if (proj_get_id_code(system.get(), 0) == nullptr) {
    // What GDAL takes for the same system.
    constexpr int kSure = 90;
    int* confidences = nullptr;
    PJ_OBJ_LIST* const found = proj_identify(context.get(), system.get(), "EPSG", nullptr, &confidences);
    const bool sure = found != nullptr && proj_list_get_count(found) > 0 && confidences[0] >= kSure;
    system.reset(sure ? proj_list_get(context.get(), found, 0) : nullptr);
    proj_list_destroy(found);
    proj_int_list_destroy(confidences);
    if (!system) return {};
  }
  const std::string authority = proj_get_id_auth_name(system.get(), 0);
  return "urn:ogc:def:crs:" + authority + (authority == "OGC" ? ":1.3:" : "::") +
         proj_get_id_code(system.get(), 0);
}

bool look_like_degrees(const LineSet& lines, std::uint32_t file) {
  Box2 box;
  bool fine = false;
  const auto look_at = [&](Vec2 p) {
    box.extend(p);
    fine = fine || has_many_decimals(p.x) || has_many_decimals(p.y);
  };
  for (const InputLine& line : lines.lines)
    if (line.file == file) std::ranges::for_each(line.points, look_at);
  for (const InputPoint& point : lines.points)
    if (point.file == file) look_at(point.place);
  if (!fine || box.low.x < -180 || box.high.x > 180 || box.low.y < -90 || box.high.y > 90) return false;
  const double x = std::clamp(0.0, box.low.x, box.high.x), y = std::clamp(0.0, box.low.y, box.high.y);
  return std::hypot(x, y) >= 2 * box.longer_side();
}

}  // namespace quarry
