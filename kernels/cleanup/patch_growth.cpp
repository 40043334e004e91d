#include "kernels/cleanup/patch_growth.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace quarry {

void PatchGrowth::begin(const Mesh& mesh, const PatchStars& stars, std::size_t largest) {
  mesh_ = &mesh;
  stars_ = &stars;
  largest_ = largest;
  taken_.clear(mesh.face_slots());
  counts_.clear(mesh.vertex_slots());
  vertices_ = edges_ = 0;
  charge_ = reflex_ = 0;
  energy_ = 0;
  faces_.clear();
  members_.clear();
  rim_.clear();
  work_.clear();
}

void PatchGrowth::meet(VertexId v) {
  ++vertices_;
  charge_ += stars_->ideal(v) - stars_->faces(v);
  energy_ += stars_->energy(*mesh_, v, stars_->faces(v));
  members_.push_back(v);
  rim_.push_back(v);
}

bool PatchGrowth::add_face(FaceId f) {
  bool& taken = taken_.at(f);
  if (taken) return true;
  if (faces_.size() == largest_ || mesh_->corner_count(f) != 4) return false;
  taken = true;
  faces_.push_back(f);
  std::array<Counts*, 4> counts;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const VertexId v = mesh_->corner(f, static_cast<int>(i));
    counts[i] = &counts_.at(v);
    if (++counts[i]->faces == 1) meet(v);
    if (counts[i]->faces == stars_->faces(v) && stars_->on_boundary(v))
      reflex_ += std::max(0, stars_->ideal(v) - 2);
    work_.push_back(v);
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    const SideId across = mesh_->neighbour(SideId(f, static_cast<int>(i)));
    const bool inner = across.valid() && contains(across.face());
    edges_ += inner ? 0 : 1;
    for (Counts* end : {counts[i], counts[(i + 1) % 4]})
      end->rim_edges = static_cast<std::uint16_t>(inner ? end->rim_edges - 1 : end->rim_edges + 1);
  }
  return true;
}

bool PatchGrowth::add_star(VertexId v) {
  if (stars_->pinned(v)) return false;
  bool added = true;
  for_each_side_around(*mesh_, v, [&](SideId s) { added = added && add_face(s.face()); });
  return added;
}

bool PatchGrowth::add_across(VertexId a, VertexId b) {
  const SideId across = mesh_->neighbour(mesh_->find_side(a, b));
  return !across.valid() || add_face(across.face());
}

bool PatchGrowth::settle(VertexId v) {
  const Counts counts = counts_.get(v);
  if (counts.rim_edges == 0) return !stars_->pinned(v);
  if (outside(v) != 0 && (counts.rim_edges > 2 || outer_angle(v) < 0)) return add_star(v);
  return !stars_->on_line(v) || settle_line(v);
}

// A line enters a patch with one face outside on either side of it, or not at all. Of several lines one
// enters, the one across from it stays outside, and the others run along the rim.
bool PatchGrowth::settle_line(VertexId v) {
  const NodeArms arms = stars_->arms(*mesh_, v);
  int entering = -1, count = 0;
  for (int i = 0; i < arms.count(); ++i) {
    if (!holds_both_sides(arms.side(i))) continue;
    entering = i;
    ++count;
  }
  if (count == 0) return true;
  if (count == 1 && outside(v) == 2 && goes_on_across(arms, entering)) return true;
  // Where it is cut open from v on, it cannot be swallowed.
  return !stars_->on_boundary(v) && add_star(v);
}

bool PatchGrowth::goes_on_across(const NodeArms& arms, int entering) const {
  for (int i = 0; i < arms.count(); ++i) {
    const SideId s = arms.side(i);
    // A line that is cut open begins the turn around the vertex, and ends it.
    SideId right = mesh_->neighbour(s);
    if (!right.valid()) for_each_side_around(*mesh_, mesh_->origin(s), [&](SideId last) { right = last; });
    const bool leaves = !contains(s.face()) && !contains(right.face());
    if (i != entering && leaves != arms.opposite(i, entering)) return false;
  }
  return true;
}

bool PatchGrowth::make_convex() {
  while (!work_.empty()) {
    const VertexId v = work_.back();
    work_.pop_back();
    if (!settle(v)) return false;
  }
  return true;
}

std::span<const VertexId> PatchGrowth::rim_vertices() {
  std::erase_if(rim_, [&](VertexId v) { return counts_.get(v).rim_edges == 0; });
  return rim_;
}

void PatchGrowth::walk_rim(std::vector<VertexId>& rim) {
  rim.clear();
  const std::span<const VertexId> members = rim_vertices();
  if (members.empty()) return;
  const auto leaves = [&](SideId s) {
    const SideId across = mesh_->neighbour(s);
    return !across.valid() || !contains(across.face());
  };
  SideId first;
  for_each_side_around(*mesh_, *std::min_element(members.begin(), members.end()), [&](SideId s) {
    if (contains(s.face()) && leaves(s)) first = s;
  });
  SideId s = first;
  do {
    rim.push_back(mesh_->origin(s));
    s = mesh_->next(s);
    while (!leaves(s)) s = mesh_->next(mesh_->neighbour(s));
  } while (s != first);
  assert(rim.size() == members.size());
}

VertexId PatchGrowth::smallest_irregular() const {
  VertexId smallest;
  for (const VertexId v : members_)
    if (v < smallest && stars_->irregular(v)) smallest = v;
  return smallest;
}

}  // namespace quarry
