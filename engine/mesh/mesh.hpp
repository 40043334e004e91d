// The mesh store: a few arrays. Coordinates are one array an axis (planar meshes have no z), faces of three
// and four corners share one array of four corners a face (a triangle leaves the fourth empty), and a second
// array holds the side across each side. A vertex knows one of its sides. Edges are entities only where they
// carry meaning.
//
// Invariants, checked by validate(): corners of a face are distinct and counter-clockwise to its orientation;
// neighbour is an involution that joins sides of the same two vertices in opposite directions; side_of(v)
// starts at v, and is the most clockwise one where v is on the boundary, so that one counter-clockwise turn
// sees the whole star. A deleted entity is a tombstone until compact().
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/id.hpp"
#include "engine/geometry/box.hpp"
#include "engine/geometry/vec.hpp"
#include "engine/mesh/side.hpp"
#include "engine/mesh/tag.hpp"

namespace quarry {

// A named group of entities: a region, a constraint, a boundary loop.
template <class IdType>
struct EntitySet {
  std::string name;
  std::vector<IdType> members;
};

class Mesh {
 public:
  Mesh() = default;
  Mesh(Mesh&&) = default;
  Mesh& operator=(Mesh&&) = default;

  // Slots, tombstones included: ids run from 0 to these.
  [[nodiscard]] std::size_t vertex_slots() const { return x_.size(); }
  [[nodiscard]] std::size_t face_slots() const { return corners_.size() / 4; }
  [[nodiscard]] std::size_t edge_slots() const { return edge_ends_.size(); }
  [[nodiscard]] IdRange<VertexId> vertices() const { return IdRange<VertexId>(vertex_slots()); }
  [[nodiscard]] IdRange<FaceId> faces() const { return IdRange<FaceId>(face_slots()); }
  [[nodiscard]] IdRange<EdgeId> edges() const { return IdRange<EdgeId>(edge_slots()); }
  [[nodiscard]] bool alive(VertexId v) const { return !(side_of_[v.value()] == kDeadVertex); }
  [[nodiscard]] bool alive(FaceId f) const { return corners_[f.value() * 4].valid(); }
  [[nodiscard]] std::size_t count_alive_vertices() const;
  [[nodiscard]] std::size_t count_alive_faces() const;

  // Geometry.
  [[nodiscard]] bool planar() const { return !spatial_; }
  [[nodiscard]] Vec2 point(VertexId v) const { return {x_[v.value()], y_[v.value()]}; }
  [[nodiscard]] Vec3 point3(VertexId v) const {
    return {x_[v.value()], y_[v.value()], planar() ? 0.0 : z_[v.value()]};
  }
  void set_point(VertexId v, Vec2 p) {
    x_[v.value()] = p.x;
    y_[v.value()] = p.y;
  }
  // Of a mesh in space.
  void set_point3(VertexId v, Vec3 p) {
    set_point(v, {p.x, p.y});
    z_[v.value()] = p.z;
  }
  [[nodiscard]] const std::vector<double>& xs() const { return x_; }
  [[nodiscard]] const std::vector<double>& ys() const { return y_; }
  [[nodiscard]] const std::vector<double>& zs() const { return z_; }
  [[nodiscard]] Box2 box() const;
  [[nodiscard]] Box3 box3() const;

  // Connectivity.
  [[nodiscard]] VertexId corner(FaceId f, int index) const {
    return corners_[f.value() * 4 + static_cast<std::uint32_t>(index)];
  }
  [[nodiscard]] int corner_count(FaceId f) const { return corners_[f.value() * 4 + 3].valid() ? 4 : 3; }
  [[nodiscard]] VertexId origin(SideId s) const { return corners_[s.value()]; }
  [[nodiscard]] VertexId target(SideId s) const { return corners_[next(s).value()]; }
  [[nodiscard]] SideId next(SideId s) const {
    const int index = s.index();
    const bool last = index == 3 || (index == 2 && !corners_[s.value() + 1].valid());
    return SideId(last ? s.value() - static_cast<std::uint32_t>(index) : s.value() + 1);
  }
  [[nodiscard]] SideId previous(SideId s) const {
    if (s.index() != 0) return SideId(s.value() - 1);
    return SideId(s.value() + (corners_[s.value() + 3].valid() ? 3U : 2U));
  }
  // The same edge seen from the face across, or none on the boundary.
  [[nodiscard]] SideId neighbour(SideId s) const { return neighbours_[s.value()]; }
  // A side that starts at v.
  [[nodiscard]] SideId side_of(VertexId v) const { return side_of_[v.value()]; }
  // The next side that starts at the same vertex, counter-clockwise or clockwise; none past the boundary.
  [[nodiscard]] SideId turn_left(SideId s) const { return neighbour(previous(s)); }
  [[nodiscard]] SideId turn_right(SideId s) const {
    const SideId across = neighbour(s);
    return across.valid() ? next(across) : across;
  }
  [[nodiscard]] bool on_boundary(VertexId v) const { return !neighbour(side_of(v)).valid(); }
  // The side from a to b, or none if no face has it.
  [[nodiscard]] SideId find_side(VertexId a, VertexId b) const;

