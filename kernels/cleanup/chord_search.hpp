// What the collapse of a set of chords gains, and what it makes of the faces beside it. Reads only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/mesh/build.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/cleanup/chord_charges.hpp"
#include "kernels/cleanup/chord_report.hpp"
#include "kernels/cleanup/chord_sets.hpp"
#include "kernels/cleanup/chords.hpp"
#include "kernels/cleanup/irregular_price.hpp"
#include "kernels/local/stamped_map.hpp"
#include "kernels/smooth/local_numbers.hpp"

namespace quarry {

// What a collapse does: faces on the chords go, those beside them get fresh corners, and the vertices of each
// group become one.
struct ChordProposal {
  std::vector<FaceId> beside, crossed;  // faces
  std::vector<FaceCorners> fresh;       // corners of the faces beside
  std::vector<std::uint8_t> sides;      // their constrained sides
  std::vector<SectorCharges::OfFace> charges;
  struct Group {
    VertexId kept;
    std::uint32_t begin, end;  // of members
  };
  std::vector<Group> groups;
  std::vector<VertexId> members;
  double gain = 0;  // by so much the valence energy falls
};

class ChordSearch {
 public:
  ChordSearch(const Mesh& mesh, const ConstraintTags& tags, const Chords& chords,
              const SectorCharges& charges, const IrregularPrice& price)
      : mesh_(&mesh), tags_(tags), chords_(&chords), charges_(&charges), price_(&price) {}

  // By how much the valence energy falls where a set collapses, if each line remains and it is at least this
  // for each face that goes. Else sets the reason.
  [[nodiscard]] std::optional<double> gain(const ChordSet& set, double least_gain, ChordReject& reason);
  // Faces of the set that was asked for last.
  [[nodiscard]] std::size_t count_crossed() const { return faces_.size(); }
  // The collapse of a set that gains so much, if the mesh stays whole. Else sets the reason.
  [[nodiscard]] std::optional<ChordProposal> propose(const ChordSet& set, double least_gain,
                                                     ChordReject& reason);

 private:
  struct Vertex {
    VertexId vertex;
    std::uint32_t group;                 // parent in the forest of vertices that become one
    std::uint32_t line;                  // the same for those that become one along lines
    std::uint32_t held = Chords::kNone;  // of a root: the line that its group lies on
    VertexId kept;                       // of a root
    std::uint32_t rungs = 0;             // that end here
  };
  struct Sector {
    VertexId vertex;
    SideId first;  // its most clockwise side
    std::uint32_t parent;
    int charge;     // of a root: of all together
    double energy;  // of a root: that of all before
    int faces = 0;  // of a root: afterwards
    bool inside = false;
  };

  // A side that chords cross, and the numbers of its ends.
  struct Rung {
    SideId side;
    std::uint32_t from, to;
  };

  void gather(const ChordSet& set);
  void gather_sectors(bool all);
  void join_along(SideId s, bool all);
  [[nodiscard]] std::uint32_t number(VertexId v);
  [[nodiscard]] SideId first_side(SideId s) const;
  [[nodiscard]] std::uint32_t sector_of(SideId s);
  void join_sectors(SideId a, SideId b);
  [[nodiscard]] bool keeps_lines();
  [[nodiscard]] bool gather_beside(ChordProposal& proposal, ChordReject& reason);
  [[nodiscard]] bool crossed(FaceId f) { return crossed_.find(stamped_key(f)) != nullptr; }
  [[nodiscard]] bool fill_sectors();
  [[nodiscard]] bool one_fills(SideId first) const;
  [[nodiscard]] bool write_fresh(FaceId f, ChordProposal& proposal);
  [[nodiscard]] bool constrained_past(SideId s);
  [[nodiscard]] int charge_after(SideId s);
  [[nodiscard]] double energy_fall();
  [[nodiscard]] double energy_at(VertexId v, int charge) const {
    return charge != 0 && *price_ ? (*price_)(mesh_->point3(v)) * charge * charge : charge * charge;
  }
  [[nodiscard]] VertexId kept(VertexId v);

  const Mesh* mesh_;
  ConstraintTags tags_;
  const Chords* chords_;
  const SectorCharges* charges_;
  const IrregularPrice* price_;
  StampedMap<char> crossed_, beside_, sides_;
  std::vector<Rung> rungs_;
  std::vector<FaceId> faces_;
  LocalNumbers numbers_;
  std::vector<Vertex> vertices_;
  StampedMap<std::uint32_t> sector_numbers_;
  std::vector<Sector> sectors_;
};

}  // namespace quarry
