// Puts the patches that were found into the mesh: the pass operation. Each commit replaces the faces, places
// and smooths the new vertices together with the rim, and is judged only then; what is not good enough is
// taken back by the same replacement the other way round.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/model.hpp"
#include "engine/operation/pass.hpp"
#include "engine/parallel/scratch_pool.hpp"
#include "kernels/cleanup/patch_layout.hpp"
#include "kernels/cleanup/patch_memory.hpp"
#include "kernels/cleanup/patch_search.hpp"
#include "kernels/local/replace.hpp"
#include "kernels/smooth/local_smoother.hpp"

namespace quarry {

enum class PatchOutcome : std::uint8_t { kWon, kNoGain, kQuality };

template <GeometryModel Model>
class PatchCommit {
 public:
  using Item = std::uint32_t;  // number of the proposal
  struct Plan {};

  // All must outlive the pass. No two proposals share a vertex, rims included. stars has room for the
  // vertices that all proposals together may add, and is kept up to date, as is the memory.
  PatchCommit(const Mesh& mesh, const Model& model, const PatchOptions& options, PatchStars& stars,
              PatchMemory& memory, std::span<const PatchProposal> proposals);
  ~PatchCommit();

  bool propose(const Mesh& mesh, Item item, Cavity& cavity, Plan& plan) const;
  void apply(MeshEditor& editor, Item item, const Plan& plan, NewIds ids, FollowUps<Item>& follow_ups) const;

  [[nodiscard]] PatchOutcome outcome(Item item) const { return outcomes_[item]; }

 private:
  using Point = typename Model::Point;
  struct Worker;

  void place(MeshEditor& editor, const PatchProposal& proposal, NewIds& ids, Worker& worker) const;
  void name_vertices(const PatchProposal& proposal, NewIds& ids, Worker& worker) const;
  void place_points(const MeshEditor& editor, const PatchProposal& proposal, Worker& worker) const;
  void bind_vertices(MeshEditor& editor, const PatchProposal& proposal, const Worker& worker) const;
  void save(const MeshEditor& editor, const PatchProposal& proposal, Worker& worker) const;
  void restore(MeshEditor& editor, const PatchProposal& proposal, const Worker& worker) const;
  [[nodiscard]] double smallest_before(const MeshEditor& editor, const PatchProposal& proposal) const;
  // Not positive, too, where no sweeps would help. ratio: as unequal as edges may be.
  [[nodiscard]] double smallest_after(MeshEditor& editor, std::span<const FaceId> made, double wanted,
                                      double ratio, Worker& worker) const;
  [[nodiscard]] double mean_quality(const Mesh& mesh, std::span<const FaceId> faces) const;
  [[nodiscard]] double largest_edge_ratio(const Mesh& mesh, std::span<const FaceId> faces) const;
  [[nodiscard]] double longest_edge(const Mesh& mesh, std::span<const FaceId> faces) const;
  // How long edges may become in the place of these faces, by the options.
  [[nodiscard]] double longest_allowed(const Mesh& mesh, std::span<const FaceId> faces) const;
  [[nodiscard]] double energy_of(const Mesh& mesh, std::span<const VertexId> vertices) const;

  const Model* model_;
  const PatchOptions* options_;
  PatchStars* stars_;
  PatchMemory* memory_;
  std::span<const PatchProposal> proposals_;
  ConstraintTags tags_;
  mutable std::vector<PatchOutcome> outcomes_;  // each written by the thread that has the proposal
  mutable ScratchPool<Worker> workers_;
};

extern template class PatchCommit<PlaneModel>;
extern template class PatchCommit<SpaceModel>;

}  // namespace quarry
