// Closest points and rays on a triangulated surface: what a mesher on that surface asks for with every move.
// Every answer is made in double from the given coordinates, and the smallest (squared distance, triangle)
// or (parameter, triangle) wins: it depends on nothing but the surface and the question, not on how the
// search went, on the processor or on threads. Any triangles will do: open, closed, crossing each other,
// without area. It does not know which triangles are neighbours; a caller who does can say which ones to keep
// to.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/base/id.hpp"
#include "engine/geometry/vec.hpp"
#include "surface/project/triangle_filter.hpp"
#include "surface/project/triangle_point.hpp"

namespace quarry {

// A point of the surface.
struct SurfacePoint {
  Vec3 position;
  TriangleId triangle;      // none if no triangle qualifies
  CornerWeights weights{};  // of the triangle's corners in their given order
  double squared_distance = std::numeric_limits<double>::infinity();
};

struct ClosestQuery {
  // Triangles farther away do not qualify.
  double radius = std::numeric_limits<double>::infinity();
  // A triangle that is thought to be near. The answer is the same without it, but comes later.
  TriangleId start = {};
  // With a cosine above -1, triangles qualify whose unit normal (by the turn of their corners) has at least
  // this dot product with the given one, of length 1; triangles without area do not. So callers keep to their
  // own side of a thin wall.
  Vec3 normal = {};
  double least_cosine = -1;
  // Triangles that qualify; all by default.
  TriangleFilter keep = {};
};

struct SurfaceHit {
  double parameter = 0;      // the hit lies at origin + parameter * direction, up to rounding
  Vec3 position = {};        // on the triangle: exactly its corner if the ray goes through that
  TriangleId triangle = {};  // none if nothing is hit
  CornerWeights weights{};
};

// Crossings of a ray, by the side that it comes from.
struct CrossingCounts {
  std::uint32_t from_front = 0;  // where the normal points to
  std::uint32_t from_back = 0;
};

class TriangleBlocks;

class TriangleTree {
 public:
  // points, triangles: finite; corners are numbers of points. They are copied. instruction_set: see BoxTree;
  // it changes no answer.
  TriangleTree(std::span<const Vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
               const std::string& instruction_set = {});
  ~TriangleTree();
  TriangleTree(TriangleTree&&) noexcept;
  TriangleTree& operator=(TriangleTree&&) noexcept;

  // The point of the qualifying triangles that is nearest to p; of several triangles that are equally near,
  // the one with the lowest number. Squares of distances must not overflow.
  [[nodiscard]] SurfacePoint closest(Vec3 p, const ClosestQuery& query = {}) const;

  // The same for many points, in parallel, in the order of the points. normals: one for each point, in place
  // of the query's; or empty. The filter is called from many threads at once.
  [[nodiscard]] std::vector<SurfacePoint> closest_all(std::span<const Vec3> points,
                                                      const ClosestQuery& query = {},
                                                      std::span<const Vec3> normals = {}) const;

  // The first triangle at a parameter of 0 or more; of several at the same one, as at an edge, the one with
  // the lowest number. A ray never slips through where triangles share corners. direction: not zero; of any
  // length. The origin may lie up to about 1e8 times the size of the surface away.
  [[nodiscard]] SurfaceHit ray(Vec3 origin, Vec3 direction) const;

  // How often a ray crosses triangles. Where it meets edges or corners it counts as moved sideways by next to
  // nothing, so that for a closed surface the sum is odd inside and even outside. Only how often it crosses
  // near its origin is uncertain, by rounding, if that lies on the surface.
  [[nodiscard]] CrossingCounts crossings(Vec3 origin, Vec3 direction) const;

  // Whether p lies inside the closed surface that the triangles form: by the parity of crossings.
  [[nodiscard]] bool encloses(Vec3 p) const;

 private:
  std::unique_ptr<const TriangleBlocks> triangles_;
};

}  // namespace quarry
