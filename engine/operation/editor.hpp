// The one way in which operations write to a mesh. With QUARRY_CHECK_CLAIMS each access is checked against
// the cavity of the running operation, which finds a missing claim on one thread; without, it compiles to
// plain array accesses.
#pragma once

#include <cstdint>
#include <span>

#include "engine/mesh/mesh.hpp"
#include "engine/operation/cavity.hpp"

namespace quarry {

class MeshEditor {
 public:
  // An editor that may touch everything: for code that runs alone.
  explicit MeshEditor(Mesh& mesh) : mesh_(&mesh) {}
  // An editor for one winner of a pass: it may touch what it claimed, and the new ids.
  MeshEditor(Mesh& mesh, std::span<const VertexId> claims, NewIds first, NewIds end)
      : mesh_(&mesh), claims_(claims), first_(first), end_(end), confined_(true) {}

  [[nodiscard]] const Mesh& mesh() const { return *mesh_; }

  [[nodiscard]] Vec2 point(VertexId v) const {
    check_vertex(v, "reads the point of");
    return mesh_->point(v);
  }
  void set_point(VertexId v, Vec2 p) {
    check_vertex(v, "moves");
    mesh_->set_point(v, p);
  }
  // The same in space.
  [[nodiscard]] Vec3 point3(VertexId v) const {
    check_vertex(v, "reads the point of");
    return mesh_->point3(v);
  }
  void set_point3(VertexId v, Vec3 p) {
    check_vertex(v, "moves");
    mesh_->set_point3(v, p);
  }
  [[nodiscard]] SideId side_of(VertexId v) const {
    check_vertex(v, "reads the star of");
    return mesh_->side_of(v);
  }
  void set_side_of(VertexId v, SideId s) {
    check_vertex(v, "sets the side of");
    mesh_->set_side_of(v, s);
  }
  void delete_vertex(VertexId v) {
    check_vertex(v, "deletes");
    mesh_->delete_vertex(v);
  }

  [[nodiscard]] VertexId corner(FaceId f, int index) const { return mesh_->corner(f, index); }
  // Writes a triangle whose neighbours are set afterwards by join().
  void set_triangle(FaceId f, VertexId a, VertexId b, VertexId c) {
    check_face(f, "writes");
    for (const VertexId v : {a, b, c}) check_vertex(v, "makes a corner of");
    mesh_->set_corner(SideId(f, 0), a);
    mesh_->set_corner(SideId(f, 1), b);
    mesh_->set_corner(SideId(f, 2), c);
    mesh_->set_corner(SideId(f, 3), VertexId());
    mesh_->set_neighbour(SideId(f, 3), SideId());
  }
  // The same for a quad.
  void set_quad(FaceId f, VertexId a, VertexId b, VertexId c, VertexId d) {
    check_face(f, "writes");
    for (const VertexId v : {a, b, c, d}) check_vertex(v, "makes a corner of");
    mesh_->set_corner(SideId(f, 0), a);
    mesh_->set_corner(SideId(f, 1), b);
    mesh_->set_corner(SideId(f, 2), c);
    mesh_->set_corner(SideId(f, 3), d);
  }
  void delete_face(FaceId f) {
    check_face(f, "deletes");
    mesh_->delete_face(f);
  }
  // Makes two sides each other's neighbour; t may be none, which puts s on the boundary.
  void join(SideId s, SideId t) {
    check_side(s);
    mesh_->set_neighbour(s, t);
    if (t.valid()) {
      check_side(t);
      mesh_->set_neighbour(t, s);
    }
  }

  template <class T>
  [[nodiscard]] const T& get(Tag<VertexId, T> tag, VertexId v) const {
    check_vertex(v, "reads a tag of");
    return std::as_const(tag)[v];
  }
  template <class T>
  void set(Tag<VertexId, T> tag, VertexId v, T value) {
    check_vertex(v, "sets a tag of");
    tag[v] = value;
  }
  template <class T>
  void set(Tag<FaceId, T> tag, FaceId f, T value) {
    check_face(f, "sets a tag of");
    tag[f] = value;
  }

 private:
  void check_vertex([[maybe_unused]] VertexId v, [[maybe_unused]] const char* what) const {
#ifdef QUARRY_CHECK_CLAIMS
    if (confined_) require_claimed(v, what);
#endif
  }
  // A face may be written by who holds all its corners, old and new; a new face by who created it.
  void check_face([[maybe_unused]] FaceId f, [[maybe_unused]] const char* what) const {
#ifdef QUARRY_CHECK_CLAIMS
    if (confined_) require_face_claimed(f, what);
#endif
  }
  void check_side([[maybe_unused]] SideId s) const {
#ifdef QUARRY_CHECK_CLAIMS
    if (confined_) {
      require_claimed(mesh_->origin(s), "joins an edge at");
      require_claimed(mesh_->target(s), "joins an edge at");
    }
#endif
  }
  void require_claimed(VertexId v, const char* what) const;
  void require_face_claimed(FaceId f, const char* what) const;

  Mesh* mesh_;
  std::span<const VertexId> claims_;
  NewIds first_{};
  NewIds end_{};
  [[maybe_unused]] bool confined_ = false;
};

// Violations found so far in this process by editors with claim checks on, and what the first one was.
struct ClaimViolations {
  std::uint64_t count = 0;
  std::string first;
};
ClaimViolations claim_violations();
void reset_claim_violations();

}  // namespace quarry
