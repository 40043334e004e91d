#include "pipeline/split/split_fractures.hpp"

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/mesh/build.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/pinch.hpp"
#include "engine/mesh/sectors.hpp"
#include "io/mesh/mesh_file.hpp"
#include "pipeline/split/line_directions.hpp"

namespace quarry {
namespace {

// An edge by the sides that it is: along its line, and against it.
struct EdgeSides {
  SideId along, against;

  [[nodiscard]] bool both() const { return along.valid() && against.valid(); }
};

std::vector<EdgeSides> find_sides(const Mesh& mesh) {
  const std::vector<bool> backward = find_backward_edges(mesh);
  std::vector<EdgeSides> sides;
  for (const EdgeId e : mesh.edges()) {
    auto [a, b] = mesh.edge_ends(e);
    if (backward[e.value()]) std::swap(a, b);
    sides.push_back({mesh.find_side(a, b), mesh.find_side(b, a)});
  }
  return sides;
}

// The same faces over the vertices that they have now: the edges are still to come.
Mesh rebuild(const Mesh& mesh) {
  std::vector<FaceCorners> faces;
  for (const FaceId f : mesh.faces()) {
    FaceCorners corners;
    for (int k = 0; k < mesh.corner_count(f); ++k) corners[static_cast<std::size_t>(k)] = mesh.corner(f, k);
    faces.push_back(corners);
  }
  return mesh.planar() ? build_mesh(mesh.xs(), mesh.ys(), faces)
                       : build_mesh(mesh.xs(), mesh.ys(), mesh.zs(), faces);
}

template <class IdType, class T>
void copy_tag(const Mesh& from, Mesh& to, const char* name) {
  const auto values = from.find_tag<IdType, T>(name);
  if (!values.valid()) return;
  auto copy = to.add_tag<IdType, T>(name);
  for (std::size_t i = 0; i < values.values().size(); ++i) copy[IdType(i)] = values[IdType(i)];
}

class SplitEdges {
 public:
  explicit SplitEdges(Mesh& mesh)
      : mesh_(mesh),
        constraint_(mesh.add_tag<EdgeId, std::int32_t>("constraint", -1)),
        kind_(mesh.add_tag<EdgeId, std::int32_t>("kind", kInteriorConstraint)),
        side_(mesh.add_tag<EdgeId, std::int32_t>(kSideTag, 0)) {}

  void add(VertexId a, VertexId b, std::int32_t constraint, std::int32_t kind, std::int32_t side) {
    const EdgeId e = mesh_.add_edge(a, b);
    constraint_[e] = constraint;
    kind_[e] = kind;
    side_[e] = side;
  }

 private:
  Mesh& mesh_;
  Tag<EdgeId, std::int32_t> constraint_, kind_, side_;
};

}  // namespace

Mesh split_fractures(Mesh&& whole, SplitReport& report) {
  Mesh mesh = std::move(whole);
  const MeshFileTags tags(mesh);
  const std::vector<EdgeSides> sides = find_sides(mesh);
  std::vector<std::int32_t> kinds;
  for (const EdgeId e : mesh.edges()) kinds.push_back(tags.kind(e));
  mesh.remove_tag<VertexId>("support");
  mesh.remove_tag<FaceId>("constrained_sides");
  auto constraints = ConstraintTags::add_to(mesh);
  const auto is_split = [&](EdgeId e) {
    return kinds[e.value()] == kInteriorConstraint && sides[e.value()].both();
  };
  for (const EdgeId e : mesh.edges())
    if (is_split(e))
      for (const SideId side : {sides[e.value()].along, sides[e.value()].against})
        constraints.set_constrained(side, true);
  const std::size_t vertices = mesh.vertex_slots();
  cut_open(mesh, constraints);
  report.new_nodes = mesh.vertex_slots() - vertices;

  Mesh split = rebuild(mesh);
  copy_tag<FaceId, std::int32_t>(mesh, split, "region");
  copy_tag<VertexId, std::uint8_t>(mesh, split, kPinchTag);
  SplitEdges edges(split);
  for (const EdgeId e : mesh.edges()) {
    const auto [along, against] = sides[e.value()];
    const std::int32_t constraint = tags.constraint(e), kind = kinds[e.value()];
    if (is_split(e)) {
      ++report.edges;
      edges.add(mesh.origin(along), mesh.target(along), constraint, kind, kLeftSide);
      edges.add(mesh.target(against), mesh.origin(against), constraint, kind, kRightSide);
    } else if (along.valid()) {
      edges.add(mesh.origin(along), mesh.target(along), constraint, kind, 0);
    } else if (against.valid()) {
      edges.add(mesh.target(against), mesh.origin(against), constraint, kind, 0);
    } else {
      edges.add(mesh.edge_ends(e).first, mesh.edge_ends(e).second, constraint, kind, 0);
    }
  }
  return split;
}

}  // namespace quarry
