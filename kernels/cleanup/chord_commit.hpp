// Collapses the chords that were found: the pass operation. Each commit replaces the faces, smooths the rows
// around and is judged only then; what is not good enough is taken back.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/operation/pass.hpp"
#include "engine/parallel/scratch_pool.hpp"
#include "kernels/cleanup/chord_collapse.hpp"
#include "kernels/cleanup/chord_search.hpp"
#include "kernels/local/replace.hpp"
#include "kernels/smooth/local_smoother.hpp"

namespace quarry {

class ChordCommit {
 public:
  using Item = std::uint32_t;  // number of the proposal
  struct Plan {};

  // All must outlive the pass. No two proposals share a vertex of their faces.
  ChordCommit(const Mesh& mesh, const ChordOptions& options, std::span<const ChordProposal> proposals);
  ~ChordCommit();

  bool propose(const Mesh& mesh, Item item, Cavity& cavity, Plan& plan) const;
  void apply(MeshEditor& editor, Item item, const Plan& plan, NewIds ids, FollowUps<Item>& follow_ups) const;

  [[nodiscard]] bool won(Item item) const { return won_[item] != 0; }

 private:
  struct Worker;
  // The faces of a proposal and the rows around them.
  struct Region {
    std::vector<VertexId> near;     // its vertices
    std::vector<FaceId> faces;      // each once
    std::vector<VertexId> movable;  // free, and not in the last row, whose vertices are read
  };

  void gather(const Mesh& mesh, const ChordProposal& proposal, Region& region, LocalNumbers& numbers) const;
  void save(const MeshEditor& editor, const ChordProposal& proposal, const Region& region,
            Worker& worker) const;
  void collapse(MeshEditor& editor, const ChordProposal& proposal, NewIds& ids, Worker& worker) const;
  void restore(MeshEditor& editor, const Region& region, Worker& worker) const;
  [[nodiscard]] Vec2 middle(const MeshEditor& editor, const ChordProposal& proposal,
                            const ChordProposal::Group& group) const;
  // Of the faces near a chord.
  struct Quality {
    double smallest = 1;  // scaled Jacobian
    std::size_t low = 0;  // faces below what patches ask for
    double edge_ratio = 1;
  };
  [[nodiscard]] Quality quality_of(const Mesh& mesh, const Region& region) const;
  // False if a face is turned over.
  [[nodiscard]] bool smooth(MeshEditor& editor, Region& region, Worker& worker) const;
  [[nodiscard]] bool good(const Quality& before, const Quality& after) const;

  const ChordOptions* options_;
  std::span<const ChordProposal> proposals_;
  ConstraintTags tags_;
  // By proposal, each written by the thread that has it: what propose() found for apply(), and the outcome.
  mutable std::vector<Region> regions_;
  mutable std::vector<std::uint8_t> won_;
  mutable ScratchPool<Worker> workers_;
};

}  // namespace quarry
