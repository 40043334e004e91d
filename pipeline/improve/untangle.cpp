#include "pipeline/improve/untangle.hpp"

#include <array>

#include "engine/geometry/model.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/operation/editor.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/smooth/local_smoother.hpp"
#include "kernels/smooth/optimise_shape.hpp"
#include "kernels/smooth/slide.hpp"

namespace quarry {
namespace {

// How far a round reaches from the invalid faces, in faces.
constexpr std::array kRings = {2, 4, 8, 16, 64};
constexpr LocalShapeOptions kLocal{.untangling_sweeps = 60, .sweeps = 6};
constexpr int kRelaxingSweeps = 40;
constexpr int kSlidingSweeps = 20;

class Untangler {
 public:
  Untangler(Mesh& mesh, const NodedLines& lines, const Progress& progress)
      : mesh_(mesh),
        lines_(lines),
        tags_(ConstraintTags::of(mesh)),
        slide_(mesh, tags_, lines),
        smoother_(model_),
        progress_(progress) {}

  std::size_t run() {
    std::vector<std::uint32_t> invalid = invalid_faces(mesh_);
    for (const int rings : kRings) {
      if (invalid.empty()) break;
      progress_.throw_if_cancelled();
      find_region(invalid, rings);
      keep_places();
      smooth();
      std::vector<std::uint32_t> now = invalid_faces(mesh_);
      if (!now.empty()) {
        relax();
        smooth();
        now = invalid_faces(mesh_);
      }
      if (now.size() > invalid.size())
        take_back();
      else
        invalid = std::move(now);
    }
    return invalid.size();
  }

 private:
  // The vertices that may move within so many faces of invalid ones, ascending.
  void find_region(const std::vector<std::uint32_t>& invalid, int rings) {
    std::vector<bool> reached(mesh_.vertex_slots(), false);
    std::vector<VertexId> front, next;
    const auto reach = [&](VertexId v) {
      if (reached[v.value()]) return;
      reached[v.value()] = true;
      next.push_back(v);
    };
    const auto reach_face = [&](FaceId f) {
      for (int k = 0; k < mesh_.corner_count(f); ++k) reach(mesh_.corner(f, k));
    };
    for (const std::uint32_t f : invalid) reach_face(FaceId(f));
    for (int ring = 0; ring < rings && !next.empty(); ++ring) {
      front.swap(next);
      next.clear();
      for (const VertexId v : front) for_each_side_around(mesh_, v, [&](SideId s) { reach_face(s.face()); });
    }
    free_.clear();
    movable_.clear();
    for (const VertexId v : mesh_.vertices()) {
      if (!reached[v.value()] || !slide_.movable(v)) continue;
      movable_.push_back(v);
      if (tags_.support[v].is_free()) free_.push_back(v);
    }
  }

  void keep_places() {
    places_.clear();
    for (const VertexId v : movable_) places_.push_back(mesh_.point(v));
  }
  void take_back() {
    for (std::size_t i = 0; i < movable_.size(); ++i) mesh_.set_point(movable_[i], places_[i]);
  }

  void smooth() {
    MeshEditor editor(mesh_);
    smoother_.run(editor, free_, kLocal);
    ShapeOptions shape;
    shape.sweeps = kSlidingSweeps;
    optimise_shape(mesh_, lines_, shape, progress_);
  }

  // Sliding vertices look at those on their line alone, so that they come to lie in its order.
  [[nodiscard]] Vec2 middle_of_neighbours(VertexId v) const {
    const bool slides = tags_.support[v].slides();
    const Vec2 here = mesh_.point(v);
    Vec2 sum{0, 0};
    double count = 0;
    const auto add = [&](SideId s, VertexId other) {
      if (slides && !tags_.constrained(s)) return;
      sum = sum + (mesh_.point(other) - here);
      count += 1;
    };
    for_each_side_around(mesh_, v, [&](SideId s) {
      add(s, mesh_.target(s));
      // Clockwise of the last face on the boundary is an edge that no side leaves by.
      const SideId back = mesh_.previous(s);
      if (!mesh_.neighbour(back).valid()) add(back, mesh_.origin(back));
    });
    return count > 0 ? here + (1 / count) * sum : here;
  }

  void relax() {
    for (int sweep = 0; sweep < kRelaxingSweeps; ++sweep)
      for (const VertexId v : movable_) mesh_.set_point(v, slide_.allowed(v, middle_of_neighbours(v)));
  }

  Mesh& mesh_;
  const NodedLines& lines_;
  ConstraintTags tags_;
  Slide slide_;
  PlaneModel model_;
  LocalSmoother<PlaneModel> smoother_;
  const Progress& progress_;
  std::vector<VertexId> movable_, free_;
  std::vector<Vec2> places_;
};

}  // namespace

std::vector<std::uint32_t> invalid_faces(const Mesh& mesh) {
  return parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) {
    const FaceId f(i);
    return mesh.alive(f) && !all_corners_turn_left(mesh, f);
  });
}

std::size_t untangle(Mesh& mesh, const NodedLines& lines, const Progress& progress) {
  return Untangler(mesh, lines, progress).run();
}

}  // namespace quarry
