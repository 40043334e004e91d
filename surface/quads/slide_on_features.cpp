#include "surface/quads/slide_on_features.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "engine/parallel/parallel.hpp"
#include "surface/quads/face_verdict.hpp"

namespace quarry {
namespace {

// Of the way to the neighbours on the curve, one after the other.
constexpr std::array kShares = {0.2, 0.1, 0.05, 0.02};
// What lies farther away than so many steps is another part of the curve.
constexpr double kFarthest = 1.5;
// No face may become worse that is worse than this.
constexpr double kContent = 0.3;
// Nor turn by more than this, which normals do not tell where all corners are on features: the cosine.
constexpr double kLeastTurn = 0.7;
// A smaller gain, in the sum over the faces, is not worth a move.
constexpr double kLeastGain = 0.01;

class SlideMover {
 public:
  SlideMover(const Mesh& mesh, const ConstraintTags& tags, const CurveNetwork& network)
      : tags_(&tags), network_(&network), normals_(mesh.normals()) {}

  [[nodiscard]] bool may_move(VertexId v) const { return tags_->support[v].slides(); }
  void first_look(const Mesh& mesh, WakeList& list) const {
    parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
      if (mesh.alive(VertexId(i))) list.wake(VertexId(i));
    });
  }

  bool move(Mesh& mesh, VertexId v) {
    const Vec3 place = mesh.point3(v);
    const PieceId curve = tags_->support[v].piece();
    const Verdict before = verdict(mesh, v);
    directions_.clear();
    for_each_side_around(mesh, v, [&](SideId s) { directions_.push_back(direction(mesh, s.face())); });
    std::array<Vec3, 2> ends;
    std::size_t count = 0;
    for_each_constrained_neighbour(mesh, *tags_, v, [&](VertexId w) {
      if (count < ends.size()) ends[count] = mesh.point3(w);
      ++count;
    });
    if (count != ends.size()) return false;
    for (const double share : kShares)
      for (const Vec3 end : ends) {
        const Vec3 target = network_->project(curve, place + share * (end - place));
        if (length(target - place) > kFarthest * share * length(end - place)) continue;
        mesh.set_point3(v, target);
        const Verdict after = verdict(mesh, v);
        if (after.sum > before.sum + kLeastGain && after.worst >= std::min(kContent, before.worst) &&
            turns_little(mesh, v))
          return true;
      }
    mesh.set_point3(v, place);
    return false;
  }

 private:
  struct Verdict {
    double sum = 0, worst = 1;
  };
  [[nodiscard]] Verdict verdict(const Mesh& mesh, VertexId v) const {
    Verdict result;
    for_each_side_around(mesh, v, [&](SideId s) {
      const double one = face_verdict(mesh, normals_, s.face());
      result.sum += one;
      result.worst = std::min(result.worst, one);
    });
    return result;
  }

  // Along the normal of a face.
  [[nodiscard]] static Vec3 direction(const Mesh& mesh, FaceId f) {
    const auto corner = [&](int k) { return mesh.point3(mesh.corner(f, k)); };
    return cross(corner(2) - corner(0), corner(mesh.corner_count(f) - 1) - corner(1));
  }
  [[nodiscard]] bool turns_little(const Mesh& mesh, VertexId v) const {
    std::size_t k = 0;
    bool little = true;
    for_each_side_around(mesh, v, [&](SideId s) {
      const Vec3 now = direction(mesh, s.face()), then = directions_[k++];
      little = little && dot(now, then) >= kLeastTurn * length(now) * length(then);
    });
    return little;
  }

  const ConstraintTags* tags_;
  const CurveNetwork* network_;
  Tag<VertexId, Vec3> normals_;
  std::vector<Vec3> directions_;  // of the faces around the vertex at hand
};

}  // namespace

SweepReport slide_on_features(Mesh& mesh, const ConstraintTags& tags, const CurveNetwork& network, int sweeps,
                              const Progress& progress) {
  VertexColouring colouring(mesh);
  return run_sweeps(mesh, colouring, SlideMover(mesh, tags, network), sweeps, progress);
}

}  // namespace quarry
