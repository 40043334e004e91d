// The part of the search that looks for a fill of the patch as it has grown so far.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "kernels/cleanup/ideal.hpp"
#include "kernels/cleanup/patch_search.hpp"

namespace quarry {
namespace {

PatchReject no_solution(std::uint32_t sides) {
  return static_cast<PatchReject>(static_cast<std::uint32_t>(PatchReject::kNoSolution3) + sides - 3);
}

// Where on the rim the two grids of a pair meet.
std::uint32_t apex_place(const PatchSides& sides, const PatchFill& fill, std::size_t rim) {
  return static_cast<std::uint32_t>((sides.corners[fill.first] + fill.split) % rim);
}

}  // namespace

bool PatchSearch::survey(PatchReport& report) {
  outer_.count = 0;
  // No fill changes the charge, and none has less energy than the charge asks for.
  if (!stars_->has_price() && growth_.energy() <= std::abs(growth_.charge())) {
    report.reject(PatchReject::kNoGain);
    return false;
  }
  corners_ = count_corners();
  if (!can_have_sides(corners_.outer) && !can_have_sides(corners_.inner) && !corners_.cuts_may_help()) {
    report.reject(corners_.outer < 3 ? PatchReject::kFewSides : PatchReject::kManySides);
    return false;
  }
  growth_.walk_rim(rim_);
  outer_ = find_sides(growth_, rim_, CornerRule::kOuterAngle);
  return true;
}

PatchSearch::CornerCounts PatchSearch::count_corners() {
  CornerCounts counts;
  for (const VertexId v : growth_.rim_vertices()) {
    const int angle = growth_.outer_angle(v);
    if (angle > 0) ++counts.outer;
    if (angle < 0) counts.reflex += -angle;
    if (growth_.inside(v) == 1) ++counts.inner;
  }
  return counts;
}

bool PatchSearch::try_fills(Candidate& found, PatchReport& report) {
  if (options_->over_lines != nullptr && !strands_.find(*mesh_, *stars_, growth_, rim_)) {
    report.reject(PatchReject::kLines);
    return false;
  }
  set_ring_of_rim();
  found.cuts.clear();
  if (corners_.cuts_may_help()) {
    if (try_cuts(found, report)) return true;
    found.cuts.clear();
    if (met_refused_) return false;
  }
  if (try_sides(outer_, found, report)) return true;
  if (met_refused_ || !can_have_sides(corners_.inner)) return false;
  const PatchSides inner = find_sides(growth_, rim_, CornerRule::kInnerFaces);
  return inner != outer_ && try_sides(inner, found, report);
}

bool PatchSearch::try_sides(const PatchSides& sides, Candidate& found, PatchReport& report) {
  const auto reject = [&](PatchReject reason) {
    report.reject(reason);
    return false;
  };
  if (sides.count < 3) return reject(PatchReject::kFewSides);
  if (sides.count > kMostSides) return reject(PatchReject::kManySides);
  const std::optional<PatchFill> fill = choose_fill(sides, found.cuts.size());
  if (!fill) return reject(no_solution(sides.count));
  found.sides = sides;
  found.fill = *fill;
  return accept(found, report);
}

bool PatchSearch::accept(Candidate& candidate, PatchReport& report) {
  const auto reject = [&](PatchReject reason) {
    report.reject(reason);
    return false;
  };
  if (!in_band(count_fresh(candidate))) return reject(PatchReject::kFaceBand);
  candidate.gain = growth_.energy() - energy_of(candidate);
  if (!(candidate.gain > 0)) return reject(PatchReject::kNoGain);
  if (joins_twice(candidate)) return reject(PatchReject::kDoubleEdge);
  if (!lines_pass(candidate)) return reject(PatchReject::kLines);
  met_refused_ = memory_->is_refused(signature_);
  return !met_refused_;
}

bool PatchSearch::lines_pass(const Candidate& candidate) {
  if (options_->over_lines == nullptr) return true;
  build_layout(candidate);
  return lines_.trace(layout_, strands_);
}

void PatchSearch::set_ring_of_rim() {
  PatchRing& ring = rings_.front();
  ring.ids.resize(rim_.size());
  std::iota(ring.ids.begin(), ring.ids.end(), 0U);
  ring.targets.clear();
  for (const VertexId v : rim_) {
    const int angle = growth_.outer_angle(v);
    ring.targets.push_back(static_cast<std::uint8_t>(angle > 0 ? 1 : 2 - angle));
  }
}

bool PatchSearch::try_cuts(Candidate& candidate, PatchReport& report) {
  const std::size_t depth = candidate.cuts.size();
  const PatchRing& ring = rings_[depth];
  const auto reflex =
      std::find_if(ring.targets.begin(), ring.targets.end(), [](std::uint8_t target) { return target > 2; });
  if (reflex == ring.targets.end()) return try_sides(find_sides(ring), candidate, report);
  if (depth == std::size_t{kMostCuts}) return false;
  for (const bool mirrored : {false, true}) {
    const auto cut = find_cut(ring, static_cast<std::uint32_t>(reflex - ring.targets.begin()), mirrored);
    if (!cut) continue;
    candidate.cuts.push_back(*cut);
    // Numbers of walls only need to lie above those of the rim here.
    cut_off(ring, *cut, static_cast<std::uint32_t>(rim_.size()), rings_[depth + 1]);
    if (try_cuts(candidate, report)) return true;
    candidate.cuts.pop_back();
    if (met_refused_) return false;
  }
  return false;
}

std::uint64_t PatchSearch::count_fresh(const Candidate& candidate) const {
  std::uint64_t faces = count_faces(candidate.fill, candidate.sides.side_lengths());
  for (const PatchCut& cut : candidate.cuts) faces += std::uint64_t{cut.across} * cut.along;
  return faces;
}

bool PatchSearch::in_band(std::uint64_t faces) const {
  const bool large = growth_.faces().size() > options_->large;
  const double share = static_cast<double>(faces) / static_cast<double>(growth_.faces().size());
  return share >= (large ? options_->fewest_faces_of_large : options_->fewest_faces) &&
         share <= (large ? options_->most_faces_of_large : options_->most_faces);
}

std::optional<PatchFill> PatchSearch::choose_fill(const PatchSides& sides, std::size_t cuts) const {
  std::optional<PatchFill> fill = solve_fill(sides.side_lengths());
  if (!fill && sides.count == 4) fill = choose_pair(sides, rings_[cuts]);
  return fill;
}

// By how much the energy grows where a vertex of the ring gets a face more than it is to have.
double PatchSearch::energy_of_apex(std::uint32_t id, bool with_cuts) const {
  if (id >= rim_.size()) return valence_energy(5, 4);
  const VertexId v = rim_[id];
  const int angle = growth_.outer_angle(v);
  const int faces = growth_.outside(v) + (!with_cuts || angle > 0 ? 2 : 2 - angle);
  return stars_->energy(*mesh_, v, faces + 1) - stars_->energy(*mesh_, v, faces);
}

// The apex goes where one face more costs least, and of such places to the one nearest to the middle.
std::optional<PatchFill> PatchSearch::choose_pair(const PatchSides& sides, const PatchRing& rest) const {
  std::optional<PatchFill> best;
  double least = 0;
  std::uint32_t nearest = 0;
  for (std::uint8_t first = 0; first < 4; ++first) {
    std::optional<PatchFill> fill = solve_pair(sides.side_lengths(), first);
    if (!fill) continue;
    const std::uint32_t edges = sides.lengths[first];
    for (fill->split = 1; fill->split < edges; ++fill->split) {
      const double more =
          energy_of_apex(rest.ids[apex_place(sides, *fill, rest.size())], &rest != &rings_.front());
      const std::uint32_t off = fill->split * 2 > edges ? fill->split * 2 - edges : edges - fill->split * 2;
      if (best && !(more < least || (more == least && off < nearest))) continue;
      best = fill;
      least = more;
      nearest = off;
    }
  }
  return best;
}

// Cuts give the vertices of the rim what they are to have; without cuts sides do.
double PatchSearch::energy_of(const Candidate& candidate) {
  const PatchSides& sides = candidate.sides;
  const PatchFill& fill = candidate.fill;
  const PatchRing& rest = rings_[candidate.cuts.size()];
  const std::vector<std::uint8_t>& targets = rings_.front().targets;
  const bool pair = fill.kind == FillKind::kPair;
  const std::uint32_t apex = pair ? rest.ids[apex_place(sides, fill, rest.size())] : 0;
  double energy = 0;
  std::uint32_t corner = 0;
  for (std::uint32_t i = 0; i < rim_.size(); ++i) {
    int faces = targets[i];
    if (candidate.cuts.empty()) {
      const bool at_corner = corner < sides.count && sides.corners[corner] == i;
      corner += at_corner ? 1 : 0;
      faces = at_corner ? 1 : 2;
    }
    if (pair && i == apex) ++faces;
    energy += stars_->energy(*mesh_, rim_[i], growth_.outside(rim_[i]) + faces);
  }
  double inner = pair && apex >= rim_.size() ? valence_energy(5, 4) : 0;  // on a wall
  if (fill.kind != FillKind::kGrid)
    inner += fill.kind == FillKind::kSix ? valence_energy(6, 4) : valence_energy(5, 4);
  return energy + (inner > 0 && stars_->has_price() ? inner * defect_price(candidate) : inner);
}

// At about the place where the defect will lie: the mean of the ends of its spokes on the rim.
double PatchSearch::defect_price(const Candidate& candidate) {
  build_layout(candidate);
  const PatchLayout::Centre& centre = layout_.centre();
  Vec3 sum;
  double count = 0;
  for (std::uint32_t i = 0; i < centre.count; ++i) {
    if (centre.ends[i] >= rim_.size()) continue;
    sum = sum + mesh_->point3(rim_[centre.ends[i]]);
    count += 1;
  }
  return count > 0 ? stars_->price_at((1 / count) * sum) : 1;
}

// True if an inside edge of the fill joins two rim vertices that have an edge outside as well. Without cuts
// only strips one quad wide have such edges.
bool PatchSearch::joins_twice(const Candidate& candidate) {
  const auto rim = static_cast<std::uint32_t>(rim_.size());
  const auto lengths = candidate.sides.side_lengths();
  if (candidate.cuts.empty()) {
    if (candidate.fill.kind != FillKind::kGrid && candidate.fill.kind != FillKind::kPair) return false;
    if (std::find(lengths.begin(), lengths.end(), 1U) == lengths.end()) return false;
  }
  build_layout(candidate);
  const auto outside = [&](SideId s) { return s.valid() && !growth_.contains(s.face()); };
  for (const PatchLayout::Quad& quad : layout_.quads()) {
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t a = quad[k];
      const std::uint32_t b = quad[(k + 1) % 4];
      if (a >= rim || b >= rim || b == (a + 1) % rim || a == (b + 1) % rim) continue;
      if (outside(mesh_->find_side(rim_[a], rim_[b])) || outside(mesh_->find_side(rim_[b], rim_[a])))
        return true;
    }
  }
  return false;
}

}  // namespace quarry
