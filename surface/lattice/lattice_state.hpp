// What the steps that turn triangles on a surface into a lattice share.
#pragma once

#include <cmath>

#include "surface/remesh/state.hpp"

namespace quarry {

struct LatticeState {
  RemeshState& base;          // the wanted edge there is the spacing of the lattice
  Tag<VertexId, Vec3> place;  // the lattice point of each vertex
  Tag<VertexId, Vec3> along;  // a direction of the lattice; zero on features

  // Whether two vertices have the same lattice point, as seen from those of them that are on no feature; of
  // two on features, whether the points are nearer to one another than to others.
  [[nodiscard]] bool share_point(VertexId a, VertexId b) const {
    const Vec3 d = place[b] - place[a];
    const double half = 0.5 * base.wanted_edge(a, b);
    bool seen = false;
    for (const VertexId v : {a, b}) {
      const Vec3 e = along[v];
      if (e == Vec3()) continue;
      seen = true;
      if (std::abs(dot(d, e)) >= half || std::abs(dot(d, cross(base.normals[v], e))) >= half) return false;
    }
    return seen || length(d) < half;
  }
};

}  // namespace quarry
