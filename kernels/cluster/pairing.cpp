#include "kernels/cluster/pairing.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <vector>

#include "engine/parallel/parallel.hpp"
#include "kernels/quality/flat_face.hpp"

namespace quarry {
namespace {

SideId canonical(const Mesh& mesh, SideId s) { return std::min(s, mesh.neighbour(s)); }

// A greedy matching by locally dominant rounds. Each free triangle points at its best free neighbour; who
// point at each other are paired.
class DominantRounds {
 public:
  DominantRounds(const Mesh& mesh, const std::vector<float>& worth, Pairing& pairing)
      : mesh_(mesh), worth_(worth), merged_(pairing.merged), best_(mesh.face_slots()) {}

  // Pairs what it can and returns the rounds that it took.
  std::uint64_t run() {
    std::vector<std::uint32_t> open =
        parallel::filter_indices(mesh_.face_slots(), [&](std::size_t i) { return is_free(FaceId(i)); });
    std::uint64_t rounds = 0;
    while (!open.empty()) {
      ++rounds;
      parallel::for_each(open.size(),
                         [&](std::size_t i) { best_[FaceId(open[i])] = best_side(FaceId(open[i])); });
      parallel::for_each(open.size(), [&](std::size_t i) { pair_if_mutual(FaceId(open[i])); });
      const auto kept = parallel::filter_indices(open.size(), [&](std::size_t i) {
        const FaceId f(open[i]);
        return best_[f].valid() && !merged_[f].valid();
      });
      std::vector<std::uint32_t> next(kept.size());
      parallel::for_each(kept.size(), [&](std::size_t i) { next[i] = open[kept[i]]; });
      open = std::move(next);
    }
    return rounds;
  }

 private:
  [[nodiscard]] bool is_free(FaceId f) const { return mesh_.alive(f) && !merged_[f].valid(); }

  // Written and read by the triangle itself between the two loops of a round.
  [[nodiscard]] SideId best_side(FaceId f) const {
    SideId best;
    for (int k = 0; k < 3; ++k) {
      const SideId s(f, k);
      const float mine = worth_[s.value()];
      if (mine < 0 || !is_free(mesh_.neighbour(s).face())) continue;
      const bool better = !best.valid() || mine > worth_[best.value()] ||
                          (mine == worth_[best.value()] && canonical(mesh_, s) < canonical(mesh_, best));
      if (better) best = s;
    }
    return best;
  }

  // Each triangle writes its own word only; its partner does the same.
  void pair_if_mutual(FaceId f) {
    const SideId s = best_[f];
    if (s.valid() && best_[mesh_.neighbour(s).face()] == mesh_.neighbour(s)) merged_[f] = s;
  }

  const Mesh& mesh_;
  const std::vector<float>& worth_;
  IdVector<FaceId, SideId>& merged_;
  IdVector<FaceId, SideId> best_;
};

void compute_worths(const Mesh& mesh, ConstraintTags tags, int pass, const PairingOptions& options,
                    const Pairing& pairing, std::vector<float>& worth) {
  const auto open = [&](FaceId f) { return mesh.alive(f) && !pairing.merged[f].valid(); };
  parallel::for_each(mesh.face_slots(), [&](std::size_t i) {
    for (int k = 0; k < 4; ++k) worth[i * 4 + static_cast<std::size_t>(k)] = -1.0F;
    const FaceId f(i);
    if (!open(f)) return;
    for (int k = 0; k < 3; ++k) {
      const SideId s(f, k);
      const SideId t = mesh.neighbour(s);
      if (t.valid() && open(t.face())) worth[s.value()] = pair_worth(mesh, tags, s, pass, options);
    }
  });
}

// The cosine of the angle between two triangles that may be merged, in space.
constexpr double kLeastFlatness = 0.5;

// Of the quad that merging across s makes.
double worst_corner(const Mesh& mesh, SideId s) {
  const auto v = merged_corners(mesh, s);
  if (mesh.planar())
    return worst_corner_signed_square(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]));
  const std::array<Vec3, 4> p = {mesh.point3(v[0]), mesh.point3(v[1]), mesh.point3(v[2]), mesh.point3(v[3])};
  const Vec3 n = cross(p[1] - p[0], p[2] - p[0]);
  const Vec3 m = cross(p[2] - p[0], p[3] - p[0]);
  if (!(dot(n, m) >= kLeastFlatness * length(n) * length(m))) return -1;
  const FlatFace flat(p);
  return worst_corner_signed_square(flat.corner(0), flat.corner(1), flat.corner(2), flat.corner(3));
}

}  // namespace

int pairing_passes(const PairingOptions& options) {
  return options.measure == PairMeasure::kLongestEdge ? 2 : 1;
}

float pair_worth(const Mesh& mesh, ConstraintTags tags, SideId side, int pass,
                 const PairingOptions& options) {
  if (tags.constrained(side)) return -1.0F;
  // From the smaller side, so that both triangles get the same bits.
  const SideId s = canonical(mesh, side);
  const double quality = worst_corner(mesh, s);
  if (!(quality >= options.convex_margin * options.convex_margin)) return -1.0F;
  if (options.measure == PairMeasure::kQuadQuality) return static_cast<float>(quality);
  if (pass == 0 && !longest_of_its_face(mesh, s) && !longest_of_its_face(mesh, mesh.neighbour(s)))
    return -1.0F;
  const Vec3 edge = mesh.point3(mesh.target(s)) - mesh.point3(mesh.origin(s));
  return static_cast<float>(dot(edge, edge));
}

Pairing pair_triangles(const Mesh& mesh, ConstraintTags tags, const PairingOptions& options,
                       PairingReport& report, const Progress& progress) {
  Pairing pairing;
  pairing.merged.resize(mesh.face_slots());
  std::vector<float> worth(mesh.face_slots() * 4);
  for (int pass = 0; pass < pairing_passes(options); ++pass) {
    progress.throw_if_cancelled();
    compute_worths(mesh, tags, pass, options, pairing, worth);
    report.rounds += DominantRounds(mesh, worth, pairing).run();
  }
  const auto count = [&](auto&& counts) {
    return parallel::reduce_ordered(
        mesh.face_slots(), std::uint64_t{0},
        [&](std::size_t begin, std::size_t end) {
          std::uint64_t sum = 0;
          for (std::size_t i = begin; i < end; ++i) sum += counts(FaceId(i)) ? 1 : 0;
          return sum;
        },
        [](std::uint64_t a, std::uint64_t b) { return a + b; });
  };
  report.pairs = count([&](FaceId f) { return pairing.merged[f].valid(); }) / 2;
  report.singles = count([&](FaceId f) { return mesh.alive(f) && !pairing.merged[f].valid(); });
  return pairing;
}

}  // namespace quarry
