#include "kernels/matching/matching.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/base/random.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/operation/editor.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/matching/merge_join.hpp"
#include "kernels/matching/quad_shape.hpp"
#include "kernels/matching/spanning_forest.hpp"
#include "kernels/matching/whole_outline.hpp"
#include "tests/kernels/matching/triangle_meshes.hpp"
#include "tests/support/charge.hpp"
#include "tests/support/mesh_arrays.hpp"
#include "tests/support/mesh_zoo.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry {
namespace {

using test::boundary_of;
using test::constraints_of;
using test::Ends;

double area_of(const Mesh& mesh) {
  double doubled = 0;
  for (const FaceId f : mesh.faces())
    for (int k = 0; mesh.alive(f) && k < mesh.corner_count(f); ++k)
      doubled += cross(mesh.point(mesh.origin(SideId(f, k))), mesh.point(mesh.target(SideId(f, k))));
  return 0.5 * doubled;
}

bool all_quads(const Mesh& mesh) {
  for (const FaceId f : mesh.faces())
    if (mesh.corner_count(f) != 4) return false;
  return true;
}

MatchingOptions frozen() {
  MatchingOptions options;
  options.keep_boundary = true;
  return options;
}

MatchingOptions counting() {
  MatchingOptions options;
  options.require_valid = false;
  return options;
}

NodedLines no_lines() {
  NodedLines lines;
  lines.line_begin.push_back(0);
  return lines;
}

// Vertices keep their numbers: prepared is the triangle mesh after edges were halved.
void expect_quads_of(const Mesh& prepared_boundary_holder, const Ends& boundary, const Ends& constraints,
                     const Mesh& quads) {
  EXPECT_TRUE(all_quads(quads));
  EXPECT_EQ(validate(quads, GeometryCheck::kNone), "");
  EXPECT_EQ(boundary_of(quads), boundary);
  EXPECT_EQ(constraints_of(quads), constraints);
  EXPECT_EQ(test::charge_of(quads), test::charge_of(prepared_boundary_holder));
}

TEST(Matching, KeepsBoundaryConstraintsAndChargeOnEverySyntheticMesh) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test::SyntheticMesh made = test::make_synthetic({.seed = seed, .crooked_lines = 16});
    MatchingReport report;
    prepare_for_join(made.mesh, made.tags, made.lines, {}, report, Progress());
    ASSERT_EQ(validate(made.mesh, GeometryCheck::kPlanarCorners), "");
    const DualArcs join = find_join(made.mesh, made.tags, {}, report, Progress());
    for (const FaceId f : made.mesh.faces()) ASSERT_EQ(matching::degree(join[f]) % 2, 1);
    Mesh again = test::make_synthetic({.seed = seed, .crooked_lines = 16}).mesh;
    MatchingReport other;
    prepare_for_join(again, ConstraintTags::of(again), made.lines, {}, other, Progress());
    const Mesh quads = merge_join(std::move(again), join);
    expect_quads_of(made.mesh, boundary_of(made.mesh), constraints_of(made.mesh), quads);
    EXPECT_EQ(quads.face_slots(), made.mesh.face_slots() / 2 + count_steiner_points(join));
    EXPECT_NEAR(area_of(quads), area_of(made.mesh), 1e-5);
  }
}

TEST(Matching, MakesEveryRegionEvenByHalvingEdgesThatLieOnTheirPieces) {
  std::uint64_t odd = 0;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test::SyntheticMesh made = test::make_synthetic({.seed = seed, .crooked_lines = 40});
    const std::size_t vertices = made.mesh.vertex_slots();
    MatchingReport report;
    prepare_for_join(made.mesh, made.tags, made.lines, {}, report, Progress());
    odd += report.parity.odd_regions;
    const auto root = maximum_spanning_forest(made.mesh, pair_shapes(made.mesh, made.tags)).root;
    std::vector<int> faces(made.mesh.face_slots(), 0);
    for (const FaceId f : made.mesh.faces()) ++faces[root[f].value()];
    for (const int count : faces) EXPECT_EQ(count % 2, 0);
    EXPECT_LE(report.parity.halved_edges, 3 * report.parity.odd_regions);
    for (std::size_t i = vertices; i < made.mesh.vertex_slots(); ++i) {
      const Support support = made.tags.support[VertexId(i)];
      if (support.slides()) {
        EXPECT_LT(support.piece().value(), made.lines.pieces.size());
      }
    }
  }
  EXPECT_GT(odd, 0U);
}

