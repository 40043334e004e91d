#include "kernels/cleanup/chord_collapse.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/build.hpp"
#include "engine/mesh/sectors.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/operation/editor.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cleanup/chords.hpp"
#include "kernels/cleanup/ideal.hpp"
#include "tests/kernels/cleanup/line_measures.hpp"
#include "tests/kernels/cleanup/patch_meshes.hpp"
#include "tests/support/charge.hpp"
#include "tests/support/mesh_arrays.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry {
namespace {

ChordReport collapse(Mesh& mesh, const ChordOptions& options = {}) {
  cut_open(mesh, ConstraintTags::of(mesh));
  set_ideal_faces(mesh, PlaneModel());
  SectorCharges charges(mesh);
  sew(mesh, ConstraintTags::of(mesh));
  return collapse_chords(mesh, std::move(charges), options, Progress());
}

// Points, corners and lines of what is alive.
std::vector<std::uint64_t> shape_of(const Mesh& mesh, const ConstraintTags& tags) {
  std::vector<std::uint64_t> all;
  for (const VertexId v : mesh.vertices()) {
    if (!mesh.alive(v)) continue;
    all.push_back(std::bit_cast<std::uint64_t>(mesh.point(v).x));
    all.push_back(std::bit_cast<std::uint64_t>(mesh.point(v).y));
  }
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    for (int k = 0; k < 4; ++k) all.push_back(mesh.corner(f, k).value());
    all.push_back(tags.sides[f]);
  }
  return all;
}

// A square of unit faces with one row too many: it comes in on the left, turns at the middle of the square
// between a vertex of three faces and one of five, and leaves at the top.
struct Turn {
  static constexpr std::uint32_t kSide = 12, kMiddle = kSide / 2;

  Mesh mesh;
  ConstraintTags tags = ConstraintTags::add_to(mesh);
  NodedLines lines;

  // dented: with vertices of three and five faces on the left of the row's vertical part.
  explicit Turn(bool dented = false) : mesh(make(dented)) {
    const NodeId corners[] = {add_node(0, 0), add_node(kSide, 0), add_node(kSide, kSide), add_node(0, kSide)};
    for (std::size_t i = 0; i < 4; ++i) lines.pieces.push_back({corners[i], corners[(i + 1) % 4]});
    bind_outline();
  }

  static VertexId at(std::uint32_t i, std::uint32_t j) { return VertexId(j * (kSide + 1) + i); }
  // The place of at(i, j) on the way of the row.
  static bool on_way(std::uint32_t i, std::uint32_t j) {
    return (j == kMiddle && i <= kMiddle) || (i == kMiddle && j >= kMiddle);
  }
  // The vertex across the row from at(i, j), which lies below it or to its right.
  static VertexId across(std::uint32_t i, std::uint32_t j) {
    return VertexId((kSide + 1) * (kSide + 1) + i + (j - kMiddle));
  }

  void constrain(VertexId a, VertexId b) {
    const SideId s = mesh.find_side(a, b);
    tags.set_constrained(s, true);
    if (mesh.neighbour(s).valid()) tags.set_constrained(mesh.neighbour(s), true);
  }

  // The right side of the row's vertical part.
  void put_rail_on_line() {
    const PieceId piece = lines.pieces.push_back({lines.nodes.push_back({kMiddle + 0.25, kMiddle + 1.0}),
                                                  lines.nodes.push_back({kMiddle + 0.25, double{kSide}})});
    for (std::uint32_t j = kMiddle + 1; j < kSide; ++j) {
      constrain(at(kMiddle, j), at(kMiddle, j + 1));
      tags.support[at(kMiddle, j)] = Support::on(piece);
    }
    tags.support[at(kMiddle, kMiddle + 1)] = Support::at(lines.pieces[piece].from);
    tags.support[at(kMiddle, kSide)] = Support::at(lines.pieces[piece].to);
  }

 private:
  NodeId add_node(std::uint32_t x, std::uint32_t y) {
    tags.support[at(x, y)] =
        Support::at(lines.nodes.push_back({static_cast<double>(x), static_cast<double>(y)}));
    return tags.support[at(x, y)].node();
  }

  void bind_outline() {
    for (const FaceId f : mesh.faces()) {
      for (int k = 0; k < 4; ++k) {
        const SideId s(f, k);
        if (mesh.neighbour(s).valid()) continue;
        tags.set_constrained(s, true);
        const VertexId v = mesh.origin(s);
        if (tags.support[v].is_node()) continue;
        const Vec2 p = mesh.point(v);
        tags.support[v] = Support::on(PieceId(p.y == 0 ? 0U : p.x == kSide ? 1U : p.y == kSide ? 2U : 3U));
      }
    }
  }

