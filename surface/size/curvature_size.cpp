#include "surface/size/curvature_size.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/parallel/parallel.hpp"
#include "surface/model/corner_normals.hpp"

namespace quarry {

std::vector<double> curvature_sizes(const Mesh& triangles, const ConstraintTags& tags,
                                    const CurvatureOptions& options) {
  const std::vector<CornerNormals> normals = corner_normals(triangles, tags);
  const auto curvature_along = [&](SideId s) {
    const SideId next = triangles.next(s);
    const CornerNormals& own = normals[s.face().value()];
    const Vec3 turn = own[static_cast<std::size_t>(next.index())] - own[static_cast<std::size_t>(s.index())];
    const double size =
        length(triangles.point3(triangles.origin(next)) - triangles.point3(triangles.origin(s)));
    return size > 0 ? length(turn) / size : 0.0;
  };
  std::vector<double> sizes(triangles.vertex_slots(), std::numeric_limits<double>::infinity());
  parallel::for_each(sizes.size(), [&](std::size_t i) {
    const VertexId v(i);
    if (!triangles.alive(v)) return;
    double curvature = 0;
    for_each_side_around(triangles, v, [&](SideId s) {
      curvature = std::max({curvature, curvature_along(s), curvature_along(triangles.previous(s))});
    });
    if (!(curvature > 0)) return;
    const double size = std::sqrt(8 * options.error / curvature);
    if (size < options.edge) sizes[i] = std::max(size, options.smallest * options.edge);
  });
  return sizes;
}

}  // namespace quarry
