#include "kernels/matching/star_toggle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geometry/segment.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry::matching {
namespace {

constexpr std::size_t kVertexChunk = 1024;

double corner_angle_in_space(const Mesh& mesh, SideId s) {
  const Vec3 here = mesh.point3(mesh.origin(s));
  const Vec3 out = mesh.point3(mesh.target(s)) - here;
  const Vec3 back = mesh.point3(apex(mesh, s)) - here;
  return std::atan2(length(cross(out, back)), dot(out, back));
}

// What the star of a vertex says about it.
struct StarFacts {
  int faces = 0;
  int constrained = 0;  // sides that start here
  int valence = 0;      // of the quad mesh
  double angle = 0;
};

StarFacts facts_of(const Mesh& mesh, ConstraintTags tags, const DualArcs& join, VertexId v) {
  StarFacts facts;
  const bool rim = mesh.on_boundary(v);
  for_each_side_around(mesh, v, [&](SideId s) {
    ++facts.faces;
    facts.constrained += tags.constrained(s) ? 1 : 0;
    facts.valence += (contains(join, s) ? 0 : 1) + (is_split(join[s.face()]) ? 1 : 0);
    if (rim) facts.angle += corner_angle_in_space(mesh, s);
  });
  return facts;
}

// 4 inside and on lines that pass; of a boundary vertex by its angle. Where lines meet the sectors decide,
// which a single number cannot say.
int ideal_of(const Mesh& mesh, VertexId v, const StarFacts& facts) {
  if (mesh.on_boundary(v))
    return std::max(1, static_cast<int>(std::lround(facts.angle / (0.5 * std::numbers::pi))));
  return facts.constrained <= 2 ? 4 : 0;
}

}  // namespace

SearchState::SearchState(const Mesh& of, ConstraintTags tags, const MergeCosts& merge_costs, DualArcs& start)
    : mesh(of),
      costs(merge_costs),
      join(start),
      valence(of.vertex_slots(), 0),
      ideal(of.vertex_slots(), 0),
      free(of.vertex_slots(), 0) {
  parallel::for_each(
      mesh.vertex_slots(),
      [&](std::size_t i) {
        const VertexId v(i);
        if (!mesh.alive(v)) return;
        const StarFacts facts = facts_of(mesh, tags, join, v);
        valence[v] = static_cast<std::int16_t>(facts.valence);
        ideal[v] = static_cast<std::uint8_t>(ideal_of(mesh, v, facts));
        free[v] = !mesh.on_boundary(v) && facts.constrained == 0 &&
                          static_cast<std::size_t>(facts.faces) <= StarToggle::kMostFaces
                      ? 1
                      : 0;
      },
      kVertexChunk);
}

std::uint8_t StarToggle::position_of(VertexId v) {
  for (std::size_t i = 0; i < vertex_count_; ++i)
    if (vertices_[i] == v) return static_cast<std::uint8_t>(i);
  vertices_[vertex_count_] = v;
  more_faces_[vertex_count_] = 0;
  return static_cast<std::uint8_t>(vertex_count_++);
}

const StarToggle::Face* StarToggle::find(FaceId f) const {
  for (std::size_t i = 0; i < face_count_; ++i)
    if (faces_[i].id == f) return &faces_[i];
  return nullptr;
}

void StarToggle::add_face(FaceId f, std::uint8_t toggled) {
  Face& face = faces_[face_count_++];
  face.id = f;
  face.before = state_->join[f];
  face.after = static_cast<std::uint8_t>(face.before ^ toggled);
  for (int k = 0; k < 3; ++k)
    face.corner[static_cast<std::size_t>(k)] = position_of(state_->mesh.corner(f, k));
}

void StarToggle::gather(Star star) {
  face_count_ = 0;
  vertex_count_ = 0;
  const auto sides_at = [](SideId s) {
    return static_cast<std::uint8_t>(bit_of(s.index()) | bit_of(previous_of_three(s.index())));
  };
  for_each_side_around(state_->mesh, star.first, [&](SideId s) { add_face(s.face(), sides_at(s)); });
  if (!star.second.valid()) return;
  const std::size_t around_first = face_count_;
  for_each_side_around(state_->mesh, star.second, [&](SideId s) {
    for (std::size_t i = 0; i < around_first; ++i) {
      if (faces_[i].id != s.face()) continue;
      faces_[i].after ^= sides_at(s);
      return;
    }
    add_face(s.face(), sides_at(s));
  });
}

// The change in cost of the quad across side k. A quad between two gathered faces is counted by the face with
// the smaller id.
int StarToggle::change_at(const Face& face, int k) const {
  const bool was = ((face.before >> k) & 1U) != 0;
  const bool is = ((face.after >> k) & 1U) != 0;
  if (!was && !is) return 0;
  const SideId s(face.id, k);
  const FaceId across = state_->mesh.neighbour(s).face();
  const Face* other = find(across);
  if (other != nullptr && across < face.id) return 0;
  const bool split_before = is_split(other != nullptr ? other->before : state_->join[across]);
  const bool split_after = other != nullptr ? is_split(other->after) : split_before;
  int change = 0;
  if (was) change -= state_->costs(s, is_split(face.before), split_before);
  if (is) change += state_->costs(s, is_split(face.after), split_after);
  return change;
}

// An arc that comes takes an edge away from both its ends; a Steiner point gives one to each corner.
void StarToggle::count_valences(const Face& face) {
  const int more_splits = (is_split(face.after) ? 1 : 0) - (is_split(face.before) ? 1 : 0);
  for (int k = 0; k < 3; ++k) {
    const auto here = static_cast<std::size_t>(k);
    more_faces_[face.corner[here]] += more_splits;
    const int more_arcs = ((face.after >> k) & 1) - ((face.before >> k) & 1);
    if (more_arcs == 0) continue;
    const SideId s(face.id, k);
    if (state_->mesh.neighbour(s) < s) continue;
    more_faces_[face.corner[here]] -= more_arcs;
    more_faces_[face.corner[static_cast<std::size_t>(next_of_three(k))]] -= more_arcs;
  }
}

int StarToggle::gain_in_cost() {
  int change = 0;
  for (std::size_t i = 0; i < face_count_; ++i) {
    const Face& face = faces_[i];
    const int more_splits = (is_split(face.after) ? 1 : 0) - (is_split(face.before) ? 1 : 0);
    change += more_splits * state_->costs.steiner();
    for (int k = 0; k < 3; ++k) change += change_at(face, k);
    count_valences(face);
  }
  for (std::size_t i = 0; i < vertex_count_; ++i) {
    const VertexId v = vertices_[i];
    if (more_faces_[i] == 0 || state_->ideal[v] == 0) continue;
    const int before = state_->valence[v] - state_->ideal[v];
    const int after = before + more_faces_[i];
    change += (after * after - before * before) * state_->costs.valence();
  }
  return change;
}

void StarToggle::commit() {
  for (std::size_t i = 0; i < face_count_; ++i) state_->join[faces_[i].id] = faces_[i].after;
  for (std::size_t i = 0; i < vertex_count_; ++i) {
    auto& valence = state_->valence[vertices_[i]];
    valence = static_cast<std::int16_t>(valence + more_faces_[i]);
  }
}

}  // namespace quarry::matching