  static Mesh make(bool dented) {
    std::vector<double> x, y;
    for (std::uint32_t j = 0; j <= kSide; ++j) {
      for (std::uint32_t i = 0; i <= kSide; ++i) {
        x.push_back(i + (on_way(i, j) && j > kMiddle ? 0.25 : 0) + (i == kMiddle && j == kMiddle ? 0.25 : 0));
        y.push_back(j - (on_way(i, j) && j == kMiddle ? 0.25 : 0));
      }
    }
    std::vector<VertexId> lower, upper;
    for (std::uint32_t n = 0; n <= kSide; ++n) {
      const std::uint32_t i = std::min(n, kMiddle), j = kMiddle + (n > kMiddle ? n - kMiddle : 0);
      lower.push_back(at(i, j));
      upper.push_back(across(i, j));
      x.push_back(i - (n >= kMiddle ? 0.25 : 0));
      y.push_back(j + (n <= kMiddle ? 0.25 : 0));
    }
    std::vector<FaceCorners> faces;
    for (std::uint32_t j = 0; j < kSide; ++j) {
      for (std::uint32_t i = 0; i < kSide; ++i) {
        const bool above = i < kMiddle && j >= kMiddle;
        const auto corner = [&](std::uint32_t a, std::uint32_t b) {
          return above && on_way(a, b) ? across(a, b) : at(a, b);
        };
        faces.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
      }
    }
    for (std::size_t n = 0; n < kSide; ++n) faces.push_back({lower[n], lower[n + 1], upper[n + 1], upper[n]});
    if (dented) dent(x, faces);
    return build_mesh(std::move(x), std::move(y), faces);
  }

  // The edge between two faces on the left of the row goes, and another of their hexagon's diagonals comes.
  static void dent(std::vector<double>& x, std::vector<FaceCorners>& faces) {
    const std::uint32_t i = kMiddle - 1, j = kMiddle + 2;
    FaceCorners& below = faces[j * kSide + i];
    FaceCorners& above = faces[(j + 1) * kSide + i];
    const VertexId three = below[2];
    x[three.value()] += 0.25;
    x[below[3].value()] -= 0.25;
    const FaceCorners right = {below[0], below[1], three, above[2]};
    above = {below[0], above[2], above[3], above[0]};
    below = right;
  }
};

TEST(Chords, CrossEachFaceTwiceAndEndOnTheBoundary) {
  const Turn given;
  const Chords chords(given.mesh, given.tags);
  EXPECT_EQ(chords.count(), 2 * Turn::kSide + 1);
  std::size_t faces = 0;
  for (std::uint32_t i = 0; i < chords.count(); ++i) {
    EXPECT_TRUE(chords[i].collapsible);
    EXPECT_FALSE(given.mesh.neighbour(chords[i].first).valid());
    std::size_t walked = 0;
    chords.for_each_face(i, [&](SideId s) {
      ++walked;
      EXPECT_EQ(chords.across(s), i);
      EXPECT_EQ(chords.across(Chords::opposite(s)), i);
    });
    EXPECT_EQ(walked, chords[i].faces);
    faces += walked;
  }
  EXPECT_EQ(faces, 2 * given.mesh.count_alive_faces());
}

TEST(Chords, CloseAroundAHole) {
  // A ring of six faces.
  std::vector<double> x, y;
  std::vector<FaceCorners> faces;
  for (std::uint32_t i = 0; i < 6; ++i) {
    for (const double radius : {1.0, 2.0}) {
      x.push_back(radius * std::cos(i * std::numbers::pi / 3));
      y.push_back(radius * std::sin(i * std::numbers::pi / 3));
    }
    const std::uint32_t next = (i + 1) % 6;
    faces.push_back({VertexId(2 * i), VertexId(2 * i + 1), VertexId(2 * next + 1), VertexId(2 * next)});
  }
  Mesh mesh = build_mesh(std::move(x), std::move(y), faces);
  const ConstraintTags tags = ConstraintTags::add_to(mesh);
  const Chords chords(mesh, tags);
  ASSERT_EQ(chords.count(), 7U);
  const Chord& around = chords[chords.across(mesh.find_side(VertexId(0U), VertexId(1U)))];
  EXPECT_EQ(around.faces, 6U);
  EXPECT_FALSE(around.collapsible) << "both rims would become one";
}

