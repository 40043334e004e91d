// Gives the free vertices of a small region good places: what an operation on the topology calls between its
// change and the verdict on it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "engine/geometry/model.hpp"
#include "engine/operation/editor.hpp"
#include "kernels/smooth/local_numbers.hpp"
#include "kernels/smooth/shape_star.hpp"
#include "kernels/smooth/tangent_frame.hpp"

namespace quarry {

struct LocalShapeOptions {
  int untangling_sweeps = 12;  // at most; they end with the first after which all faces are valid
  int sweeps = 6;              // at most; they end when nothing moves any more
  // The wanted area of a quad is the mean of the region (kAllAlike), or the mean of the star of each vertex,
  // averaged so many times with those of the stars around.
  static constexpr int kAllAlike = -1;
  int area_averages = kAllAlike;
  ShapeTarget target = {};
  // Moves shorter than this share of the edges at the vertex are not worth the look at the faces. A vertex
  // that has none left sleeps until something moves in its star.
  double smallest_move = 1e-3;
};

// Works on a copy of the region, which each sweep reads in order, and writes the places back at the end. One
// Newton step a vertex and sweep on the energy of kernels/smooth/shape_star.hpp. Keeps its memory from one
// run to the next: one a thread.
template <GeometryModel Model>
class LocalSmoother {
 public:
  using Point = typename Model::Point;

  // The model must outlive the smoother.
  explicit LocalSmoother(const Model& model) : model_(&model) {}
  explicit LocalSmoother(Model&&) = delete;

  // Moves the vertices (free, not on the boundary, each named once) in place, and first untangles the faces
  // around them if one is not valid. Returns the smallest scaled Jacobian of these faces, and a number that
  // is not positive if one is not valid by the model's orientation at each corner (in the plane that is
  // exact). A face that is valid when the sweeps begin stays so. Sets of kParallel vertices and more are
  // swept in parallel, in another order: the outcome is a function of the vertices and their order alone.
  // Reads the points of all corners of these faces.
  double run(MeshEditor& editor, std::span<const VertexId> movable, const LocalShapeOptions& options);

  static constexpr std::size_t kParallel = 2048;

 private:
  // One face of a star by the numbers of its corners; the corner before is `next` of the face that follows.
  struct StarCorner {
    std::uint32_t next, opposite;  // opposite: kNone of a triangle
  };
  using FaceNumbers = std::array<std::uint32_t, 4>;  // vertex, next, opposite, previous
  static constexpr std::uint32_t kNone = 0xffffffffU;
  static constexpr bool kInSpace = std::is_same_v<Point, SpacePoint>;

  void gather(const MeshEditor& editor, std::span<const VertexId> movable);
  void gather_star(const MeshEditor& editor, VertexId v, std::uint32_t number);
  void colour();
  void find_mean_area();
  void find_areas(int averages);
  [[nodiscard]] bool valid(const FaceNumbers& face) const;
  [[nodiscard]] bool all_valid() const;
  [[nodiscard]] double quality(const FaceNumbers& face) const;
  [[nodiscard]] double quality_in_space(const FaceNumbers& face, const Point& first) const;
  // One visit to every vertex that is awake; how many of them moved. regularisation: eps as a
  // share of the wanted area, 0 once untangled.
  std::size_t sweep(double regularisation);
  std::size_t move_all(std::span<const std::uint32_t> members, double regularisation);
  // A visit: what was looked at in vain sleeps until something moves in its star. It would stay where it is.
  bool visit(std::uint32_t i, double regularisation, ShapeStar& star);
  bool move(std::uint32_t i, double regularisation, ShapeStar& star);
  // True if no corner that turns left now is turned over with the vertex at the target.
  [[nodiscard]] bool keeps_valid(std::uint32_t i, const Point& target) const;

  [[nodiscard]] std::span<const StarCorner> star_of(std::size_t i) const {
    return std::span(corners_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
  }
  // Calls visit(next, opposite, previous) with the numbers of the other corners of each face around a vertex.
  template <class Visit>
  void for_each_face(std::uint32_t i, const Visit& visit) const {
    const std::span<const StarCorner> star = star_of(i);
    for (std::size_t k = 0; k < star.size(); ++k)
      visit(star[k].next, star[k].opposite, star[k + 1 < star.size() ? k + 1 : 0].next);
  }

  const Model* model_;
  LocalNumbers numbers_;
  std::vector<Point> points_;         // the movable vertices, then those around them
  std::vector<std::uint32_t> begin_;  // of the corners of each movable vertex, and their end
  std::vector<StarCorner> corners_;
  std::vector<FaceNumbers> faces_;                   // each face once
  std::vector<std::vector<std::uint32_t>> classes_;  // of large sets: no two of a class share a face
  std::vector<std::uint8_t> awake_;                  // by movable vertex
  ShapeStar star_;                                   // with the target of this run
  double smallest_move_ = 0;                         // of this run
  double area_ = 1;                                  // wanted, of a quad
  std::vector<double> areas_;                        // the same by movable vertex, if they are to differ
};

extern template class LocalSmoother<PlaneModel>;
extern template class LocalSmoother<SpaceModel>;

}  // namespace quarry
