#include "kernels/cleanup/local_attempt.hpp"

#include <algorithm>
#include <array>

#include "kernels/cleanup/model_face.hpp"

namespace quarry {

void LocalReach::gather(const LocalView& view, const LocalChange& change) {
  const Mesh& mesh = view.mesh;
  corners_.clear();
  movable_.clear();
  faces_.assign(change.old.begin(), change.old.end());
  seen_.clear(4 * change.old.size());
  std::size_t around = 0;
  for (const FaceId f : change.old) {
    for (int k = 0; k < mesh.corner_count(f); ++k) {
      const VertexId v = mesh.corner(f, k);
      if (!seen_.insert(stamped_key(v)).is_new) continue;
      corners_.push_back(v);
      if (!view.movable(v)) continue;
      movable_.push_back(v);
      around += static_cast<std::size_t>(view.faces(v));
    }
  }
  seen_.clear(faces_.size() + around);
  for (const FaceId f : change.old) seen_.insert(stamped_key(f));
  for (const VertexId v : movable_)
    for_each_side_around(mesh, v, [&](SideId s) {
      if (seen_.insert(stamped_key(s.face())).is_new) faces_.push_back(s.face());
    });
}

void LocalReach::claim(const Mesh& mesh, Cavity& cavity) {
  seen_.clear(4 * faces_.size());
  for (const FaceId f : faces_)
    for (int k = 0; k < mesh.corner_count(f); ++k)
      if (seen_.insert(stamped_key(mesh.corner(f, k))).is_new) cavity.claim(mesh.corner(f, k));
}

template <GeometryModel Model>
Verdict LocalAttempt<Model>::run(MeshEditor& editor, LocalTags tags, const Rules& rules, NewIds ids) {
  const Mesh& mesh = editor.mesh();
  const LocalView view{mesh, tags};
  before_.gather(view, change);
  const Quality before = quality_of(mesh, before_.faces());
  save(editor);
  place(editor, tags);
  const auto made = replacer_.replace(editor, tags.constraints, change.old, change.fresh, ids);
  count_faces(editor, tags, true);

  changed_.old.assign(made.begin(), made.end());
  after_.gather(view, changed_);
  const double around = smoother_.run(editor, after_.movable(), rules.shape);
  const Verdict verdict = judge(mesh, rules, before, around);
  if (verdict == Verdict::kWon) return verdict;
  replacer_.undo(editor, tags.constraints, saved_);
  count_faces(editor, tags, false);
  for (std::size_t i = 0; i < moved_.size(); ++i) set_place(editor, moved_[i], places_[i]);
  return verdict;
}

template <GeometryModel Model>
void LocalAttempt<Model>::save(const MeshEditor& editor) {
  const Mesh& mesh = editor.mesh();
  saved_.clear();
  for (const FaceId f : change.old)
    saved_.push_back({mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2), mesh.corner(f, 3)});
  moved_ = before_.movable();
  places_.clear();
  for (const VertexId v : moved_) places_.push_back(place_of<Point>(editor, v));
}

template <GeometryModel Model>
void LocalAttempt<Model>::place(MeshEditor& editor, LocalTags tags) {
  if (!change.placed.valid()) return;
  if (tags.price.valid() && change.priced_as.valid())
    editor.set(tags.price, change.placed, editor.get(tags.price, change.priced_as));
  // Relative to one of them: coordinates may be large.
  const Point origin = place_of<Point>(editor, change.mean_of[0]);
  Point sum = origin - origin;
  for (const VertexId v : change.mean_of) sum = sum + (place_of<Point>(editor, v) - origin);
  set_place(editor, change.placed,
            model_->project(origin + (1.0 / static_cast<double>(change.mean_of.size())) * sum));
}

// Forward: from the old faces to the fresh ones.
template <GeometryModel Model>
void LocalAttempt<Model>::count_faces(MeshEditor& editor, LocalTags tags, bool forward) {
  const auto add = [&](std::span<const FaceCorners> faces, int step) {
    for (const FaceCorners& face : faces)
      for (const VertexId v : face)
        if (v.valid()) editor.set(tags.faces, v, static_cast<std::uint16_t>(tags.faces[v] + step));
  };
  add(change.fresh, forward ? 1 : -1);
  add(saved_, forward ? -1 : 1);
}

template <GeometryModel Model>
Verdict LocalAttempt<Model>::judge(const Mesh& mesh, const Rules& rules, const Quality& before,
                                   double around) const {
  // Faces around movable vertices are measured by the smoother; the others are new faces.
  double worst = around;
  for (const FaceId f : changed_.old) worst = std::min(worst, signed_scaled_jacobian(mesh, *model_, f));
  const bool as_good = worst >= std::min(rules.floor, before.worst);
  if (as_good && worst <= 0)
    return quality_of(mesh, after_.faces()).invalid <= before.invalid ? Verdict::kWon : Verdict::kInvalid;
  if (!(worst > 0)) return Verdict::kInvalid;
  return as_good ? Verdict::kWon : Verdict::kPoor;
}

template <GeometryModel Model>
typename LocalAttempt<Model>::Quality LocalAttempt<Model>::quality_of(const Mesh& mesh,
                                                                      std::span<const FaceId> faces) const {
  Quality quality;
  for (const FaceId f : faces) {
    const double own = signed_scaled_jacobian(mesh, *model_, f);
    quality.worst = std::min(quality.worst, own);
    quality.invalid += own > 0 ? 0 : 1;
  }
  return quality;
}

template class LocalAttempt<PlaneModel>;
template class LocalAttempt<SpaceModel>;

}  // namespace quarry
