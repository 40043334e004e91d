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

std::uint8_t StarToggle::add_vertex(VertexId v) {
  vertices_[vertex_count_] = v;
  more_faces_[vertex_count_] = 0;
  return static_cast<std::uint8_t>(vertex_count_++);
}

std::uint8_t StarToggle::position_of(VertexId v) {
  for (std::size_t i = 0; i < vertex_count_; ++i)
    if (vertices_[i] == v) return static_cast<std::uint8_t>(i);
  return add_vertex(v);
}

std::uint8_t StarToggle::find(FaceId f) const {
  for (std::size_t i = 0; i < face_count_; ++i)
    if (faces_[i].id == f) return static_cast<std::uint8_t>(i);
  return kUnknown;
}

// The arcs around a vertex, in the face of a side that starts there.
static std::uint8_t arcs_at_origin(SideId s) {
  return static_cast<std::uint8_t>(bit_of(s.index()) | bit_of(previous_of_three(s.index())));
}

// The face of s, whose corners from the origin of s on are at these positions, with its two arcs there
// toggled.
std::uint8_t StarToggle::add_face(SideId s, std::uint8_t here, std::uint8_t next, std::uint8_t previous) {
  Face& face = faces_[face_count_];
  const auto k = static_cast<std::size_t>(s.index());
  face.id = s.face();
  face.before = state_->join[face.id];
  face.after = static_cast<std::uint8_t>(face.before ^ arcs_at_origin(s));
  face.corner[k] = here;
  face.corner[k == 2 ? 0 : k + 1] = next;
  face.corner[k == 0 ? 2 : k - 1] = previous;
  face.across = {kUnknown, kUnknown, kUnknown};
  return static_cast<std::uint8_t>(face_count_++);
}

// Two faces that follow each other counter-clockwise around the origin of both sides.
void StarToggle::join_in_turn(std::uint8_t face, SideId s, std::uint8_t after, SideId t) {
  faces_[face].across[static_cast<std::size_t>(previous_of_three(s.index()))] = after;
  faces_[after].across[static_cast<std::size_t>(t.index())] = face;
}

void StarToggle::gather_first(VertexId v) {
  const Mesh& mesh = state_->mesh;
  const SideId first = mesh.side_of(v);
  const std::uint8_t centre = add_vertex(v);
  const std::uint8_t start = add_vertex(mesh.target(first));
  std::uint8_t next = start;
  SideId before;
  for (SideId s = first;;) {
    const SideId t = mesh.turn_left(s);
    const bool last = t == first;
    const std::uint8_t previous = last ? start : add_vertex(apex(mesh, s));
    const std::uint8_t here = add_face(s, centre, next, previous);
    if (here > 0) join_in_turn(static_cast<std::uint8_t>(here - 1), before, here, s);
    before = s;
    if (last) {
      join_in_turn(here, s, 0, first);
      return;
    }
    next = previous;
    s = t;
  }
}

// The two faces at the edge between both vertices are there already.
void StarToggle::gather_second(VertexId first, VertexId v) {
  const Mesh& mesh = state_->mesh;
  const std::uint8_t centre = position_of(v);
  const SideId start = mesh.side_of(v);
  std::uint8_t before = kUnknown, first_face = kUnknown;
  SideId side_before;
  SideId s = start;
  do {
    std::uint8_t here;
    if (mesh.target(s) == first || apex(mesh, s) == first) {
      here = find(s.face());
      faces_[here].after ^= arcs_at_origin(s);
    } else {
      const std::uint8_t next = position_of(mesh.target(s));
      here = add_face(s, centre, next, position_of(apex(mesh, s)));
    }
    if (before != kUnknown) join_in_turn(before, side_before, here, s);
    if (first_face == kUnknown) first_face = here;
    before = here;
    side_before = s;
    s = mesh.turn_left(s);
  } while (s != start);
  join_in_turn(before, side_before, first_face, start);
}

void StarToggle::gather(Star star) {
  face_count_ = 0;
  vertex_count_ = 0;
  gather_first(star.first);
  if (star.second.valid()) gather_second(star.first, star.second);
}

// The change in cost of the quad across side k. A quad between two gathered faces is counted by the face with
// the smaller id.
int StarToggle::change_at(const Face& face, int k) const {
  const bool was = ((face.before >> k) & 1U) != 0;
  const bool is = ((face.after >> k) & 1U) != 0;
  if (!was && !is) return 0;
  const SideId s(face.id, k);
  std::uint8_t other = face.across[static_cast<std::size_t>(k)];
  bool split_before, split_after;
  if (other == kUnknown) {
    const FaceId across = state_->mesh.neighbour(s).face();
    other = find(across);
    if (other == kUnknown) split_before = split_after = is_split(state_->join[across]);
  }
  if (other != kUnknown) {
    if (faces_[other].id < face.id) return 0;
    split_before = is_split(faces_[other].before);
    split_after = is_split(faces_[other].after);
  }
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
    // An arc that is toggled lies between two gathered faces.
    if (faces_[face.across[here]].id < face.id) continue;
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
