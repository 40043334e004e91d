// Lines worked into each kind of start mesh: what start meshes are for.
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "engine/mesh/constraint.hpp"
#include "engine/mesh/validate.hpp"
#include "kernels/deferred/deferred.hpp"
#include "kernels/field/graded_size.hpp"
#include "kernels/initial/adaptive_crisscross.hpp"
#include "kernels/initial/delaunay.hpp"
#include "kernels/initial/given.hpp"
#include "tests/support/noded_lines.hpp"

namespace quarry {
namespace {

const Box2 kBox{{465'000.25, 6'691'000.75}, {465'100.25, 6'691'100.75}};

// Each node is a vertex with its bits, and each piece has constrained edges of its whole length.
void expect_lines_inserted(Mesh mesh, const NodedLines& lines) {
  auto tags = ConstraintTags::add_to(mesh);
  for (const VertexId v : mesh.vertices())
    if (mesh.on_boundary(v)) tags.support[v] = Support::fixed();
  DeferredOptions options;
  options.spacing = 2;
  DeferredReport report;
  const InsertedLines inserted = insert_lines(mesh, lines, options, report, Progress());
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  for (std::size_t i = 0; i < lines.nodes.size(); ++i)
    EXPECT_EQ(mesh.point(inserted.vertex_of_node[NodeId(i)]), lines.nodes[NodeId(i)]);
  double wanted = 0;
  for (const Piece& piece : lines.pieces) wanted += distance(lines.nodes[piece.from], lines.nodes[piece.to]);
  double found = 0;
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < 3; ++k)
      if (const SideId s(f, k); mesh.alive(f) && tags.constrained(s))
        found += 0.5 * distance(mesh.point(mesh.origin(s)), mesh.point(mesh.target(s)));
  EXPECT_NEAR(found, wanted, 1e-6 * wanted);
}

std::vector<std::pair<std::string, NodedLines>> line_sets() {
  std::vector<std::pair<std::string, NodedLines>> sets;
  sets.emplace_back("star of 64", test::star({465'050.3, 6'691'049.8}, 40, 64));
  sets.emplace_back("random, seed 3", test::random_segments(3, 300, 100, 0.05, kBox.low));
  return sets;
}

TEST(DelaunayStart, TakesLines) {
  for (const auto& [name, lines] : line_sets()) {
    SCOPED_TRACE(name);
    expect_lines_inserted(make_delaunay(kBox, {.spacing = 2, .angle_degrees = 10}), lines);
  }
}

TEST(FourTriangles, TakeAnyNumberOfLines) {
  for (const auto& [name, lines] : line_sets()) {
    SCOPED_TRACE(name);
    expect_lines_inserted(make_four_triangles(kBox), lines);
  }
}

TEST(AdaptiveCrisscrossStart, TakesLines) {
  for (const auto& [name, lines] : line_sets()) {
    SCOPED_TRACE(name);
    const GradedSize field({{{kBox.center(), kBox.center()}, 0.5}}, {.largest = 8, .gradation = 0.3});
    expect_lines_inserted(make_adaptive_crisscross(kBox, field, {.coarsest = 8, .finest = 0.1}, Progress()),
                          lines);
  }
}

}  // namespace
}  // namespace quarry
