#include "kernels/cluster/rearrange.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/geometry/predicates.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cluster/patch.hpp"
#include "kernels/quality/element.hpp"

namespace quarry {
namespace {

// What a vertex costs that has `excess` more faces than wanted.
double valence_cost(int excess) {
  constexpr std::array<double, 6> kMore = {0, 1, 2.2, 4, 6, 9};
  if (excess >= 0) return kMore[static_cast<std::size_t>(std::min(excess, 5))];
  return excess == -1 ? 1.0 : 5.0 * static_cast<double>(-excess);
}

class RearrangeOperation {
 public:
  using Item = std::uint32_t;  // a face
  struct Plan {
    std::array<FaceId, Patch::kMostFaces> faces;
    int face_count = 0;
    int dissection = 0;
  };

  RearrangeOperation(const Mesh& mesh, ConstraintTags tags, const RearrangeOptions& options)
      : tags_(tags),
        options_(options),
        wanted_(mesh.vertex_slots(), 4),
        faces_at_(mesh.vertex_slots(), 0),
        shape_(mesh.face_slots(), 0) {
    parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
      const VertexId v(i);
      if (!mesh.alive(v)) return;
      int faces = 0;
      for_each_side_around(mesh, v, [&](SideId) { ++faces; });
      faces_at_[v] = static_cast<std::uint16_t>(faces);
      if (mesh.on_boundary(v)) wanted_[v] = wanted_on_rim(mesh, v);
    });
    parallel::for_each(mesh.face_slots(), [&](std::size_t i) {
      if (mesh.alive(FaceId(i))) shape_[FaceId(i)] = compute_shape(mesh, FaceId(i));
    });
  }

