// The lines inside a patch before it is filled: from rim to rim, or to a node inside where they end.
//
//   A strand goes straight on at each node: from where a line enters the patch to where it leaves, or to a
//   node with nothing across, on another line or at a dead end. What begins and ends inside is no strand:
//   such patches are left alone.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/cleanup/node_slots.hpp"
#include "kernels/cleanup/patch_growth.hpp"
#include "kernels/cleanup/patch_stars.hpp"
#include "kernels/local/stamped_map.hpp"

namespace quarry {

class PatchStrands {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  // Where a piece ends, seen along a strand.
  struct Stop {
    std::uint32_t node = kNone;  // of nodes(); none on the rim
    std::uint8_t slot = 0;       // of the node's arm that the strand comes by
    Support support;             // the piece that leads here
    std::uint32_t edges = 0;     // of the piece, inside the patch
    double length = 0;           // of these edges
  };
  struct Strand {
    std::uint32_t from = 0;            // place on the rim
    std::uint32_t to = kNone;          // place on the rim; none if it ends inside
    std::uint32_t begin = 0, end = 0;  // of stops()
  };
  struct Node {
    VertexId vertex;
    std::uint32_t first = kNone, second = kNone;  // stops there
  };

  // Finds them inside a convex patch. False if there is none, or some are no strands. Keeps its memory.
  bool find(const Mesh& mesh, const PatchStars& stars, const PatchGrowth& growth,
            std::span<const VertexId> rim);

  [[nodiscard]] std::span<const Strand> strands() const { return strands_; }
  [[nodiscard]] std::span<const Stop> stops() const { return stops_; }
  [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }

 private:
  struct Arms {
    NodeArms arms;
    std::uint8_t walked = 0;  // bit i: arm i
  };

  void follow(SideId side, std::uint32_t from);
  [[nodiscard]] Stop walk(SideId& side);
  [[nodiscard]] SideId pass(SideId in, Stop& stop);
  [[nodiscard]] bool complete() const;

  const Mesh* mesh_ = nullptr;
  const PatchStars* stars_ = nullptr;
  const PatchGrowth* growth_ = nullptr;
  std::span<const VertexId> rim_;
  std::vector<Strand> strands_;
  std::vector<Stop> stops_;
  std::vector<Node> nodes_;
  std::vector<Arms> arms_;             // of the nodes
  StampedMap<std::uint32_t> node_of_;  // by vertex
  std::size_t inner_ = 0;              // vertices inside the patch that were met
};

}  // namespace quarry
