// Looks for a patch around one irregular vertex that can be filled with fewer or cheaper irregular vertices.
// Reads only: seeds are searched in parallel.
//
// The patch starts with the faces around the path to another irregular vertex, grows until it is convex, and
// then ring by ring until some rule for corners gives a fill that lowers the valence energy
//   sum over patch and rim of w(faces - ideal),  w(j) = j^2
// or it is too large. Where that fails the next partner is tried. Rings all around add the same to every
// side, so that a wrong parity stays wrong, and near lines they soon meet too many corners: at last the
// patches grow by single rows, towards irregular vertices, and then on one side of the seed only. A patch
// never contains a triangle, nor a vertex inside that is bound to its place, but for nodes of lines where
// lines run through it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernels/cleanup/patch_fill.hpp"
#include "kernels/cleanup/patch_growth.hpp"
#include "kernels/cleanup/patch_layout.hpp"
#include "kernels/cleanup/patch_lines.hpp"
#include "kernels/cleanup/patch_memory.hpp"
#include "kernels/cleanup/patch_options.hpp"
#include "kernels/cleanup/patch_partners.hpp"
#include "kernels/cleanup/patch_report.hpp"
#include "kernels/cleanup/patch_sides.hpp"
#include "kernels/cleanup/patch_strands.hpp"
#include "kernels/local/stamped_map.hpp"

namespace quarry {

// Each cut doubles the ways in which a patch is filled.
inline constexpr int kMostCuts = 4;

struct PatchProposal {
  VertexId seed;  // the smallest irregular vertex of the patch, rim included
  std::vector<FaceId> faces;
  std::vector<VertexId> rim;    // counter-clockwise from its smallest vertex
  std::vector<VertexId> inner;  // inside: to be used again
  std::vector<VertexId> ring;   // corners of the faces around the rim that smoothing and judgement read
  std::vector<PatchCut> cuts;
  PatchSides sides;  // of what the cuts leave
  PatchFill fill;
  std::vector<PatchLine> lines;  // through the fill
  std::vector<PatchNode> nodes;  // of the lines, inside
  std::uint32_t fresh_faces = 0;
  double gain = 0;        // by so much the valence energy falls
  std::uint64_t key = 0;  // of its vertices: equal patches have equal keys, whoever found them
};

class PatchSearch {
 public:
  PatchSearch(const Mesh& mesh, const PatchStars& stars, const PatchMemory& memory,
              const PatchOptions& options)
      : mesh_(&mesh), stars_(&stars), memory_(&memory), options_(&options) {}

  // Forgets what was learned since the last call: searches of one chunk learn from one another.
  void begin_chunk();
  // The first patch around seed that gains something and was not refused. None too if another search of this
  // chunk found the same. Adds to the counts of the report.
  [[nodiscard]] std::optional<PatchProposal> find(VertexId seed, PatchReport& report);
  // What failed in this chunk.
  [[nodiscard]] const PatchFailures& learned() const { return learned_; }

 private:
  struct Candidate {
    std::vector<PatchCut> cuts;
    PatchSides sides;
    PatchFill fill;
    double gain = 0;
  };

  // Faces along the rim from place begin to place end.
  struct Row {
    std::size_t begin = 0, end = 0, faces = 0;
    double energy = 0;  // of the vertices that they would bring in, those of two faces twice
    [[nodiscard]] double worth() const { return faces > 0 ? energy / static_cast<double>(faces) : -1; }
  };
  // Rings are added only where they lie in this direction from the first vertex on; all around if both are
  // the same. Without a second vertex sides are not pushed either.
  struct Direction {
    VertexId from, to;
    [[nodiscard]] bool by_rows() const { return to.valid() && to == from; }
    [[nodiscard]] bool one_sided() const { return to.valid() && to != from; }
  };
  // Of the rim, whose order these do not ask for.
  struct CornerCounts {
    int outer = 0, inner = 0;  // by either rule
    int reflex = 0;            // faces beyond two that rim vertices are to get inside
    // A cut takes two corners away, makes one of a side or takes one face beyond two, and takes another such
    // face: the sides that are left at last do not depend on how cuts are made.
    [[nodiscard]] bool cuts_may_help() const { return reflex > 0 && can_have_sides(outer - reflex); }
  };
  [[nodiscard]] static bool can_have_sides(int corners) {
    return corners >= 3 && corners <= static_cast<int>(kMostSides);
  }
  enum class Growth : std::uint8_t { kFailed, kFits, kRepeats };

