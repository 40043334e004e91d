#include "surface/remesh/relocate.hpp"

#include <vector>

#include "surface/remesh/moving_star.hpp"

namespace quarry {
namespace {

// A vertex that would move by less than this share of the wanted edge stays.
constexpr double kSmallestMove = 0.02;
// More than any measure.
constexpr double kAll = 2;
// How far the nearest point of the surface may lie from a target, in lengths of the step.
constexpr double kSheetJump = 1.5;

class RelocateMover {
 public:
  // Stars whose triangles all have at least this measure are left alone.
  RelocateMover(const RemeshState& state, double content) : state_(&state), star_(state), content_(content) {}

  [[nodiscard]] bool may_move(VertexId v) const {
    const Support support = state_->tags.support[v];
    return state_->mesh.alive(v) && !support.is_fixed();
  }
  void first_look(const Mesh& mesh, WakeList& list) const {
    parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) { list.wake(VertexId(i)); });
  }

  bool move(Mesh& mesh, VertexId v) {
    star_.gather(v);
    if (star_.worst() >= content_) return false;
    place_ = mesh.point3(v);
    wanted_ = state_->wanted_edge(v);
    const Support support = state_->tags.support[v];
    return support.is_free() ? move_free(mesh, v) : move_along(mesh, v, support.piece());
  }

 private:
  [[nodiscard]] bool is_small(Vec3 step) const { return !(length(step) > kSmallestMove * wanted_); }

  bool move_free(Mesh& mesh, VertexId v) {
    Vec3 sum;
    double weight = 0;
    for (const MovingStar::Corner& c : star_.corners()) {
      const Vec3 out = c.points[1] - place_;
      const Vec3 back = c.points[2] - place_;
      const double area = length(cross(out, back));
      sum = sum + (area / 3) * (out + back);
      weight += area;
    }
    if (!(weight > 0)) return false;
    Vec3 step = (1 / weight) * sum;
    const Vec3 normal = state_->normals[v];
    step = step - dot(step, normal) * normal;
    for (int attempt = 0; attempt < 2 && !is_small(step); ++attempt, step = 0.5 * step) {
      const SurfacePoint foot = state_->model.nearest({place_ + step, normal});
      if (length(foot.position - (place_ + step)) > kSheetJump * length(step)) continue;
      const Vec3 up = state_->model.with_normal(foot).up;
      if (!star_.fits(foot.position, up, state_->options.content)) continue;
      put(mesh, v, foot.position, up);
      auto wanted = state_->wanted;
      wanted[v] = state_->sizes.at(foot);
      return true;
    }
    return false;
  }

  bool move_along(Mesh& mesh, VertexId v, PieceId curve) {
    std::vector<Vec3> ends;
    for_each_constrained_neighbour(mesh, state_->tags, v,
                                   [&](VertexId w) { ends.push_back(mesh.point3(w)); });
    if (ends.size() != 2) return false;
    const Vec3 target = state_->network.project(curve, 0.5 * (ends[0] + ends[1]));
    if (is_small(target - place_) || !star_.fits(target, Vec3(), state_->options.content)) return false;
    put(mesh, v, target, Vec3());
    return true;
  }

  void put(Mesh& mesh, VertexId v, Vec3 place, Vec3 normal) const {
    mesh.set_point3(v, place);
    auto normals = state_->normals;
    normals[v] = normal;
  }

  const RemeshState* state_;
  MovingStar star_;
  Vec3 place_;
  double wanted_ = 0;
  double content_;
};

SweepReport relocate(RemeshState& state, double content, int sweeps, const Progress& progress) {
  VertexColouring colouring(state.mesh);
  return run_sweeps(state.mesh, colouring, RelocateMover(state, content), sweeps, progress);
}

}  // namespace

SweepReport relocate_vertices(RemeshState& state, int sweeps, const Progress& progress) {
  return relocate(state, kAll, sweeps, progress);
}

SweepReport relocate_below(RemeshState& state, double measure, int sweeps, const Progress& progress) {
  return relocate(state, measure, sweeps, progress);
}

}  // namespace quarry
