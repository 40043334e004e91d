#include "surface/lattice/snap.hpp"

#include <array>
#include <vector>

#include "surface/remesh/moving_star.hpp"

namespace quarry {
namespace {

// Of the way to the lattice point, one after the other.
constexpr std::array kShares = {1.0, 0.5, 0.25};
// A vertex that is nearer to its place than this share of the spacing stays.
constexpr double kSmallestMove = 0.005;
// The nearest place to a point that lies farther away from its vertex, in spacings, is on another sheet.
constexpr double kSheetJump = 1.5;

class SnapMover {
 public:
  SnapMover(const LatticeState& state, const std::vector<SpacePoint>& targets, double content)
      : state_(&state.base), targets_(&targets), star_(state.base), content_(content) {}

  [[nodiscard]] bool may_move(VertexId v) const {
    return state_->mesh.alive(v) && !state_->tags.support[v].is_fixed();
  }
  void first_look(const Mesh& mesh, WakeList& list) const {
    parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) { list.wake(VertexId(i)); });
  }

  bool move(Mesh& mesh, VertexId v) {
    const SpacePoint& target = (*targets_)[v.value()];
    const Vec3 place = mesh.point3(v);
    const Vec3 step = target.place - place;
    if (!(length(step) > kSmallestMove * state_->wanted_edge(v))) return false;
    star_.gather(v);
    for (const double share : kShares) {
      const SpacePoint to = share == 1 ? target : on_surface(v, place + share * step);
      if (!star_.fits(to.place, to.up, content_)) continue;
      mesh.set_point3(v, to.place);
      auto normals = state_->normals;
      normals[v] = to.up;
      return true;
    }
    return false;
  }

  [[nodiscard]] static SpacePoint on_surface(const RemeshState& state, VertexId v, Vec3 place) {
    const Support support = state.tags.support[v];
    if (support.is_free()) return state.model.project({place, state.normals[v]});
    return {support.slides() ? state.network.project(support.piece(), place) : state.point(v), Vec3()};
  }

 private:
  [[nodiscard]] SpacePoint on_surface(VertexId v, Vec3 place) const { return on_surface(*state_, v, place); }

  const RemeshState* state_;
  const std::vector<SpacePoint>* targets_;
  MovingStar star_;
  double content_;
};

}  // namespace

SweepReport snap_to_lattice(LatticeState& state, int sweeps, double content, const Progress& progress) {
  const Mesh& mesh = state.base.mesh;
  std::vector<SpacePoint> targets(mesh.vertex_slots());
  parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (!mesh.alive(v)) return;
    targets[i] = SnapMover::on_surface(state.base, v, state.place[v]);
    if (length(targets[i].place - mesh.point3(v)) > kSheetJump * state.base.wanted_edge(v))
      targets[i] = {mesh.point3(v), state.base.normals[v]};
  });
  VertexColouring colouring(mesh);
  return run_sweeps(state.base.mesh, colouring, SnapMover(state, targets, content), sweeps, progress);
}

}  // namespace quarry