TEST(Chords, ThatEndAtATriangleCannotCollapse) {
  for (const bool triangle : {false, true}) {
    // Two quads beside each other, and a triangle to their right; all around slides.
    std::vector<double> x{0, 1, 2, 0, 1, 2}, y{0, 0, 0, 1, 1, 1};
    std::vector<FaceCorners> faces{{VertexId(0U), VertexId(1U), VertexId(4U), VertexId(3U)},
                                   {VertexId(1U), VertexId(2U), VertexId(5U), VertexId(4U)}};
    if (triangle) {
      x.push_back(3);
      y.push_back(0.5);
      faces.push_back({VertexId(2U), VertexId(6U), VertexId(5U), VertexId()});
    }
    Mesh mesh = build_mesh(std::move(x), std::move(y), faces);
    ConstraintTags tags = ConstraintTags::add_to(mesh);
    const SideId rung = mesh.find_side(VertexId(1U), VertexId(4U));
    for (const VertexId v : mesh.vertices()) tags.support[v] = Support::on(PieceId(0U));
    for (const FaceId f : mesh.faces())
      for (int k = 0; k < mesh.corner_count(f); ++k) tags.set_constrained(SideId(f, k), true);
    const Chords chords(mesh, tags);
    ASSERT_EQ(chords.count(), 3U);
    EXPECT_EQ(chords[chords.across(rung)].faces, 2U);
    EXPECT_EQ(chords[chords.across(rung)].collapsible, !triangle);
  }
}

