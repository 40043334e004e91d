#include "io/lines/coordinate_system.hpp"

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

}  // namespace

CoordinateSystem describe_system(std::string definition) {
  CoordinateSystem result{std::move(definition), false};
  if (result.definition.empty()) return result;
  const ProjContext context = make_proj_context();
  const ProjObject system(proj_create(context.get(), result.definition.c_str()));
  result.geographic = system && is_geographic(context.get(), system.get());
  return result;
}

}  // namespace quarry