double constrained_length(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b] : constraints_of(mesh)) sum += distance(mesh.point(a), mesh.point(b));
  return sum;
}

TEST(Matching, KeepsLinesThroughSmoothingOpeningsAndRings) {
  std::uint64_t openings = 0, rings = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test::SyntheticMesh made = test::make_synthetic({.seed = seed, .crooked_lines = 20});
    const double length = constrained_length(made.mesh);
    const double area = area_of(made.mesh);
    const int charge = test::charge_of(made.mesh);
    MatchingReport report;
    const Mesh quads =
        make_quads_by_matching(std::move(made.mesh), made.lines, counting(), report, Progress());
    EXPECT_EQ(validate(quads, GeometryCheck::kNone), "");
    EXPECT_TRUE(all_quads(quads));
    EXPECT_EQ(test::charge_of(quads), charge);
    EXPECT_NEAR(constrained_length(quads), length, 1e-6 * length);
    EXPECT_NEAR(area_of(quads), area, 1e-5);
    for (const PassReport& pass : report.openings) openings += pass.won;
    for (const PassReport& pass : report.rings) rings += pass.won;
  }
  EXPECT_GT(openings, 0U);
  EXPECT_GT(rings, 0U);
  // Looked for where the build checks claims.
  EXPECT_EQ(claim_violations().count, 0U) << claim_violations().first;
}

TEST(Matching, MakesTheSameQuadsOnAnyNumberOfThreads) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::vector<std::uint64_t> expected;
    for (const int threads : {1, 2, 4, 7}) {
      test::SyntheticMesh made =
          test::make_synthetic({.columns = 80, .rows = 50, .seed = seed, .jitter = 0.3});
      parallel::with_threads(threads, [&] {
        const parallel::ParticipationProbe probe;
        MatchingReport report;
        const Mesh quads =
            make_quads_by_matching(std::move(made.mesh), made.lines, counting(), report, Progress());
        if (threads == 1) expected = test::arrays_of(quads);
        EXPECT_EQ(test::arrays_of(quads), expected);
        if (threads > 1) {
          EXPECT_GT(probe.chunks_of_other_threads(), 0U);
        }
      });
    }
  }
}

TEST(Matching, LeavesNothingInvertedWithoutConstraints) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Mesh mesh = test::delaunay_mesh(50, 40, seed);
    const Ends boundary = boundary_of(mesh);
    MatchingReport report;
    const Mesh quads = make_quads_by_matching(std::move(mesh), no_lines(), frozen(), report, Progress());
    EXPECT_EQ(validate(quads, GeometryCheck::kPlanarCorners), "");
    EXPECT_EQ(boundary_of(quads), boundary);
    EXPECT_EQ(report.parity.halved_edges, 0U);
  }
}

// A lattice of square cells whose outline has a node at every third vertex of the rim; the others slide.
struct Outlined {
  Mesh mesh;
  NodedLines lines;
};
Outlined outlined_lattice(std::uint32_t columns, std::uint32_t rows) {
  Outlined made{test::triangle_lattice(3 * columns, 3 * rows), {}};
  auto tags = ConstraintTags::add_to(made.mesh);
  // Along the rim, from node to node.
  SideId s = made.mesh.side_of(VertexId(std::size_t{0}));
  const std::uint32_t pieces = 2 * (columns + rows);
  for (std::uint32_t i = 0; i < 3 * pieces; ++i) {
    tags.set_constrained(s, true);
    const VertexId v = made.mesh.origin(s);
    if (i % 3 == 0) {
      tags.support[v] = Support::at(made.lines.nodes.push_back(made.mesh.point(v)));
      made.lines.pieces.push_back({NodeId(i / 3), NodeId((i / 3 + 1) % pieces), PieceKindOf::kOutline});
    } else {
      tags.support[v] = Support::on(PieceId(i / 3));
    }
    s = made.mesh.side_of(made.mesh.target(s));
  }
  made.lines.line_begin.assign(pieces + 1, 0);
  return made;
}

