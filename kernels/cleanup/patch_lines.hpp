// The ways of lines through a fill. On a mesh that is sewn along its lines (sew_pieces) a fill may give a
// line another number of edges, which no patch inside a cell can: two pairs of irregular vertices that lie on
// either side of a line, each with one row too many, go together.
//
//   A line passes through a fill if the straight way from the rim vertex where it enters, through the middle
//   of that vertex's two faces and on through the opposite edge of each regular vertex, ends at the rim
//   vertex where the line left, or comes so far as to the node inside where the line ends. The vertices of
//   this way are then those of the line. A node on two lines takes the vertex where their ways cross, one on
//   a single line any vertex of its way: by the lengths of the pieces on either side of it, and a dead end by
//   its number of edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/constraint.hpp"
#include "engine/operation/editor.hpp"
#include "kernels/cleanup/patch_layout.hpp"
#include "kernels/cleanup/patch_strands.hpp"
#include "kernels/local/stamped_map.hpp"

namespace quarry {

struct PatchLine {
  Support support;                   // the piece
  std::vector<std::uint32_t> trace;  // local numbers of a layout, from a node or the rim to another
};

struct PatchNode {
  VertexId vertex;
  std::uint32_t place;  // local number of a layout
};

class PatchLines {
 public:
  // Whether all of them pass through the fill and share nothing there but their nodes. Keeps its memory.
  bool trace(const PatchLayout& layout, const PatchStrands& strands);
  // As traced last.
  [[nodiscard]] const std::vector<PatchLine>& lines() const { return lines_; }
  [[nodiscard]] const std::vector<PatchNode>& nodes() const { return nodes_; }

 private:
  using Way = std::vector<std::uint32_t>;

  void gather();
  [[nodiscard]] bool walk(const PatchStrands::Strand& strand, Way& way);
  [[nodiscard]] bool place_crossings();
  [[nodiscard]] bool cross(std::uint32_t first, std::uint32_t second);
  [[nodiscard]] bool place_between(std::uint32_t strand);
  [[nodiscard]] bool cut_at_nodes();
  [[nodiscard]] bool take(std::uint32_t vertex, std::uint32_t by);
  [[nodiscard]] std::uint32_t turn(std::uint32_t v, std::uint32_t w);

  const PatchLayout* layout_ = nullptr;
  const PatchStrands* strands_ = nullptr;
  std::vector<Way> ways_;                 // of the strands, from the rim on
  std::vector<std::uint32_t> strand_of_;  // by stop
  std::vector<std::uint32_t> at_;         // by stop: its place on the way, 0 as long as it has none
  std::vector<PatchLine> lines_;
  std::vector<PatchNode> nodes_;
  std::vector<std::uint8_t> faces_;   // by vertex of the layout
  std::vector<std::uint32_t> taken_;  // by vertex of the layout: by a node (its number + 2), or a line (1)
  StampedMap<std::uint32_t> sides_;   // by their ends: 4 quad + side
};

// Tags the sides of the faces made for a layout, in its order: inside those along the traces and no others.
// On the rim they stay as they are. keys: scratch.
void tag_traces(MeshEditor& editor, ConstraintTags tags, const PatchLayout& layout,
                std::span<const PatchLine> lines, std::span<const FaceId> made, StampedMap<char>& keys);

}  // namespace quarry