  [[nodiscard]] Growth grow(const std::vector<VertexId>& path, Direction direction, Candidate& found,
                            PatchReport& report);
  [[nodiscard]] Growth grow_on(Direction direction, Candidate& found, PatchReport& report);
  // Whether neither this stage nor any that it grows into can be filled.
  [[nodiscard]] bool is_hopeless(PatchReport& report) const;
  // One stage: true if it has a fill that gains something.
  [[nodiscard]] bool look(Direction direction, Candidate& found, PatchReport& report);
  void sign_faces();
  // Names the patch and the way in which it will go on growing.
  [[nodiscard]] std::uint64_t course_of(Direction direction) const;
  void learn_stage(std::uint64_t key);
  void learn_course(std::uint64_t key);
  [[nodiscard]] bool add_ring(Direction limit);
  // Adds the one row along a side that brings in most energy for its faces; of equals the longest.
  [[nodiscard]] bool add_row();
  [[nodiscard]] Row row_along(std::size_t begin) const;
  // Adds a row along each side whose pushing lengthens a spoke that is too short. False if there is none.
  [[nodiscard]] bool push_sides(bool& growing);
  // Counts corners, walks the rim and finds its sides. False if no fill can gain anything, or none has as few
  // sides as it would need.
  [[nodiscard]] bool survey(PatchReport& report);
  [[nodiscard]] CornerCounts count_corners();
  [[nodiscard]] bool try_fills(Candidate& found, PatchReport& report);
  [[nodiscard]] bool try_sides(const PatchSides& sides, Candidate& found, PatchReport& report);
  // Cuts grids off at reflex vertices, in all ways, and fills what is left.
  [[nodiscard]] bool try_cuts(Candidate& candidate, PatchReport& report);
  [[nodiscard]] bool accept(Candidate& candidate, PatchReport& report);
  [[nodiscard]] bool lines_pass(const Candidate& candidate);
  void set_ring_of_rim();
  void build_layout(const Candidate& candidate) {
    layout_.build(candidate.fill, static_cast<std::uint32_t>(rim_.size()), candidate.cuts,
                  candidate.sides.corner_places());
  }
  // True if a fill of so many faces does not change the sizes of elements too much.
  [[nodiscard]] bool in_band(std::uint64_t faces) const;
  [[nodiscard]] std::optional<PatchFill> choose_fill(const PatchSides& sides, std::size_t cuts) const;
  [[nodiscard]] std::optional<PatchFill> choose_pair(const PatchSides& sides, const PatchRing& rest) const;
  [[nodiscard]] double energy_of_apex(std::uint32_t id, bool with_cuts) const;
  [[nodiscard]] std::uint64_t count_fresh(const Candidate& candidate) const;
  [[nodiscard]] double energy_of(const Candidate& candidate);
  [[nodiscard]] double defect_price(const Candidate& candidate);
  [[nodiscard]] bool joins_twice(const Candidate& candidate);
  [[nodiscard]] PatchProposal propose(const Candidate& candidate);
  void collect_ring(PatchProposal& proposal);

  const Mesh* mesh_;
  const PatchStars* stars_;
  const PatchMemory* memory_;
  const PatchOptions* options_;
  PatchGrowth growth_;
  PatchPartners partners_;
  PatchLayout layout_;
  PatchStrands strands_;
  PatchLines lines_;
  StampedMap<char> seen_;
  KeySet stages_here_, courses_here_;  // failed in this chunk: what learned_ holds
  KeySet found_here_;                  // courses that led to a patch
  PatchFailures learned_;
  std::vector<std::uint64_t> courses_;  // of the patch that grows
  std::uint64_t signature_ = 0;         // of its first signed_ faces
  std::size_t signed_ = 0;
  bool met_refused_ = false;
  CornerCounts corners_;  // of the last stage that was surveyed
  PatchSides outer_;      // by the outer angles, of the last stage; no sides if not walked
  std::vector<std::vector<VertexId>> paths_;  // to the partners, nearest first
  std::vector<VertexId> ring_, rim_;
  std::array<PatchRing, kMostCuts + 1> rings_;  // the rim, and what the cuts tried last leave of it
};

}  // namespace quarry