TEST(WholeOutline, KeepsItsOwnVerticesAlone) {
  for (const int threads : {1, 4}) {
    Outlined made = outlined_lattice(5, 4);
    const double area = area_of(made.mesh);
    parallel::with_threads(threads, [&] {
      const PassReport report = make_outline_whole(made.mesh, made.lines, Progress());
      EXPECT_EQ(report.won, 36U);
    });
    EXPECT_EQ(validate(made.mesh, GeometryCheck::kPlanarCorners), "");
    EXPECT_NEAR(area_of(made.mesh), area, 1e-9);
    EXPECT_EQ(boundary_of(made.mesh).size(), 18U);
    EXPECT_EQ(constraints_of(made.mesh).size(), 18U);
  }
  EXPECT_EQ(claim_violations().count, 0U) << claim_violations().first;
}

// A random mesh of a rectangle whose outline has nodes at its corners and at some of its other vertices.
Outlined outlined_delaunay(std::uint64_t seed) {
  Outlined made{test::delaunay_mesh(30, 20, seed), {}};
  auto tags = ConstraintTags::of(made.mesh);
  const SideId start = made.mesh.side_of(VertexId(std::size_t{0}));
  SideId s = start;
  std::vector<VertexId> rim;
  do {
    tags.set_constrained(s, true);
    rim.push_back(made.mesh.origin(s));
    s = made.mesh.side_of(made.mesh.target(s));
  } while (s != start);
  const auto is_node = [&](std::size_t i) {
    const Vec2 before = made.mesh.point(rim[(i + rim.size() - 1) % rim.size()]);
    const Vec2 here = made.mesh.point(rim[i]), after = made.mesh.point(rim[(i + 1) % rim.size()]);
    return cross(here - before, after - here) != 0 || uniform01(seed, i) < 0.4;
  };
  for (std::size_t i = 0; i < rim.size(); ++i)
    if (is_node(i)) tags.support[rim[i]] = Support::at(made.lines.nodes.push_back(made.mesh.point(rim[i])));
  const std::size_t count = made.lines.nodes.size();
  for (std::size_t i = 0; i < count; ++i)
    made.lines.pieces.push_back({NodeId(i), NodeId((i + 1) % count), PieceKindOf::kOutline});
  // The vertices after the last node, before the first one, too.
  PieceId piece(count - 1);
  for (const VertexId v : rim) {
    if (tags.support[v].is_node())
      piece = PieceId(tags.support[v].node().value());
    else
      tags.support[v] = Support::on(piece);
  }
  made.lines.line_begin.assign(count + 1, 0);
  return made;
}

TEST(WholeOutline, KeepsAreaChargeAndValidityOfRandomMeshes) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Outlined made = outlined_delaunay(seed);
    const double area = area_of(made.mesh);
    const int charge = test::charge_of(made.mesh);
    const std::size_t rim = boundary_of(made.mesh).size();
    const PassReport report = make_outline_whole(made.mesh, made.lines, Progress());
    EXPECT_EQ(report.won, rim - made.lines.nodes.size());
    EXPECT_EQ(validate(made.mesh, GeometryCheck::kPlanarCorners), "");
    EXPECT_NEAR(area_of(made.mesh), area, 1e-9);
    EXPECT_EQ(test::charge_of(made.mesh), charge);
    EXPECT_EQ(boundary_of(made.mesh).size(), made.lines.nodes.size());
    for (const VertexId v : made.mesh.vertices()) {
      if (made.mesh.alive(v) && made.mesh.on_boundary(v)) {
        EXPECT_TRUE(ConstraintTags::of(made.mesh).support[v].is_node());
      }
    }
  }
}