  // Unchecked writes: what local operations are made of (engine/operation/editor.hpp checks them).
  void set_corner(SideId s, VertexId v) { corners_[s.value()] = v; }
  void set_neighbour(SideId s, SideId t) { neighbours_[s.value()] = t; }
  void set_side_of(VertexId v, SideId s) { side_of_[v.value()] = s; }
  void delete_vertex(VertexId v) { side_of_[v.value()] = kDeadVertex; }
  void delete_face(FaceId f);

  // Gives a mesh without vertices a third coordinate.
  void make_spatial();
  // Appends tombstones to be filled by the caller; the first new id.
  VertexId grow_vertices(std::size_t count);
  FaceId grow_faces(std::size_t count);
  void reserve(std::size_t vertex_count, std::size_t face_count);

  // Edges that carry meaning.
  [[nodiscard]] std::pair<VertexId, VertexId> edge_ends(EdgeId e) const { return edge_ends_[e]; }
  EdgeId add_edge(VertexId a, VertexId b);

  // Data. Handles stay valid until the tag is removed.
  template <class IdType, class T>
  Tag<IdType, T> add_tag(std::string name, T initial = T()) {
    return tags<IdType>().template add<T>(std::move(name), slots<IdType>(), initial);
  }
  template <class IdType, class T>
  [[nodiscard]] Tag<IdType, T> find_tag(std::string_view name) const {
    return const_cast<Mesh*>(this)->tags<IdType>().template find<T>(name);
  }
  template <class IdType>
  void remove_tag(std::string_view name) {
    tags<IdType>().remove(name);
  }
  // The normal of the surface that a mesh in space lies on, at each vertex: a tag with a handle at hand,
  // since all that moves vertices there asks for it. Invalid until it is added.
  static constexpr const char* kNormalTag = "normal";
  Tag<VertexId, Vec3> add_normals() { return normals_ = add_tag<VertexId, Vec3>(kNormalTag); }
  void remove_normals() {
    remove_tag<VertexId>(kNormalTag);
    normals_ = {};
  }
  [[nodiscard]] Tag<VertexId, Vec3> normals() const { return normals_; }
  [[nodiscard]] std::vector<EntitySet<VertexId>>& vertex_sets() { return vertex_sets_; }
  [[nodiscard]] std::vector<EntitySet<EdgeId>>& edge_sets() { return edge_sets_; }
  [[nodiscard]] std::vector<EntitySet<FaceId>>& face_sets() { return face_sets_; }

  // Bytes of all arrays, tags included.
  [[nodiscard]] std::size_t bytes() const;

 private:
  friend class MeshBuilder;
  friend class MeshCompactor;
  static constexpr SideId kDeadVertex{SideId::kNone - 1};

  template <class IdType>
  TagSet<IdType>& tags() {
    if constexpr (std::is_same_v<IdType, VertexId>) return vertex_tags_;
    if constexpr (std::is_same_v<IdType, EdgeId>) return edge_tags_;
    if constexpr (std::is_same_v<IdType, FaceId>) return face_tags_;
  }
  template <class IdType>
  [[nodiscard]] std::size_t slots() const {
    if constexpr (std::is_same_v<IdType, VertexId>) return vertex_slots();
    if constexpr (std::is_same_v<IdType, EdgeId>) return edge_slots();
    if constexpr (std::is_same_v<IdType, FaceId>) return face_slots();
  }

  bool spatial_ = false;
  std::vector<double> x_, y_, z_;
  std::vector<SideId> side_of_;
  std::vector<VertexId> corners_;   // four a face
  std::vector<SideId> neighbours_;  // four a face
  IdVector<EdgeId, std::pair<VertexId, VertexId>> edge_ends_;
  TagSet<VertexId> vertex_tags_;
  Tag<VertexId, Vec3> normals_;
  TagSet<EdgeId> edge_tags_;
  TagSet<FaceId> face_tags_;
  std::vector<EntitySet<VertexId>> vertex_sets_;
  std::vector<EntitySet<EdgeId>> edge_sets_;
  std::vector<EntitySet<FaceId>> face_sets_;
};

// Puts a vertex where one of another mesh is; both lie in the plane or in space.
inline void copy_point(const Mesh& from, VertexId v, Mesh& to, VertexId w) {
  if (from.planar())
    to.set_point(w, from.point(v));
  else
    to.set_point3(w, from.point3(v));
}

// Calls visit(SideId) for each side that starts at v, counter-clockwise from side_of(v).
template <class Visit>
void for_each_side_around(const Mesh& mesh, VertexId v, Visit&& visit) {
  const SideId first = mesh.side_of(v);
  for (SideId s = first; s.valid();) {
    visit(s);
    s = mesh.turn_left(s);
    if (s == first) break;
  }
}

}  // namespace quarry