TEST(CollapseOfChords, TakesTheRowBetweenOppositeChargesAway) {
  Turn given;
  ASSERT_EQ(validate(given.mesh, GeometryCheck::kPlanarCorners), "");
  ASSERT_EQ(test::energy_by_sectors(given.mesh), 2);
  const ChordReport report = collapse(given.mesh);
  EXPECT_EQ(validate(given.mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(report.won, 1U);
  EXPECT_EQ(report.faces, Turn::kSide);
  EXPECT_EQ(report.gained, 2);
  EXPECT_EQ(given.mesh.count_alive_faces(), Turn::kSide * Turn::kSide);
  EXPECT_EQ(test::energy_by_sectors(given.mesh), 0);
}

TEST(CollapseOfChords, TakesAnEdgeOfEachLineThatTheRowCrosses) {
  Turn given;
  const std::uint32_t row = Turn::kMiddle + 3;
  const PieceId piece =
      given.lines.pieces.push_back({given.lines.nodes.push_back({0, double{row}}),
                                    given.lines.nodes.push_back({Turn::kSide, double{row}})});
  std::vector<VertexId> line;
  for (std::uint32_t i = 0; i <= Turn::kSide; ++i) {
    if (i == Turn::kMiddle) line.push_back(Turn::across(i, row));
    line.push_back(Turn::at(i, row));
  }
  given.tags.support[line.front()] = Support::at(given.lines.pieces[piece].from);
  given.tags.support[line.back()] = Support::at(given.lines.pieces[piece].to);
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    given.constrain(line[i], line[i + 1]);
    if (i > 0) given.tags.support[line[i]] = Support::on(piece);
  }
  const auto before = test::covered(given.mesh, given.tags, given.lines);
  EXPECT_EQ(collapse(given.mesh).won, 1U);
  EXPECT_EQ(validate(given.mesh, GeometryCheck::kPlanarCorners), "");
  test::expect_covered(test::covered(given.mesh, given.tags, given.lines), before);
  std::size_t edges = 0;
  for (const FaceId f : given.mesh.faces())
    for (int k = 0; given.mesh.alive(f) && k < 4; ++k)
      edges += given.tags.constrained(SideId(f, k)) && given.mesh.neighbour(SideId(f, k)).valid() ? 1 : 0;
  EXPECT_EQ(edges, 2 * Turn::kSide) << "seen from both sides";
}

TEST(CollapseOfChords, PullsARailOntoALine) {
  Turn given;
  given.put_rail_on_line();
  const auto before = test::covered(given.mesh, given.tags, given.lines);
  EXPECT_EQ(collapse(given.mesh).won, 1U);
  EXPECT_EQ(validate(given.mesh, GeometryCheck::kPlanarCorners), "");
  test::expect_covered(test::covered(given.mesh, given.tags, given.lines), before);
}

TEST(CollapseOfChords, LeavesRowsThatWouldLeaveOneFaceAtAStraightLine) {
  for (const bool line : {false, true}) {
    Turn given(true);
    // The chords that end in the dent stay.
    for (const auto& [i, j] : {std::pair(9U, 9U), {9U, 10U}, {2U, 8U}, {2U, 9U}})
      given.tags.support[Turn::at(i, j)] = Support::fixed();
    if (line) given.put_rail_on_line();
    ASSERT_EQ(validate(given.mesh, GeometryCheck::kPlanarCorners), "");
    const ChordReport report = collapse(given.mesh);
    EXPECT_EQ(report.won, line ? 0U : 1U);
    EXPECT_EQ(report.tried, report.won);
    EXPECT_EQ(report.rejected[static_cast<std::size_t>(ChordReject::kFewFaces)], line ? 1U : 0U);
  }
}

TEST(CollapseOfChords, LeavesRowsWithFixedVerticesOnBothSides) {
  Turn given;
  const std::uint32_t row = Turn::kMiddle + 3;
  given.tags.support[Turn::at(Turn::kMiddle, row)] = Support::fixed();
  given.tags.support[Turn::across(Turn::kMiddle, row)] = Support::fixed();
  const std::vector<std::uint64_t> before = shape_of(given.mesh, given.tags);
  const ChordReport report = collapse(given.mesh);
  EXPECT_EQ(report.won, 0U);
  EXPECT_EQ(report.collapsible + 1, report.chords);
  EXPECT_EQ(shape_of(given.mesh, given.tags), before);
}

TEST(CollapseOfChords, LeavesRowsThatWouldTakeTooManyFaces) {
  Turn given;
  ChordOptions options;
  options.most_shrinkage = 0.05;
  const ChordReport report = collapse(given.mesh, options);
  EXPECT_EQ(report.won, 0U);
  EXPECT_EQ(report.rejected[static_cast<std::size_t>(ChordReject::kFaceBand)], 1U);
}

TEST(CollapseOfChords, GainsMoreWhereIrregularVerticesAreDear) {
  Turn given;
  ChordOptions options;
  options.price = [](Vec3) { return 3.0; };
  EXPECT_EQ(collapse(given.mesh, options).gained, 6);
}

TEST(CollapseOfChords, LeavesRowsThatGainTooLittleForTheirFaces) {
  Turn given;
  ChordOptions options;
  options.least_gain = 3;
  const ChordReport report = collapse(given.mesh, options);
  EXPECT_EQ(report.won, 0U);
  EXPECT_EQ(report.rejected[static_cast<std::size_t>(ChordReject::kNoGain)], 1U);
}

// Puts the hull, but for its corners and what is fixed there for lines that end on it, on four lines.
void bind_hull(test::SyntheticMesh& given) {
  auto& [mesh, tags, lines] = given;
  const Box2 box = mesh.box();
  const Vec2 places[] = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
  std::vector<NodeId> corners;
  for (const Vec2 p : places) corners.push_back(lines.nodes.push_back(p));
  std::vector<PieceId> sides;
  for (std::size_t i = 0; i < 4; ++i)
    sides.push_back(lines.pieces.push_back({corners[i], corners[(i + 1) % 4]}));
  for (const FaceId f : mesh.faces()) {
    for (int k = 0; mesh.alive(f) && k < mesh.corner_count(f); ++k) {
      const VertexId v = mesh.corner(f, k);
      if (mesh.neighbour(SideId(f, k)).valid()) continue;
      tags.set_constrained(SideId(f, k), true);
      if (tags.support[v].is_node()) continue;
      const Vec2 p = mesh.point(v);
      const auto corner = std::find(std::begin(places), std::end(places), p);
      if (corner != std::end(places))
        tags.support[v] = Support::at(corners[static_cast<std::size_t>(corner - places)]);
      else
        tags.support[v] = Support::on(sides[p.y == box.low.y    ? 0U
                                            : p.x == box.high.x ? 1U
                                            : p.y == box.high.y ? 2U
                                                                : 3U]);
    }
  }
}

// Quads between long lines.
test::SyntheticMesh between_lines(std::uint64_t seed) {
  test::SyntheticMesh given = test::cut_network({.columns = 14,
                                                 .rows = 12,
                                                 .seed = seed,
                                                 .jitter = 0.2,
                                                 .straight_lines = static_cast<int>(seed % 3),
                                                 .crooked_lines = 0,
                                                 .origin = {0, 0}});
  sew(given.mesh, given.tags);
  bind_hull(given);
  return given;
}

TEST(CollapseOfChords, KeepsEveryLineCoveredAndLowersTheEnergyByWhatItGains) {
  std::uint64_t won = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test::SyntheticMesh given = between_lines(seed);
    Mesh& mesh = given.mesh;
    const auto before = test::covered(mesh, given.tags, given.lines);
    std::vector<std::pair<VertexId, Vec2>> fixed;
    for (const VertexId v : mesh.vertices())
      if (given.tags.support[v].is_fixed()) fixed.emplace_back(v, mesh.point(v));
    const int energy = test::energy_by_sectors(mesh);
    const int charge = test::charge_of(mesh);
    const std::size_t faces = mesh.count_alive_faces();
    ChordOptions options;
    options.least_gain = 0.1;
    options.most_shrinkage = 0.5;
    const ChordReport report = collapse(mesh, options);
    EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
    EXPECT_EQ(test::charge_of(mesh), charge);
    EXPECT_EQ(test::energy_by_sectors(mesh), energy - static_cast<int>(report.gained));
    EXPECT_EQ(mesh.count_alive_faces(), faces - report.faces);
    EXPECT_EQ(report.won + report.rejected[static_cast<std::size_t>(ChordReject::kQuality)], report.tried);
    for (const auto& [v, place] : fixed) EXPECT_EQ(mesh.point(v), place);
    test::expect_covered(test::covered(mesh, given.tags, given.lines), before);
    won += report.won;
  }
  EXPECT_GT(won, 12U);
}

