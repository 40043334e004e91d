// The local operators of quad clean-up (Canann, Muthukrishnan & Phillips 1998; Kinney 1997; Staten & Canann
// 1997), as topology alone: each finds its best way at a vertex and says which faces it would put in the
// place of which. What is common, the claims, smoothing, verdict and rollback, lies in local_operation.hpp.
// All work on a mesh that is cut open along its constraints; boundary vertices and sides stay as they are, as
// do inner vertices that are not free. Triangles are left alone, but may lie around a vertex that a collapse
// moves.
//
// An operator is a struct with
//   kName, kNewVertices, kNewFaces    how many entities it makes
//   kMends                            it is there to remove bad faces, only where there is one: the energy
//   may
//                                     rise
//   Plan                              one way to do it
//   wants(view, v)                    worth a look at v
//   find(view, v, skip, plan)         the best way at v after `skip` better ones; false if there is none
//   build(view, plan, fresh_vertex, change)   what it does
// A plan names sides: it holds as long as the faces around them do.
#pragma once

#include <cstdint>

#include "kernels/cleanup/local_change.hpp"
#include "kernels/cleanup/local_strip.hpp"
#include "kernels/cleanup/local_view.hpp"

namespace quarry {

// Removes an inner vertex of two faces: two quads that share two edges become one. Such a vertex has an angle
// of half a turn or more, so one of its faces is never valid.
struct DoubletRemoval {
  static constexpr const char* kName = "doublet removal";
  static constexpr std::uint32_t kNewVertices = 0, kNewFaces = 0;
  static constexpr bool kMends = true;
  struct Plan {
    SideId side;  // starts at the vertex
  };
  static bool wants(const LocalView& view, VertexId v);
  static bool find(const LocalView& view, VertexId v, std::uint32_t skip, Plan& plan);
  static void build(const LocalView& view, const Plan& plan, VertexId fresh_vertex, LocalChange& change);
};

// Gives a second face to a flat boundary vertex that has one, where that face is bad: by a rotation, or by a
// new vertex in the middle of the hexagon of the face and the one behind it (two quads become three). The way
// that costs least energy is the first.
struct SingletOpening {
  static constexpr const char* kName = "singlet opening";
  static constexpr std::uint32_t kNewVertices = 1, kNewFaces = 1;
  static constexpr bool kMends = true;
  struct Plan {
    Strip::Plan strip;    // of two quads
    bool opened = false;  // with a new vertex; otherwise rotated
  };
  static bool wants(const LocalView& view, VertexId v);
  static bool find(const LocalView& view, VertexId v, std::uint32_t skip, Plan& plan);
  static void build(const LocalView& view, const Plan& plan, VertexId fresh_vertex, LocalChange& change);
};

// Closes a quad: two opposite corners become one vertex ("diamond" where both have three faces). One of them
// must be free; the other keeps its place if it is not.
struct FaceCollapse {
  static constexpr const char* kName = "face collapse";
  static constexpr std::uint32_t kNewVertices = 0, kNewFaces = 0;
  static constexpr bool kMends = false;
  struct Plan {
    SideId side;  // of the quad, starts at the corner that vanishes
  };
  static bool wants(const LocalView& view, VertexId v);
  static bool find(const LocalView& view, VertexId v, std::uint32_t skip, Plan& plan);
  static void build(const LocalView& view, const Plan& plan, VertexId fresh_vertex, LocalChange& change);
};

// Turns an edge inside the hexagon of its two quads: its ends lose a face, the new ends gain one.
struct EdgeRotation {
  static constexpr const char* kName = "edge rotation";
  static constexpr std::uint32_t kNewVertices = 0, kNewFaces = 0;
  static constexpr bool kMends = false;
  using Plan = Strip::Plan;
  static bool wants(const LocalView& view, VertexId v);
  static bool find(const LocalView& view, VertexId v, std::uint32_t skip, Plan& plan);
  static void build(const LocalView& view, const Plan& plan, VertexId fresh_vertex, LocalChange& change);
};

// Opens two spokes of a vertex into a new quad. The faces between them, from the first counter-clockwise, go
// to a new vertex. For inner vertices of five faces and more, and boundary vertices with too many.
struct VertexSplit {
  static constexpr const char* kName = "vertex split";
  static constexpr std::uint32_t kNewVertices = 1, kNewFaces = 1;
  static constexpr bool kMends = false;
  struct Plan {
    SideId side;              // the first of the faces, starts at the vertex
    std::uint16_t moved = 2;  // how many faces go
  };
  static bool wants(const LocalView& view, VertexId v);
  static bool find(const LocalView& view, VertexId v, std::uint32_t skip, Plan& plan);
  static void build(const LocalView& view, const Plan& plan, VertexId fresh_vertex, LocalChange& change);
};

// Moves a pair of a vertex with a face too few and one with a face too many along a strip to where it meets
// others, and something cancels: the shear of a strip of three quads or more.
struct PairWalk {
  static constexpr const char* kName = "pair walk";
  static constexpr std::uint32_t kNewVertices = 0, kNewFaces = 0;
  static constexpr bool kMends = false;
  using Plan = Strip::Plan;
  static bool wants(const LocalView& view, VertexId v);
  static bool find(const LocalView& view, VertexId v, std::uint32_t skip, Plan& plan);
  static void build(const LocalView& view, const Plan& plan, VertexId fresh_vertex, LocalChange& change);
};

// Calls visit(rung, mirrored) for each strip whose shear gives a face to v at its beginning, or takes one.
// The rung is a side of the first quad, as Strip::begin wants it.
template <class Visit>
void for_each_strip_that_gives(const LocalView& view, VertexId v, Visit&& visit) {
  const Mesh& mesh = view.mesh;
  for_each_side_around(mesh, v, [&](SideId s) {
    if (!view.quad(s.face())) return;
    visit(mesh.next(mesh.next(s)), false);  // v is b[0]
    visit(mesh.next(s), true);              // v is a[0]
  });
}
template <class Visit>
void for_each_strip_that_takes(const LocalView& view, VertexId v, Visit&& visit) {
  const Mesh& mesh = view.mesh;
  for_each_side_around(mesh, v, [&](SideId s) {
    visit(s, false);                // v is a[1]
    visit(mesh.previous(s), true);  // v is b[1]
  });
}

}  // namespace quarry