  // Faces that are triangles or touch a vertex that has not the wanted number of faces.
  [[nodiscard]] std::vector<Item> first_items(const Mesh& mesh) const {
    return parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) { return wants(mesh, FaceId(i)); });
  }

  bool propose(const Mesh& mesh, Item item, Cavity& cavity, Plan& plan) const {
    const FaceId seed(item);
    if (!mesh.alive(seed) || !wants(mesh, seed)) return false;
    Search search{*this, mesh, plan};
    search.grow(seed);
    if (mesh.corner_count(seed) == 3) search.chains(seed);
    if (plan.face_count == 0) return false;
    Patch patch;
    (void)patch.gather(mesh, tags_, std::span(plan.faces).first(static_cast<std::size_t>(plan.face_count)));
    for (int i = 0; i < patch.corners(); ++i) cavity.claim(patch.vertex(i));
    const int faces = dissections(patch.corners())[static_cast<std::size_t>(plan.dissection)].face_count;
    cavity.will_create(0, static_cast<std::uint32_t>(std::max(0, faces - plan.face_count)));
    return true;
  }

  void apply(MeshEditor& editor, Item, const Plan& plan, NewIds ids, FollowUps<Item>& follow_ups) const {
    Patch patch;
    (void)patch.gather(editor.mesh(), tags_,
                       std::span(plan.faces).first(static_cast<std::size_t>(plan.face_count)));
    const Dissection& cut = dissections(patch.corners())[static_cast<std::size_t>(plan.dissection)];
    for (int i = 0; i < patch.corners(); ++i) {
      auto& faces = faces_at_[patch.vertex(i)];
      faces =
          static_cast<std::uint16_t>(faces + cut.faces_at[static_cast<std::size_t>(i)] - patch.faces_at(i));
    }
    patch.apply(editor, tags_, cut, ids);
    for (int i = 0; i < std::min(cut.face_count, plan.face_count); ++i) {
      const FaceId f = plan.faces[static_cast<std::size_t>(i)];
      if (f.value() < shape_.size()) shape_[f] = compute_shape(editor.mesh(), f);
      follow_ups.push_back(f.value());
    }
    for (int i = 0; i < patch.corners(); ++i)
      if (patch.across(i).valid()) follow_ups.push_back(patch.across(i).face().value());
  }

 private:
  // Looks for the patch around a face whose best new cut gains most.
  struct Search {
    const RearrangeOperation& operation;
    const Mesh& mesh;
    Plan& plan;
    double gain = 1e-6;
    std::array<FaceId, Patch::kMostFaces> faces{};
    int count = 0;

    void grow(FaceId f) {
      faces[static_cast<std::size_t>(count++)] = f;
      if (count >= 2 || mesh.corner_count(f) == 4) offer();
      if (count < operation.options_.most_faces) {
        // Next faces of those that are in, in the order of the sides; a face is added after its predecessor
        // only.
        for (int i = 0; i < count; ++i)
          for_each_open_neighbour(faces[static_cast<std::size_t>(i)], [&](FaceId g) { grow(g); });
      }
      --count;
    }

    // Chains of quads from one triangle to another.
    void chains(FaceId triangle) {
      faces[0] = triangle;
      count = 1;
      extend_chain();
      count = 0;
    }
    void extend_chain() {
      for_each_open_neighbour(faces[static_cast<std::size_t>(count - 1)], [&](FaceId g) {
        const bool triangle = mesh.corner_count(g) == 3;
        if (!triangle && count - 1 >= operation.options_.longest_chain) return;
        faces[static_cast<std::size_t>(count++)] = g;
        if (triangle && count > operation.options_.most_faces) offer();
        if (!triangle) extend_chain();
        --count;
      });
    }

    template <class Visit>
    void for_each_open_neighbour(FaceId f, Visit&& visit) {
      for (int k = 0; k < mesh.corner_count(f); ++k) {
        const SideId s(f, k);
        if (!mesh.neighbour(s).valid() || operation.tags_.constrained(s)) continue;
        const FaceId g = mesh.neighbour(s).face();
        if (std::find(faces.begin(), faces.begin() + count, g) == faces.begin() + count) visit(g);
      }
    }

    void offer() {
      Patch patch;
      const auto all = std::span<const FaceId>(faces).first(static_cast<std::size_t>(count));
      if (!patch.gather(mesh, operation.tags_, all)) return;
      const int cut = operation.best_cut(mesh, patch, gain);
      if (cut < 0) return;
      plan.faces = faces;
      plan.face_count = count;
      plan.dissection = cut;
    }
  };

  [[nodiscard]] static std::uint8_t wanted_on_rim(const Mesh& mesh, VertexId v) {
    double angle = 0;
    for_each_side_around(mesh, v, [&](SideId s) {
      angle +=
          corner_angle(mesh.point(mesh.origin(mesh.previous(s))), mesh.point(v), mesh.point(mesh.target(s)));
    });
    return static_cast<std::uint8_t>(std::max(1.0, std::round(angle / 90.0)));
  }

  [[nodiscard]] bool wants(const Mesh& mesh, FaceId f) const {
    if (!mesh.alive(f)) return false;
    const int count = mesh.corner_count(f);
    if (count == 3) return true;
    for (int k = 0; k < count; ++k)
      if (faces_at_[mesh.corner(f, k)] != wanted_[mesh.corner(f, k)]) return true;
    return shape(mesh, f) < options_.flat_sine;
  }

  [[nodiscard]] double face_cost(double sine) const {
    return options_.shape_weight * (1 - sine) +
           options_.flat_weight * std::max(0.0, options_.flat_sine - sine);
  }
  [[nodiscard]] double vertex_cost(VertexId v, int change) const {
    return valence_cost(static_cast<int>(faces_at_[v]) + change - static_cast<int>(wanted_[v]));
  }

  // Sine of the face's worst corner, times min(1, 4 shortest edge / longest edge).
  static double shape(std::span<const Vec2> p) {
    const EdgeRange edges = p.size() == 3 ? edge_range(p[0], p[1], p[2]) : edge_range(p[0], p[1], p[2], p[3]);
    const double sine = p.size() == 3 ? kSqrt3 / 2 * scaled_jacobian(p[0], p[1], p[2])
                                      : scaled_jacobian(p[0], p[1], p[2], p[3]);
    return sine > 0 ? sine * std::min(1.0, 4 * edges.shortest / edges.longest) : sine;
  }
  static double compute_shape(const Mesh& mesh, FaceId f) {
    std::array<Vec2, 4> p;
    const auto count = static_cast<std::size_t>(mesh.corner_count(f));
    for (std::size_t k = 0; k < count; ++k) p[k] = mesh.point(mesh.corner(f, static_cast<int>(k)));
    return shape(std::span<const Vec2>(p).first(count));
  }
  [[nodiscard]] double shape(const Mesh& mesh, FaceId f) const {
    return f.value() < shape_.size() ? shape_[f] : compute_shape(mesh, f);
  }
  static bool turns_left(std::span<const Vec2> p) {
    for (std::size_t i = 0; i < p.size(); ++i)
      if (!(orient2d(p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()]) > 0)) return false;
    return true;
  }

  // The dissection that gains more than `gain` and most, or -1; gain becomes what it gains.
  int best_cut(const Mesh& mesh, const Patch& patch, double& gain) const {
    double old_cost = 0;
    double floor = options_.min_sine;
    for (const FaceId f : patch.faces()) {
      const double sine = shape(mesh, f);
      floor = std::min(floor, sine);
      old_cost += face_cost(sine) + (mesh.corner_count(f) == 3 ? 1 : 0);
    }
    // Of each corner: its place, and what it costs with so many faces of the patch.
    std::array<Vec2, kMostPolygonCorners> points;
    std::array<std::array<double, Dissection::kMostFaces + 1>, kMostPolygonCorners> corner_cost;
    const auto corners = static_cast<std::size_t>(patch.corners());
    for (std::size_t i = 0; i < corners; ++i) {
      const VertexId v = patch.vertex(static_cast<int>(i));
      const int now = patch.faces_at(static_cast<int>(i));
      points[i] = mesh.point(v);
      old_cost += vertex_cost(v, 0);
      for (int faces = 1; faces <= Dissection::kMostFaces; ++faces)
        corner_cost[i][static_cast<std::size_t>(faces)] = vertex_cost(v, faces - now);
    }
    const auto cuts = dissections(patch.corners());
    int best = -1;
    for (std::size_t c = 0; c < cuts.size(); ++c) {
      double cost = cuts[c].triangle_count;
      for (std::size_t i = 0; i < corners; ++i) cost += corner_cost[i][cuts[c].faces_at[i]];
      // Shapes only add to the cost.
      if (old_cost - cost <= gain) continue;
      cost += shape_cost(cuts[c], points, floor, old_cost - cost - gain);
      if (old_cost - cost <= gain) continue;
      gain = old_cost - cost;
      best = static_cast<int>(c);
    }
    return best;
  }

  // Infinite if a face is worse than the floor or does not turn left; may stop once beyond the limit.
  [[nodiscard]] double shape_cost(const Dissection& cut, const std::array<Vec2, kMostPolygonCorners>& points,
                                  double floor, double limit) const {
    double cost = 0;
    for (int i = 0; i < cut.face_count; ++i) {
      std::array<Vec2, 4> p;
      std::size_t count = 0;
      for (const std::uint8_t corner : cut.faces[static_cast<std::size_t>(i)])
        if (corner != Dissection::kNone) p[count++] = points[corner];
      const auto face = std::span<const Vec2>(p).first(count);
      const double sine = shape(face);
      if (sine < floor || !turns_left(face)) return std::numeric_limits<double>::infinity();
      cost += face_cost(sine);
      if (cost > limit) break;
    }
    return cost;
  }

  ConstraintTags tags_;
  RearrangeOptions options_;
  IdVector<VertexId, std::uint8_t> wanted_;
  // Written by who has claimed the vertex.
  mutable IdVector<VertexId, std::uint16_t> faces_at_;
  // Of the faces that were there at first; written by who has claimed all corners.
  mutable IdVector<FaceId, double> shape_;
};

}  // namespace

PassReport rearrange(Mesh& mixed, const RearrangeOptions& options, const Progress& progress) {
  const RearrangeOperation operation(mixed, ConstraintTags::of(mixed), options);
  PassReport report = run_pass(mixed, operation, operation.first_items(mixed),
                               {.window = 16384, .cutoff = 2, .reverse = false}, progress);
  report.name = "rearrange";
  return report;
}

}  // namespace quarry
