// What a local operator makes of a place: faces that go, faces that come.
#pragma once

#include <span>
#include <vector>

#include "engine/mesh/build.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

struct LocalChange {
  std::vector<FaceId> old;
  std::vector<FaceCorners> fresh;
  // A vertex that gets a new place before anything is judged, the mean of some others; or none.
  VertexId placed;
  std::vector<VertexId> mean_of;
  // Whose price that vertex gets, if it is new.
  VertexId priced_as;

  void clear() {
    old.clear();
    fresh.clear();
    placed = VertexId();
    mean_of.clear();
    priced_as = VertexId();
  }
  // The face with one corner exchanged.
  static FaceCorners exchanged(const Mesh& mesh, FaceId f, VertexId from, VertexId to) {
    FaceCorners corners;
    for (int i = 0; i < 4; ++i) {
      const VertexId v = mesh.corner(f, i);
      corners[static_cast<std::size_t>(i)] = v == from ? to : v;
    }
    return corners;
  }
};

}  // namespace quarry
