// Raw lines in, noded lines out: crossings become nodes, near misses are joined, overlaps and near-parallel
// lines are merged with all their numbers, and no node is left nearer than the snapping distance to a foreign
// piece. The ledger tells what became of each line.
//
// Method: snap rounding with nodes that keep their coordinates (after Hobby 1999 and, for the distance
// between nodes and foreign pieces, Halperin & Packer 2002, "Iterated snap rounding"), followed by
// topology-safe removal of bends in the order of the error that it makes. Each piece keeps the stretch of the
// raw line that it stands for, so that errors are measured against the raw line and never add up unseen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/geometry/line_set.hpp"
#include "kernels/linework/node_classes.hpp"
#include "kernels/linework/outline.hpp"

namespace quarry {

// All in input units.
struct CleanOptions {
  // What comes nearer than this is joined: the distance kept between a node and a foreign piece. Raised to 64
  // ulp of the largest absolute coordinate.
  double snap = 0;
  // Shorter pieces are collapsed where that moves no line by more than snap + min_edge and turns no face
  // over.
  // Raised to snap, within which points become one anyway.
  double min_edge = 0;
  // A bend may go if no raw point that the joined piece stands for ends up farther than this from it.
  double tolerance = 0;
  // Degrees, 0 to 30: where two pieces leave a node at a smaller angle, the second follows the first as long
  // as it is nearer to it than snap, and then leaves it at a wider one. 0: they keep their courses.
  double closed_wedge = 0;
};

// What became of an input line; the first that applies.
enum class LineFate : std::uint8_t {
  kDropped,  // no piece bears its number
  kClipped,  // a part of it lies outside the outline
  kJoined,   // it shares pieces with other lines, or an end of it was moved onto another line
  kSplit,    // it meets other lines between its ends
  kKept,     // none of these
};
[[nodiscard]] const char* name_of(LineFate fate);

// Of more lines than this on one piece or at one node, those of smallest number are told.
inline constexpr std::size_t kMostToldAtOnePlace = 100;

struct LedgerEntry {
  LineFate fate = LineFate::kKept;
  std::vector<LineId> with;  // lines that it shares pieces or nodes with, ascending
  std::string why;
  // Largest distance between the raw line (without clipped parts) and the pieces that stand for it. 0 if
  // dropped.
  double moved = 0;
  Vec2 moved_at;              // the end of a piece near the place of that distance
  double clipped_length = 0;  // length outside the outline
};

// What became of an input point.
struct PointEntry {
  NodeId node;       // none if it was dropped
  double moved = 0;  // from its place to the node's
  std::string why;   // of dropped ones, and of those that share the node with others: one line
};

struct CleanCounts {
  std::uint32_t rounds = 0;           // of snapping and crossing
  std::uint32_t crossings = 0;        // that became nodes
  std::uint32_t bends = 0;            // nodes that a foreign piece was bent through
  std::uint32_t anchors = 0;          // nodes that bring a line that drifts away back to its raw course
  std::uint32_t closed_wedges = 0;    // narrow ones
  std::uint32_t reroutes = 0;         // times that a path was laid anew because bending had led it astray
  std::uint32_t simplified = 0;       // bends removed within the tolerance
  std::uint32_t collapsed = 0;        // pieces collapsed for being short
  std::uint32_t short_pieces = 0;     // pieces shorter than min_edge that had to stay
  std::uint32_t duplicate_lines = 0;  // lines with the points of an earlier line
  std::uint32_t empty_segments = 0;   // of no length, in all lines
  std::uint32_t cut_dangles = 0;      // dangling ends shorter than min_edge that were cut, once for each line
  NodeClassCounts nodes;              // of the cleaned lines
  double smallest_angle = 180;        // degrees, between pieces at a node
  double largest_move = 0;            // largest LedgerEntry::moved
};

struct CleanedLines {
  NodedLines lines;
  IdVector<LineId, LedgerEntry> ledger;
  IdVector<PointId, PointEntry> points;
  CleanCounts counts;
  CleanOptions options;            // as used: snap may have been raised
  std::vector<std::string> notes;  // one line each: what the user should be told
};

// Points are nodes like any other, with no piece where no line comes near; lines are bent to them rather than
// that they are moved.
//
// Nodes come in Hilbert order of their box, pieces by their smaller node, then the larger; from < to by
// number. Throws Error(kInput) if no line has a part within the outline (if there are points alone: none of
// these), Error(kUsage) for lengths that are negative or not finite, Error(kGeometry) with the place if lines
// are too dense to be joined within snap + min_edge + tolerance of their raw course, and Error(kBug) with the
// place if the result breaks what the header of NodedLines promises.
[[nodiscard]] CleanedLines clean_lines(const LineSet& lines, const Outline& outline,
                                       const CleanOptions& options, const Progress& progress = {});

// The promises of NodedLines, checked exactly: no two pieces cross, touch or overlap but at nodes that they
// share, no node lies nearer than snap to a piece that does not end there, no two nodes are equal, no two
// pieces join the same nodes. Throws Error(kBug) with the place.
void require_noded(const NodedLines& lines, double snap);

// The smallest angle between two pieces at a node, in degrees; 180 if no node has two.
[[nodiscard]] double smallest_angle(const NodedLines& lines);

}  // namespace quarry
