// Deferred constraint insertion: nodes and straight pieces are worked into a triangle mesh that is there
// already, by moving its vertices where that keeps quality and refining it locally where not.
//   C. Araujo, W. Celes: Quadrilateral mesh generation with deferred constraint insertion. IMR 23, 2014.
// Corrections and additions: all nodes go in first; pieces are straight; smoothing never lowers the worst
// triangle of a star; quality limits follow the wedge between pieces; several targets on a piece; flips
// before splits; a floor on lengths; and a last step that is always possible (kernels/deferred/force.hpp has
// the argument).
//
// It does not clean: pieces may meet at nodes only, and no node may lie on a piece that does not end there.
// The same call inserts further lines into a mesh that bears constraints already.
#pragma once

#include "engine/base/progress.hpp"
#include "engine/geometry/line_set.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/deferred/options.hpp"

namespace quarry {

// Where lines ended up in the mesh: the first nodes and pieces of a NodedLines, by number.
struct InsertedLines {
  IdVector<NodeId, VertexId> vertex_of_node;
  std::size_t pieces = 0;
};

// mesh: positively oriented triangles that cover all nodes, with ConstraintTags. After the call each node is
// a vertex with the bits of the node, and each piece is a chain of constrained edges between the vertices of
// its nodes. before: what an earlier call returned. Its nodes and pieces are in the mesh and must be the
// first of `lines`, in the same order; only those behind them are inserted. Throws Error(kGeometry) with the
// place if a node lies outside the mesh or two pieces cross.
InsertedLines insert_lines(Mesh& mesh, const NodedLines& lines, const DeferredOptions& options,
                           DeferredReport& report, const Progress& progress,
                           const InsertedLines& before = {});

}  // namespace quarry
