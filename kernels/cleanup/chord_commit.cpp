#include "kernels/cleanup/chord_commit.hpp"

#include <algorithm>
#include <memory>

#include "kernels/cleanup/model_face.hpp"

namespace quarry {

struct ChordCommit::Worker {
  PlaneModel plane;
  FaceReplacer replacer;
  LocalSmoother<PlaneModel> smoother{plane};
  LocalNumbers numbers;
  std::vector<FaceId> old;           // faces: those beside, then those crossed
  std::vector<FaceCorners> corners;  // of old
  std::vector<std::uint8_t> sides;   // of old
  std::vector<Vec2> places;          // of the region
};

ChordCommit::ChordCommit(const Mesh& mesh, const ChordOptions& options,
                         std::span<const ChordProposal> proposals)
    : options_(&options),
      proposals_(proposals),
      tags_(ConstraintTags::of(mesh)),
      regions_(proposals.size()),
      won_(proposals.size(), 0),
      workers_([] { return std::make_unique<Worker>(); }) {}

ChordCommit::~ChordCommit() = default;

bool ChordCommit::propose(const Mesh& mesh, Item item, Cavity& cavity, Plan& /*plan*/) const {
  const ScratchPool<Worker>::Loan worker(workers_);
  gather(mesh, proposals_[item], regions_[item], worker->numbers);
  for (const VertexId v : regions_[item].near) cavity.claim(v);
  return true;
}

// The vertices of the faces, then row by row those around.
void ChordCommit::gather(const Mesh& mesh, const ChordProposal& proposal, Region& region,
                         LocalNumbers& numbers) const {
  region = Region();
  numbers.clear(4 * proposal.beside.size());
  const auto take = [&](FaceId f) {
    region.faces.push_back(f);
    for (int k = 0; k < mesh.corner_count(f); ++k)
      if (numbers.number(mesh.corner(f, k)).second) region.near.push_back(mesh.corner(f, k));
  };
  std::for_each(proposal.beside.begin(), proposal.beside.end(), take);
  std::for_each(proposal.crossed.begin(), proposal.crossed.end(), take);
  for (std::size_t begin = 0, row = 0; row <= static_cast<std::size_t>(options_->rows); ++row) {
    const std::size_t end = region.near.size();
    for (; begin < end; ++begin) {
      const VertexId v = region.near[begin];
      for_each_side_around(mesh, v, [&](SideId s) { take(s.face()); });
      if (!is_held(mesh, tags_, v)) region.movable.push_back(v);
    }
  }
  std::sort(region.faces.begin(), region.faces.end());
  region.faces.erase(std::unique(region.faces.begin(), region.faces.end()), region.faces.end());
}

ChordCommit::Quality ChordCommit::quality_of(const Mesh& mesh, const Region& region) const {
  Quality quality;
  for (const FaceId f : region.faces) {
    if (!mesh.alive(f)) continue;
    const double smallest = signed_scaled_jacobian(mesh, PlaneModel(), f);
    quality.smallest = std::min(quality.smallest, smallest);
    quality.low += smallest < options_->least_jacobian ? 1 : 0;
    quality.edge_ratio = std::max(quality.edge_ratio, edge_ratio<PlaneModel>(mesh, f));
  }
  return quality;
}

void ChordCommit::apply(MeshEditor& editor, Item item, const Plan& /*plan*/, NewIds ids,
                        FollowUps<Item>& /*follow_ups*/) const {
  const ChordProposal& proposal = proposals_[item];
  const ScratchPool<Worker>::Loan worker(workers_);
  Region& region = regions_[item];
  const Quality before = quality_of(editor.mesh(), region);
  save(editor, proposal, region, *worker);
  collapse(editor, proposal, ids, *worker);
  const bool won = smooth(editor, region, *worker) && good(before, quality_of(editor.mesh(), region));
  won_[item] = won ? 1 : 0;
  if (!won) restore(editor, region, *worker);
}

void ChordCommit::save(const MeshEditor& editor, const ChordProposal& proposal, const Region& region,
                       Worker& worker) const {
  worker.old = proposal.beside;
  worker.old.insert(worker.old.end(), proposal.crossed.begin(), proposal.crossed.end());
  worker.corners.clear();
  worker.sides.clear();
  for (const FaceId f : worker.old) {
    worker.corners.push_back(
        {editor.corner(f, 0), editor.corner(f, 1), editor.corner(f, 2), editor.corner(f, 3)});
    worker.sides.push_back(tags_.sides[f]);
  }
  worker.places.clear();
  for (const VertexId v : region.near) worker.places.push_back(editor.point(v));
}

// Of a vertex on a piece, which is straight, in the middle of those there that it is made of.
Vec2 ChordCommit::middle(const MeshEditor& editor, const ChordProposal& proposal,
                         const ChordProposal::Group& group) const {
  if (tags_.support[group.kept].is_fixed()) return editor.point(group.kept);
  const bool held = is_held(editor.mesh(), tags_, group.kept);
  Vec2 sum;
  double count = 0;
  for (std::uint32_t i = group.begin; i < group.end; ++i) {
    const VertexId v = proposal.members[i];
    if (held && !is_held(editor.mesh(), tags_, v)) continue;
    sum = sum + editor.point(v);
    count += 1;
  }
  return (1 / count) * sum;
}

void ChordCommit::collapse(MeshEditor& editor, const ChordProposal& proposal, NewIds& ids,
                           Worker& worker) const {
  std::vector<Vec2> middles;
  for (const ChordProposal::Group& group : proposal.groups)
    middles.push_back(middle(editor, proposal, group));
  worker.replacer.replace(editor, tags_, worker.old, proposal.fresh, ids);
  for (std::size_t i = 0; i < proposal.beside.size(); ++i)
    editor.set(tags_.sides, proposal.beside[i], proposal.sides[i]);
  for (std::size_t i = 0; i < proposal.groups.size(); ++i)
    editor.set_point(proposal.groups[i].kept, middles[i]);
}

void ChordCommit::restore(MeshEditor& editor, const Region& region, Worker& worker) const {
  worker.replacer.undo(editor, tags_, worker.corners);
  for (std::size_t i = 0; i < worker.old.size(); ++i) editor.set(tags_.sides, worker.old[i], worker.sides[i]);
  for (std::size_t i = 0; i < region.near.size(); ++i) editor.set_point(region.near[i], worker.places[i]);
}

bool ChordCommit::smooth(MeshEditor& editor, Region& region, Worker& worker) const {
  std::erase_if(region.movable, [&](VertexId v) { return !editor.mesh().alive(v); });
  return region.movable.empty() || worker.smoother.run(editor, region.movable, options_->smoothing) > 0;
}

bool ChordCommit::good(const Quality& before, const Quality& after) const {
  return after.smallest > 0 && after.smallest >= std::min(options_->least_jacobian, before.smallest) &&
         after.low <= before.low &&
         after.edge_ratio <= std::max(options_->largest_edge_ratio, before.edge_ratio);
}

}  // namespace quarry
