// Carries out one change of a local operator, smooths what lies around, and judges it: the change stays, or
// everything is put back.
#pragma once

#include <optional>
#include <vector>

#include "engine/geometry/model.hpp"
#include "engine/operation/cavity.hpp"
#include "engine/operation/editor.hpp"
#include "kernels/cleanup/local_change.hpp"
#include "kernels/cleanup/local_view.hpp"
#include "kernels/local/replace.hpp"
#include "kernels/local/stamped_map.hpp"
#include "kernels/smooth/local_smoother.hpp"

namespace quarry {

enum class Verdict {
  kWon,
  kInvalid,  // a face was not valid that had been, or worse than the worst before
  kPoor,     // valid, but worse than before and than the floor
};

// The vertices and faces that a change touches: the movable corners of its faces, and all faces around them.
// Keeps its memory.
class LocalReach {
 public:
  void gather(const LocalView& view, const LocalChange& change);
  // Free inner corners of the old faces, in the order of the faces.
  [[nodiscard]] const std::vector<VertexId>& movable() const { return movable_; }
  // All corners of the old faces.
  [[nodiscard]] const std::vector<VertexId>& corners() const { return corners_; }
  // The old faces, then the other faces around movable vertices.
  [[nodiscard]] const std::vector<FaceId>& faces() const { return faces_; }
  // Claims every vertex whose star or place is read or changed.
  void claim(const Mesh& mesh, Cavity& cavity);

 private:
  std::vector<VertexId> corners_, movable_;
  std::vector<FaceId> faces_;
  StampedMap<char> seen_;
};

// Keeps its memory from one attempt to the next: one a thread.
template <GeometryModel Model>
class LocalAttempt {
 public:
  struct Rules {
    // A change stays if the worst face around is at least as good as this afterwards, or as the worst was
    // before, and no more faces are invalid: where all were valid, all are.
    double floor = 0.3;
    LocalShapeOptions shape;
  };

  explicit LocalAttempt(const Model& model) : model_(&model), smoother_(model) {}
  [[nodiscard]] const Model& model() const { return *model_; }

  // The change may be built into this.
  LocalChange change;

  // Carries out `change`, whose faces and their surroundings the editor may touch (LocalReach::claim).
  Verdict run(MeshEditor& editor, LocalTags tags, const Rules& rules, NewIds ids);

 private:
  using Point = typename Model::Point;
  struct Quality {
    double worst = 1;
    int invalid = 0;
  };

  void save(const MeshEditor& editor);
  void place(MeshEditor& editor, LocalTags tags);
  void count_faces(MeshEditor& editor, LocalTags tags, bool forward);
  void find_movable(const LocalView& view);
  Verdict judge(const Mesh& mesh, const Rules& rules, const Quality& before, double around) const;
  [[nodiscard]] Quality quality_of(const Mesh& mesh, std::span<const FaceId> faces) const;

  const Model* model_;
  LocalSmoother<Model> smoother_;
  FaceReplacer replacer_;
  LocalReach before_, after_;
  LocalChange changed_;  // the new faces as old ones, for after_
  std::vector<FaceCorners> saved_;
  std::vector<VertexId> moved_;
  std::vector<Point> places_;
};

extern template class LocalAttempt<PlaneModel>;
extern template class LocalAttempt<SpaceModel>;

}  // namespace quarry
