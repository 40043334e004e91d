// Lines that run through a patch: where they cross its rim, and their ways through a fill. On a mesh that is
// sewn along its pieces (sew_pieces) a fill may give a line another number of edges, which no patch inside a
// cell can: two pairs of irregular vertices that lie on either side of a line, each with one row too many,
// go together.
//
//   A line passes through a fill if the straight way from the rim vertex where it enters, through the middle
//   of that vertex's two faces and on through the opposite edge of each regular vertex, ends at the rim
//   vertex where the line left. The vertices of this way are then those of the line.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"
#include "engine/operation/editor.hpp"
#include "kernels/cleanup/patch_growth.hpp"
#include "kernels/cleanup/patch_layout.hpp"
#include "kernels/cleanup/patch_stars.hpp"
#include "kernels/local/stamped_map.hpp"

namespace quarry {

struct PatchLine {
  Support support;                   // the piece
  std::vector<std::uint32_t> trace;  // local numbers of a layout, from rim to rim
};

class PatchLines {
 public:
  // Finds the lines inside a convex patch; false if there is none, or one is on more than one piece.
  // Keeps its memory.
  bool find(const Mesh& mesh, const ConstraintTags& tags, const PatchStars& stars, const PatchGrowth& growth,
            std::span<const VertexId> rim);
  // Whether all of them pass through the fill and share no vertex there.
  bool trace(const PatchLayout& layout);
  // As traced last.
  [[nodiscard]] const std::vector<PatchLine>& lines() const { return lines_; }

 private:
  // Between two places of the rim.
  struct Path {
    std::uint32_t from, to;
    Support support;
  };
  void gather(const PatchLayout& layout);
  bool trace(const PatchLayout& layout, const Path& path, PatchLine& line);

  std::vector<Path> paths_;
  std::vector<PatchLine> lines_;
  std::vector<std::uint8_t> faces_;  // by vertex of the layout
  std::vector<bool> on_line_;        // by vertex of the layout
  StampedMap<std::uint32_t> sides_;  // by their ends: 4 quad + side
};

// Tags the sides of the faces made for a layout, in its order: inside those along the traces and no others.
// On the rim they stay as they are. keys: scratch.
void tag_traces(MeshEditor& editor, ConstraintTags tags, const PatchLayout& layout,
                std::span<const PatchLine> lines, std::span<const FaceId> made, StampedMap<char>& keys);

}  // namespace quarry
