#include "kernels/cleanup/patch_search.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/random.hpp"

namespace quarry {

void PatchSearch::begin_chunk() {
  stages_here_.clear();
  courses_here_.clear();
  found_here_.clear();
  learned_.stages.clear();
  learned_.courses.clear();
}

std::optional<PatchProposal> PatchSearch::find(VertexId seed, PatchReport& report) {
  ++report.searches;
  // A path through more of the mesh than the patch may hold leads nowhere.
  partners_.begin(*mesh_, *stars_, seed, options_->largest);
  paths_.resize(std::max(paths_.size(), static_cast<std::size_t>(options_->partners)));
  std::optional<PatchProposal> proposal;
  // True if there is nothing more to look for.
  const auto done = [&](const std::vector<VertexId>& path, Direction direction) {
    Candidate found;
    const Growth growth = grow(path, direction, found, report);
    if (growth == Growth::kFits) proposal = propose(found);
    return growth != Growth::kFailed;
  };
  std::size_t partners = 0;
  for (VertexId partner; partners < static_cast<std::size_t>(options_->partners); ++partners) {
    partner = partners_.next();
    if (!partner.valid()) break;
    partners_.path_from(partner, paths_[partners]);
    if (done(paths_[partners], {seed, VertexId()})) return proposal;
  }
  if (partners == 0 || options_->directions == 0) return std::nullopt;
  for (std::size_t i = 0; i < partners; ++i)
    if (done(paths_[i], {seed, seed})) return proposal;
  std::vector<VertexId> ends;
  for_each_side_around(*mesh_, seed, [&](SideId s) { ends.push_back(mesh_->target(s)); });
  for (std::size_t i = 0; i < ends.size() && i < static_cast<std::size_t>(options_->directions); ++i)
    if (done(paths_[0], {seed, ends[i]})) return proposal;
  return std::nullopt;
}

PatchSearch::Growth PatchSearch::grow(const std::vector<VertexId>& path, Direction direction,
                                      Candidate& found, PatchReport& report) {
  growth_.begin(*mesh_, *stars_, options_->largest);
  signature_ = 0;
  signed_ = 0;
  courses_.clear();
  met_refused_ = false;
  Growth outcome = Growth::kFailed;
  if (std::all_of(path.begin(), path.end(), [&](VertexId v) { return growth_.add_star(v); }))
    outcome = grow_on(direction, found, report);
  report.grown_faces += growth_.faces().size();
  for (const std::uint64_t course : courses_) {
    if (outcome == Growth::kFailed)
      learn_course(course);
    else
      found_here_.insert(course);
  }
  return outcome;
}

PatchSearch::Growth PatchSearch::grow_on(Direction direction, Candidate& found, PatchReport& report) {
  // A compact patch of n faces has about sqrt(n) / 2 rings. One that takes four times as many lies in a strip
  // between lines, where little is found, at a price that grows with the square of its length.
  const double most_rings = 2 * std::sqrt(static_cast<double>(options_->largest));
  bool growing = true;
  for (int rings = 0; growing && growth_.make_convex(); ++rings) {
    if (!direction.to.valid() && rings > most_rings) return Growth::kFailed;
    if (is_hopeless(report)) return Growth::kFailed;
    sign_faces();
    const std::uint64_t course = course_of(direction);
    if (courses_here_.contains(course) || memory_->knows_course(course)) return Growth::kFailed;
    if (found_here_.contains(course)) {
      ++report.duplicates;
      return Growth::kRepeats;
    }
    courses_.push_back(course);
    if (look(direction, found, report)) return Growth::kFits;
    if (met_refused_) return Growth::kFailed;
    if (direction.to.valid() && push_sides(growing)) continue;
    growing = direction.by_rows() ? add_row() : add_ring(direction);
  }
  return Growth::kFailed;
}

// A line inside remains there, and so does what tips and reflex corners on the rim ask for.
bool PatchSearch::is_hopeless(PatchReport& report) const {
  if (!growth_.is_disk()) {
    report.reject(PatchReject::kNoDisk);
    return true;
  }
  if (growth_.reflex() <= kMostCuts) return false;
  report.reject(PatchReject::kManySides);
  return true;
}

bool PatchSearch::look(Direction direction, Candidate& found, PatchReport& report) {
  const std::uint64_t key = mix64(signature_);
  const bool known = stages_here_.contains(key) || memory_->knows_stage(key);
  // Sides are pushed by what the survey finds, also where no fill is.
  if (known && !direction.to.valid()) return false;
  PatchReport unused;
  if (!survey(known ? unused : report)) {
    if (known) return false;
    ++report.stages;
    learn_stage(key);
    return false;
  }
  if (known) return false;
  ++report.stages;
  if (try_fills(found, report)) return true;
  if (!met_refused_) learn_stage(key);
  return false;
}

void PatchSearch::sign_faces() {
  const std::span<const FaceId> faces = growth_.faces();
  for (; signed_ < faces.size(); ++signed_) signature_ += memory_->signature(faces[signed_]);
}

std::uint64_t PatchSearch::course_of(Direction direction) const {
  const std::uint64_t way =
      direction.one_sided() ? stamped_key(direction.from, direction.to) : (direction.by_rows() ? 1U : 0U);
  return mix64(signature_ ^ mix64(way) ^ mix64(~std::uint64_t{options_->largest}));
}

void PatchSearch::learn_stage(std::uint64_t key) {
  stages_here_.insert(key);
  learned_.stages.push_back(key);
}

void PatchSearch::learn_course(std::uint64_t key) {
  courses_here_.insert(key);
  learned_.courses.push_back(key);
}

// False if nothing can be added.
bool PatchSearch::add_ring(Direction limit) {
  const std::span<const VertexId> rim = growth_.rim_vertices();
  ring_.assign(rim.begin(), rim.end());
  const std::size_t before = growth_.faces().size();
  const Vec3 origin = mesh_->point3(limit.from);
  const Vec3 direction = limit.to.valid() ? mesh_->point3(limit.to) - origin : Vec3();
  for (const VertexId v : ring_) {
    if (stars_->pinned(v) || dot(mesh_->point3(v) - origin, direction) < 0) continue;
    if (!growth_.add_star(v)) return false;
  }
  return growth_.faces().size() > before;
}

// False if nothing can be added.
bool PatchSearch::add_row() {
  const Direction everywhere{growth_.vertices().front(), VertexId()};
  growth_.walk_rim(rim_);
  const auto corner =
      std::find_if(rim_.begin(), rim_.end(), [&](VertexId v) { return growth_.outer_angle(v) > 0; });
  if (corner == rim_.end()) return add_ring(everywhere);
  std::rotate(rim_.begin(), corner, rim_.end());
  Row best;
  for (std::size_t begin = 0; begin < rim_.size();) {
    const Row row = row_along(begin);
    if (row.faces > 0 &&
        (row.worth() > best.worth() || (row.worth() == best.worth() && row.faces > best.faces)))
      best = row;
    begin = row.end;
  }
  for (std::size_t k = best.begin; k < best.end; ++k)
    if (!growth_.add_across(rim_[k], rim_[(k + 1) % rim_.size()])) return false;
  return best.faces > 0;
}

// The faces across the edges from a corner to the next.
PatchSearch::Row PatchSearch::row_along(std::size_t begin) const {
  Row row{begin, begin, 0, 0};
  do {
    const SideId across =
        mesh_->neighbour(mesh_->find_side(rim_[row.end], rim_[(row.end + 1) % rim_.size()]));
    ++row.end;
    if (!across.valid() || mesh_->corner_count(across.face()) != 4) continue;
    ++row.faces;
    for (int k = 0; k < 4; ++k) {
      const VertexId v = mesh_->corner(across.face(), k);
      if (!growth_.contains(v)) row.energy += stars_->energy(*mesh_, v, stars_->faces(v));
    }
  } while (row.end < rim_.size() && growth_.outer_angle(rim_[row.end]) <= 0);
  return row;
}

bool PatchSearch::push_sides(bool& growing) {
  const std::uint32_t n = outer_.count;
  if (n < 3 || n > kMostSides) return false;
  const std::uint32_t short_sides = sides_to_push(outer_.side_lengths());
  const std::size_t before = growth_.faces().size();
  for (std::uint32_t i = 0; i < n; ++i) {
    if ((short_sides >> i & 1U) == 0) continue;
    for (std::uint32_t k = 0; k < outer_.lengths[i] && growing; ++k) {
      const std::size_t at = (outer_.corners[i] + k) % rim_.size();
      growing = growth_.add_across(rim_[at], rim_[(at + 1) % rim_.size()]);
    }
  }
  return !growing || growth_.faces().size() > before;
}

PatchProposal PatchSearch::propose(const Candidate& candidate) {
  PatchProposal proposal;
  proposal.seed = growth_.smallest_irregular();
  proposal.faces.assign(growth_.faces().begin(), growth_.faces().end());
  proposal.rim = rim_;
  for (const VertexId v : growth_.vertices())
    if (!growth_.on_rim(v)) proposal.inner.push_back(v);
  proposal.cuts = candidate.cuts;
  proposal.sides = candidate.sides;
  proposal.fill = candidate.fill;
  proposal.gain = candidate.gain;
  proposal.fresh_faces = static_cast<std::uint32_t>(count_fresh(candidate));
  if (options_->over_lines != nullptr) {
    proposal.lines = lines_.lines();
    proposal.nodes = lines_.nodes();
  }
  proposal.key = signature_;
  collect_ring(proposal);
  return proposal;
}

void PatchSearch::collect_ring(PatchProposal& proposal) {
  std::size_t faces = 0;
  for (const VertexId v : rim_) faces += static_cast<std::size_t>(growth_.outside(v));
  seen_.clear(3 * faces);
  for (const VertexId v : rim_) {
    if (!stars_->movable(v)) continue;
    for_each_side_around(*mesh_, v, [&](SideId s) {
      if (growth_.contains(s.face())) return;
      for (int k = 0; k < mesh_->corner_count(s.face()); ++k) {
        const VertexId w = mesh_->corner(s.face(), k);
        if (!growth_.contains(w) && seen_.insert(stamped_key(w)).is_new) proposal.ring.push_back(w);
      }
    });
  }
}

}  // namespace quarry