TEST(WholeOutline, BecomesQuadsWithTheOutlinesVerticesAlone) {
  Outlined made = outlined_lattice(5, 4);
  (void)make_outline_whole(made.mesh, made.lines, Progress());
  MatchingReport report;
  const Mesh quads = make_quads_by_matching(std::move(made.mesh), made.lines, frozen(), report, Progress());
  EXPECT_EQ(validate(quads, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(boundary_of(quads).size(), 18U);
}

TEST(Openings, GiveAStraightCornerASecondQuad) {
  // Point 1 is straight in the lower quad, and fixed on the boundary.
  Mesh mesh = test::with_fixed_rim(
      test::mesh_of({{0, 0}, {1, 0}, {2, 0}, {1, 0.8}, {2.2, 1.5}, {0.8, 2}}, {{0, 1, 2, 3}, {3, 2, 4, 5}}));
  const Ends boundary = boundary_of(mesh);
  const PassReport report = open_straight_corners(mesh, {}, Progress());
  EXPECT_EQ(report.won, 1U);
  EXPECT_EQ(mesh.count_alive_faces(), 3U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(boundary_of(mesh), boundary);
}

std::size_t count_invalid(const Mesh& quads) {
  std::size_t count = 0;
  for (const FaceId f : quads.faces()) count += quads.alive(f) && !matching::is_convex(quads, f) ? 1 : 0;
  return count;
}

// Quads straight from the matching of a random mesh with lines, some of them with straight or reflex corners.
struct Matched {
  Mesh mesh;
  NodedLines lines;

  explicit Matched(std::uint64_t seed) {
    test::SyntheticMesh made = test::make_synthetic({.seed = seed, .crooked_lines = 30});
    MatchingReport report;
    prepare_for_join(made.mesh, made.tags, made.lines, {}, report, Progress());
    const DualArcs join = find_join(made.mesh, made.tags, {}, report, Progress());
    mesh = merge_join(std::move(made.mesh), join);
    lines = std::move(made.lines);
  }
};

TEST(Openings, KeepLinesChargeAndValidityOnRandomMeshes) {
  std::uint64_t won = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Mesh mesh = Matched(seed).mesh;
    const Ends boundary = boundary_of(mesh), constraints = constraints_of(mesh);
    const int charge = test::charge_of(mesh);
    const std::size_t invalid = count_invalid(mesh);
    const double area = area_of(mesh);
    won += open_straight_corners(mesh, {}, Progress()).won;
    EXPECT_EQ(validate(mesh, GeometryCheck::kNone), "");
    EXPECT_EQ(boundary_of(mesh), boundary);
    EXPECT_EQ(constraints_of(mesh), constraints);
    EXPECT_EQ(test::charge_of(mesh), charge);
    EXPECT_LE(count_invalid(mesh), invalid);
    EXPECT_NEAR(area_of(mesh), area, 1e-5);
  }
  EXPECT_GT(won, 0U);
}

TEST(Rings, KeepLinesChargeAndValidityOnRandomMeshes) {
  std::uint64_t won = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Matched given(seed);
    const double length = constrained_length(given.mesh);
    const int charge = test::charge_of(given.mesh);
    const std::size_t invalid = count_invalid(given.mesh);
    const double area = area_of(given.mesh);
    const std::uint64_t mended = ring_straight_corners(given.mesh, given.lines, {}, Progress()).won;
    EXPECT_EQ(validate(given.mesh, GeometryCheck::kNone), "");
    EXPECT_EQ(test::charge_of(given.mesh), charge);
    EXPECT_LE(count_invalid(given.mesh), invalid);
    EXPECT_EQ(count_invalid(given.mesh) < invalid, mended > 0);
    EXPECT_NEAR(constrained_length(given.mesh), length, 1e-6 * length);
    EXPECT_NEAR(area_of(given.mesh), area, 1e-5);
    won += mended;
  }
  EXPECT_GT(won, 0U);
}

TEST(Matching, TakesAClosedSurface) {
  Mesh sphere = test::icosphere(4);
  MatchingReport report;
  const DualArcs join = find_join(sphere, ConstraintTags::of(sphere), {}, report, Progress());
  for (const FaceId f : sphere.faces()) ASSERT_EQ(matching::degree(join[f]) % 2, 1);
  const Mesh quads = merge_join(std::move(sphere), join);
  EXPECT_FALSE(quads.planar());
  EXPECT_TRUE(all_quads(quads));
  EXPECT_EQ(validate(quads, GeometryCheck::kNone), "");
  EXPECT_TRUE(boundary_of(quads).empty());
  EXPECT_EQ(test::charge_of(quads), 8);
  for (const VertexId v : quads.vertices()) EXPECT_GT(length(quads.point3(v)), 0.98);
}

TEST(Matching, TakesAnAnnulusOfWhichBothRimsAreOdd) {
  Mesh mesh = test::triangle_annulus(31, 5);
  const Ends boundary = boundary_of(mesh);
  MatchingReport report;
  const Mesh quads = make_quads_by_matching(std::move(mesh), no_lines(), frozen(), report, Progress());
  EXPECT_EQ(validate(quads, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(boundary_of(quads), boundary);
  EXPECT_EQ(test::charge_of(quads), 0);
}

// Two lattices side by side; the second loses a corner triangle, which leaves it an odd number of sides.
Mesh even_and_odd_part() {
  std::vector<double> x, y;
  std::vector<FaceCorners> faces;
  for (const double shift : {0.0, 10.0}) {
    const Mesh part = test::triangle_lattice(4, 3, {shift, 0});
    const std::size_t first = x.size();
    for (const VertexId v : part.vertices()) {
      x.push_back(part.point(v).x);
      y.push_back(part.point(v).y);
    }
    for (const FaceId f : part.faces()) {
      if (shift > 0 && f.value() == 0) continue;
      FaceCorners corners;
      for (int k = 0; k < 3; ++k)
        corners[static_cast<std::size_t>(k)] = VertexId(first + part.corner(f, k).value());
      faces.push_back(corners);
    }
  }
  return test::with_fixed_rim(build_mesh(std::move(x), std::move(y), faces));
}

TEST(Matching, NamesTheComponentWhoseFrozenBoundaryIsOdd) {
  MatchingReport report;
  try {
    (void)make_quads_by_matching(even_and_odd_part(), no_lines(), frozen(), report, Progress());
    FAIL() << "an odd boundary was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kGeometry);
    EXPECT_NE(error.message().find("15 sides"), std::string::npos) << error.message();
    EXPECT_NE(error.message().find("(1"), std::string::npos) << error.message();
    EXPECT_NE(error.message().find("add or remove one vertex"), std::string::npos) << error.message();
    EXPECT_NE(error.message().find("no --keep-boundary"), std::string::npos) << error.message();
  }
}

TEST(Matching, HalvesOneOuterEdgeOfAnOddComponent) {
  MatchingReport report;
  const Mesh quads = make_quads_by_matching(even_and_odd_part(), no_lines(), {}, report, Progress());
  EXPECT_EQ(report.parity.regions, 2U);
  EXPECT_EQ(report.parity.halved_edges, 1U);
  EXPECT_TRUE(all_quads(quads));
  EXPECT_EQ(validate(quads, GeometryCheck::kPlanarCorners), "");
}

TEST(QuadShape, CallsACornerFlatThatTurnsLeftByTheLastBitsAlone) {
  const std::array<Vec2, 4> square{Vec2{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_TRUE(matching::is_convex(square));
  EXPECT_FALSE(matching::is_convex({Vec2{0, 0}, {1, 0}, {0.5, 0.5}, {0, 1}}));
  EXPECT_FALSE(matching::is_convex({Vec2{0, 0}, {1, 0}, {0.5 + 1e-9, 0.5}, {0, 1}}));
  EXPECT_TRUE(matching::is_convex({Vec2{0, 0}, {1, 0}, {0.51, 0.5}, {0, 1}}));
  // A sharp corner is what lines may ask for.
  EXPECT_TRUE(matching::is_convex({Vec2{0, 0}, {1, 0}, {1 + 5e-9, 5e-9}, {1, 1e-8}}));
}

}  // namespace
}  // namespace quarry
