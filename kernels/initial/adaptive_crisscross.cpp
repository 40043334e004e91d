#include "kernels/initial/adaptive_crisscross.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/mesh/compact.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/operation/pass.hpp"
#include "kernels/initial/crisscross.hpp"
#include "kernels/local/split.hpp"

namespace quarry {
namespace {

// Halving a triangle divides its legs by the square root of two; the fourth root of two is half-way.
constexpr double kFourthRootOf2 = 1.189207115002721;

// The longest side. Longer than the legs by nearly half, so that rounding cannot mistake it.
SideId base_of(const Mesh& mesh, FaceId f) {
  SideId base;
  double longest = -1;
  for (int k = 0; k < 3; ++k) {
    const SideId s(f, k);
    const double length = squared_length(mesh.point(mesh.target(s)) - mesh.point(mesh.origin(s)));
    if (length <= longest) continue;
    longest = length;
    base = s;
  }
  return base;
}

// Halves the triangle at an edge, the base of which it is; if the triangle across has another base, halves
// that one first. Each step of this chain goes to a triangle twice as large, so that it is short; two
// triangles of one cell of the start share their base, so that it ends.
class HalveTriangles {
 public:
  // The base of a triangle that is too large, with the triangle on its left.
  struct Item {
    VertexId from, to;
  };
  struct Plan {
    VertexId from, to;
  };

  HalveTriangles(ConstraintTags tags, const Box2& box, const SizeField& field, double finest)
      : tags_(tags), box_(box), field_(field), finest_(finest) {}

  [[nodiscard]] bool too_large(const Mesh& mesh, SideId base) const {
    const Vec2 a = mesh.point(mesh.origin(base));
    const Vec2 b = mesh.point(mesh.target(base));
    const double leg = distance(a, mesh.point(mesh.origin(mesh.previous(base))));
    if (leg <= finest_) return false;
    // A triangle lies within a leg of the middle of its base.
    const Vec2 middle = midpoint(a, b);
    if (!box_.grown(leg).contains(middle)) return false;
    const double size = field_.at(middle);
    if (!(size > 0))
      throw Error(ErrorKind::kInput, fmt::format("the size field is {} at {}: it must be positive", size,
                                                 format_point(middle.x, middle.y)));
    return leg > kFourthRootOf2 * size;
  }

  bool propose(const Mesh& mesh, Item item, Cavity& cavity, Plan& plan) const {
    SideId s = mesh.find_side(item.from, item.to);
    if (!s.valid()) return false;
    for (SideId across = mesh.neighbour(s); across.valid(); across = mesh.neighbour(s)) {
      const SideId base = base_of(mesh, across.face());
      if (base == across) break;
      s = base;
    }
    plan = {mesh.origin(s), mesh.target(s)};
    claim_split_edge(mesh, s, cavity);
    return true;
  }

  void apply(MeshEditor& editor, Item item, const Plan& plan, NewIds ids, FollowUps<Item>& follow_ups) const {
    const Mesh& mesh = editor.mesh();
    const SideId s = mesh.find_side(plan.from, plan.to);
    const Vec2 middle = midpoint(mesh.point(plan.from), mesh.point(plan.to));
    const VertexId m = split_edge(editor, tags_, s, middle, Support::free(), ids);
    if (plan.from != item.from || plan.to != item.to) follow_ups.push_back(item);
    for_each_side_around(mesh, m, [&](SideId around) {
      const SideId base = base_of(mesh, around.face());
      if (too_large(mesh, base)) follow_ups.push_back({mesh.origin(base), mesh.target(base)});
    });
  }

 private:
  ConstraintTags tags_;
  Box2 box_;
  const SizeField& field_;
  double finest_;
};

}  // namespace

Mesh make_adaptive_crisscross(const Box2& box, const SizeField& field,
                              const AdaptiveCrisscrossOptions& options, const Progress& progress,
                              PassReport* report) {
  Mesh mesh = make_crisscross(box, {.cell = options.coarsest, .angle_degrees = options.angle_degrees});
  compact(mesh, EntityOrder::kHilbert);
  const HalveTriangles operation(ConstraintTags::add_to(mesh), box, field, options.finest);
  std::vector<HalveTriangles::Item> work;
  for (const FaceId f : mesh.faces())
    if (const SideId base = base_of(mesh, f); operation.too_large(mesh, base))
      work.push_back({mesh.origin(base), mesh.target(base)});
  PassReport halvings = run_pass(mesh, operation, std::move(work), PassOptions(), progress);
  halvings.name = "halvings of the start mesh";
  if (report != nullptr) *report = std::move(halvings);
  mesh.remove_tag<VertexId>("support");
  mesh.remove_tag<FaceId>("constrained_sides");
  compact(mesh, EntityOrder::kHilbert);
  return mesh;
}

}  // namespace quarry
