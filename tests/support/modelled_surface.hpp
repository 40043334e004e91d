// What a job on a surface projects to, made from triangles alone.
#pragma once

#include <utility>

#include "surface/feature/bind.hpp"
#include "surface/model/surface_model.hpp"
#include "surface/repair/sheets.hpp"

namespace quarry::test {

struct ModelledSurface {
  Mesh mesh;
  SurfaceModel model;
};

// Repaired, with its features as the defaults find them.
inline ModelledSurface modelled(TriangleSurface surface) {
  const RepairedSurface repaired = repair_surface(std::move(surface), {});
  const CurveNetwork network =
      make_curve_network(repaired.surface, find_feature_edges(repaired, {}).edges, {});
  Mesh mesh = make_sheets(repaired);
  const ConstraintTags tags = bind_features(mesh, network);
  SurfaceModel model(mesh, tags);
  return {std::move(mesh), std::move(model)};
}

}  // namespace quarry::test
