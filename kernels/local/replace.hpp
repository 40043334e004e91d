// The one commit of all operations that put some faces in the place of others, and its rollback.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/build.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/operation/cavity.hpp"
#include "engine/operation/editor.hpp"
#include "kernels/local/stamped_map.hpp"

namespace quarry {

// Keeps its memory from one call to the next: make one a thread. Pure topology: it looks at no position.
class FaceReplacer {
 public:
  // Puts `fresh` in the place of `old`: both cover the same region and have the same directed rim sides, that
  // is sides whose other face is not in the region; a side on the boundary of the mesh may become two. The
  // slots of old faces are used first, then ids.take_face(); slots that are left over die, as do inner
  // vertices that no fresh face uses. Dead faces among the old ones are slots and nothing else. Vertices that
  // are new, or dead, come alive by being used. Constraint bits of sides that stay, on the rim or inside, are
  // carried over; new sides have none. side_of stays right, most clockwise on the boundary.
  //
  // A confined editor must have claimed the corners of the old faces. New vertices are placed and tagged by
  // the caller before the call. Returns the slots used, in the order of `fresh`, valid until the next call;
  // `old` may be what the last call returned. The cost is proportional to the number of faces.
  std::span<const FaceId> replace(MeshEditor& editor, ConstraintTags tags, std::span<const FaceId> old,
                                  std::span<const FaceCorners> fresh, NewIds& ids);

  // The rollback: puts `saved`, the corners that the old faces of the last replace() had, back into their
  // slots. New faces die, and new vertices. Nothing may have been replaced there in between. Positions and
  // tags of vertices are the caller's.
  void undo(MeshEditor& editor, ConstraintTags tags, std::span<const FaceCorners> saved);

 private:
  // A directed side, by its ends.
  struct Side {
    SideId old, across;  // in the old faces, and what lay across
    SideId fresh;        // in the new faces
    bool constrained = false;
  };
  struct Vertex {
    bool wants_side = false;  // side_of is to be set
    bool used = false;        // by a fresh face
    SideId first;
  };

  void gather(const MeshEditor& editor, const ConstraintTags& tags, std::span<const FaceId> old,
              std::size_t fresh_count);
  void commit(MeshEditor& editor, ConstraintTags tags, std::span<const FaceId> old,
              std::span<const FaceCorners> fresh, std::span<const FaceId> slots);
  void write(MeshEditor& editor, std::span<const FaceId> old, std::span<const FaceCorners> fresh,
             std::span<const FaceId> slots);
  void join(MeshEditor& editor, ConstraintTags tags, std::span<const FaceId> slots);
  void name_sides(MeshEditor& editor, std::span<const FaceId> slots);
  [[nodiscard]] bool on_rim(const Mesh& mesh, SideId fresh, const Side& side);

  StampedMap<Side> sides_;
  StampedMap<Vertex> vertices_;
  std::vector<VertexId> met_;  // the vertices, in the order of the faces
  std::vector<FaceId> replaced_,
      slots_;  // of the last replace(): the old faces and the slots of the new ones
};

}  // namespace quarry
