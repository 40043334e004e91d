// The wanted edge of elements at each place of a surface, in input units.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.hpp"
#include "surface/project/triangle_tree.hpp"

namespace quarry {

// Where no element may be longer, however lenient sizes are otherwise.
struct TightPlace {
  Vec3 place;
  double edge = 0;
};

class SurfaceSizes {
 public:
  // The same everywhere.
  explicit SurfaceSizes(double edge) : edge_(edge) {}
  // edge: where nothing asks for less. most: the longest at each vertex of the triangles, infinite where any
  // will do; from there sizes grow by at most `growth` times the distance, along the edges of the triangles
  // and within each; from tight places on by the straight distance.
  SurfaceSizes(const Mesh& triangles, std::vector<double> most, double growth, double edge,
               std::vector<TightPlace> tight = {});

  // triangle: by its number in the mesh.
  [[nodiscard]] double at(const SurfacePoint& p) const;
  [[nodiscard]] double at(VertexId v) const;
  [[nodiscard]] bool uniform() const { return most_.empty(); }

  [[nodiscard]] double edge() const { return edge_; }
  // Another wanted edge; what limits it stays.
  void set_edge(double edge) { edge_ = edge; }
  // All limits times so much, but for tight places.
  void set_leniency(double factor) { leniency_ = factor; }
  // The same times so much everywhere, but for the growth.
  [[nodiscard]] SurfaceSizes times(double factor) const {
    SurfaceSizes result = *this;
    result.edge_ *= factor;
    result.leniency_ *= factor;
    for (TightPlace& tight : result.tight_) tight.edge *= factor;
    return result;
  }
  // Where something asks for less than the edge: the share of the area, and the smallest size and its place.
  struct Limited {
    double share = 0, smallest = 0;
    Vec3 place;
  };
  [[nodiscard]] Limited limited() const;
  // The sum of area / edge^2 over the surface, by the sizes at the corners: about how many squares of the
  // wanted edges have room on it. Not for uniform ones, which know no area.
  [[nodiscard]] double squares() const;

 private:
  [[nodiscard]] double area_of(std::size_t triangle) const;
  // The least that tight places allow there, and the edge.
  [[nodiscard]] double tightest(Vec3 place) const;
  // At a corner of the triangles.
  [[nodiscard]] double at_point(std::uint32_t corner) const {
    return std::min(tightest(points_[corner]), leniency_ * most_[corner]);
  }

  double edge_;
  double growth_ = 0;
  double leniency_ = 1;
  // Empty if nothing limits the size.
  std::vector<double> most_;  // by vertex
  std::vector<TightPlace> tight_;
  std::vector<Vec3> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace quarry