TEST(CollapseOfChords, LeavesTheMeshAsItWasWhereFacesWouldBePoor) {
  std::uint64_t left = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test::SyntheticMesh given = between_lines(seed);
    ChordOptions options;
    options.least_gain = 0.1;
    options.most_rounds = 1;
    options.largest_edge_ratio = 1;  // no face may be more slender than the worst there
    options.smoothing.untangling_sweeps = options.smoothing.sweeps = 0;
    const std::vector<std::uint64_t> before = shape_of(given.mesh, given.tags);
    const ChordReport report = collapse(given.mesh, options);
    EXPECT_EQ(validate(given.mesh, GeometryCheck::kPlanarCorners), "");
    if (report.won > 0) continue;
    EXPECT_EQ(shape_of(given.mesh, given.tags), before);
    left += report.rejected[static_cast<std::size_t>(ChordReject::kQuality)];
  }
  EXPECT_GT(left, 4U);
}

TEST(CollapseOfChords, LooksAtTheShortestAlone) {
  // What remains of a round's walk is no longer than the row, which is twelve faces of 156.
  for (const double share : {11.5 / 156, 12.5 / 156}) {
    Turn given;
    ChordOptions options;
    options.most_walked = share;
    const ChordReport report = collapse(given.mesh, options);
    const bool reached = share > 12.0 / 156;
    EXPECT_EQ(report.won, reached ? 1U : 0U);
    EXPECT_EQ(report.rejected[static_cast<std::size_t>(ChordReject::kLong)] > 0, !reached);
  }
}

TEST(CollapseOfChords, IsTheSameOnAnyNumberOfThreads) {
  const auto collapsed = [] {
    std::vector<std::uint64_t> all;
    for (const std::uint64_t seed : {3U, 4U, 5U}) {
      test::SyntheticMesh given = between_lines(seed);
      ChordOptions options;
      options.least_gain = 0.1;
      collapse(given.mesh, options);
      const std::vector<std::uint64_t> arrays = test::arrays_of(given.mesh);
      all.insert(all.end(), arrays.begin(), arrays.end());
    }
    return all;
  };
  std::vector<std::uint64_t> serial;
  parallel::with_threads(1, [&] { serial = collapsed(); });
  for (const int threads : {2, 4, 7}) {
    std::vector<std::uint64_t> result;
    parallel::with_threads(threads, [&] { result = collapsed(); });
    EXPECT_EQ(result, serial) << threads << " threads";
  }
}

#ifdef QUARRY_CHECK_CLAIMS
TEST(CollapseOfChords, StaysInsideItsClaims) {
  reset_claim_violations();
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test::SyntheticMesh given = between_lines(seed);
    ChordOptions options;
    options.least_gain = 0.1;
    collapse(given.mesh, options);
  }
  EXPECT_EQ(claim_violations().count, 0U) << claim_violations().first;
}
#endif

}  // namespace
}  // namespace quarry
