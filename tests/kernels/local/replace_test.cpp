// Random regions of random meshes are replaced by themselves and by other faces, and put back.
#include "kernels/local/replace.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "engine/mesh/validate.hpp"
#include "tests/support/charge.hpp"
#include "tests/support/mesh_zoo.hpp"

namespace quarry {
namespace {

// A lattice of quads of which some are cut in two triangles, and some of whose edges are constraints.
struct Trial {
  Mesh mesh;
  ConstraintTags tags;
  std::uint64_t seed;
  std::uint64_t counter = 0;

  std::size_t below(std::size_t end) {
    return std::min(end - 1, static_cast<std::size_t>(uniform01(seed, counter++) * static_cast<double>(end)));
  }
};

Trial make_trial(std::uint64_t seed, std::uint32_t cells = 12) {
  std::vector<Vec2> points;
  std::vector<std::vector<std::uint32_t>> faces;
  const auto shake = [&](std::uint64_t i) { return 0.4 * (uniform01(seed, 1'000'000 + i) - 0.5); };
  for (std::uint32_t row = 0; row <= cells; ++row) {
    for (std::uint32_t column = 0; column <= cells; ++column) {
      const std::uint64_t i = points.size();
      points.push_back({column + shake(2 * i), row + shake(2 * i + 1)});
    }
  }
  for (std::uint32_t row = 0; row < cells; ++row) {
    for (std::uint32_t column = 0; column < cells; ++column) {
      const std::uint32_t a = row * (cells + 1) + column;
      const std::uint32_t b = a + 1, c = a + cells + 2, d = a + cells + 1;
      if (uniform01(seed, 2'000'000 + a) < 0.2) {
        faces.push_back({a, b, c});
        faces.push_back({a, c, d});
      } else {
        faces.push_back({a, b, c, d});
      }
    }
  }
  Trial trial{test::mesh_of(points, faces), {}, seed};
  trial.tags = ConstraintTags::add_to(trial.mesh);
  for (const FaceId f : trial.mesh.faces()) {
    if (uniform01(seed, 3'000'000 + f.value()) > 0.3) continue;
    const SideId s(f, 1);
    trial.tags.set_constrained(s, true);
    if (trial.mesh.neighbour(s).valid()) trial.tags.set_constrained(trial.mesh.neighbour(s), true);
  }
  return trial;
}

// Grows from a random face; no side inside is constrained.
std::vector<FaceId> random_region(Trial& trial, std::size_t size) {
  const Mesh& mesh = trial.mesh;
  std::vector<FaceId> region = {FaceId(trial.below(mesh.face_slots()))};
  while (!mesh.alive(region[0])) region[0] = FaceId(trial.below(mesh.face_slots()));
  const auto inside = [&](FaceId f) { return std::find(region.begin(), region.end(), f) != region.end(); };
  for (int i = 0; i < 40 && region.size() < size; ++i) {
    const FaceId f = region[trial.below(region.size())];
    const SideId t = mesh.neighbour(
        SideId(f, static_cast<int>(trial.below(static_cast<std::size_t>(mesh.corner_count(f))))));
    if (!t.valid() || inside(t.face())) continue;
    bool open = true;
    for (int k = 0; k < mesh.corner_count(t.face()); ++k) {
      const SideId s(t.face(), k);
      open = open &&
             !(trial.tags.constrained(s) && mesh.neighbour(s).valid() && inside(mesh.neighbour(s).face()));
    }
    if (open) region.push_back(t.face());
  }
  return region;
}

FaceCorners corners_of(const Mesh& mesh, FaceId f) {
  return {mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2), mesh.corner(f, 3)};
}

std::vector<FaceCorners> corners_of(const Mesh& mesh, std::span<const FaceId> faces) {
  std::vector<FaceCorners> corners;
  for (const FaceId f : faces) corners.push_back(corners_of(mesh, f));
  return corners;
}

// All faces with their constraint bits, from the corner of smallest number, sorted.
std::vector<std::array<std::uint32_t, 8>> faces_of(const Mesh& mesh, const ConstraintTags& tags) {
  std::vector<std::array<std::uint32_t, 8>> faces;
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    const int count = mesh.corner_count(f);
    int first = 0;
    for (int k = 1; k < count; ++k)
      if (mesh.corner(f, k) < mesh.corner(f, first)) first = k;
    auto& face = faces.emplace_back();
    for (int k = 0; k < count; ++k) {
      const int from = (first + k) % count;
      face[static_cast<std::size_t>(k)] = mesh.corner(f, from).value() + 1;
      face[static_cast<std::size_t>(4 + k)] = tags.constrained(SideId(f, from)) ? 1 : 0;
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

std::vector<VertexId> vertices_of(const Mesh& mesh, std::span<const FaceId> faces) {
  std::vector<VertexId> vertices;
  for (const FaceId f : faces)
    for (int k = 0; k < mesh.corner_count(f); ++k) vertices.push_back(mesh.corner(f, k));
  return vertices;
}

// A smaller face inside each, joined to it corner by corner: one face becomes four or five.
std::vector<FaceCorners> nest(Mesh& mesh, std::span<const FaceId> faces, VertexId next) {
  std::vector<FaceCorners> fresh;
  for (const FaceId f : faces) {
    const int count = mesh.corner_count(f);
    Vec2 centre{0, 0};
    for (int k = 0; k < count; ++k) centre = centre + (1.0 / count) * mesh.point(mesh.corner(f, k));
    FaceCorners inner;
    for (int k = 0; k < count; ++k) {
      inner[static_cast<std::size_t>(k)] = next;
      mesh.set_point(next, centre + 0.4 * (mesh.point(mesh.corner(f, k)) - centre));
      next = VertexId(next.value() + 1);
    }
    fresh.push_back(inner);
    for (int k = 0; k < count; ++k) {
      const int after = (k + 1) % count;
      fresh.push_back({mesh.corner(f, k), mesh.corner(f, after), inner[static_cast<std::size_t>(after)],
                       inner[static_cast<std::size_t>(k)]});
    }
  }
  return fresh;
}

class Replacing : public testing::TestWithParam<std::uint64_t> {
 protected:
  void expect_valid(const Trial& trial, int charge) {
    ASSERT_EQ(validate(trial.mesh, GeometryCheck::kNone), "");
    ASSERT_EQ(test::charge_of(trial.mesh), charge);
  }
  FaceReplacer replacer_;
};

TEST_P(Replacing, FacesByThemselvesInAnotherOrderChangesNothing) {
  Trial trial = make_trial(GetParam());
  const auto before = faces_of(trial.mesh, trial.tags);
  const int charge = test::charge_of(trial.mesh);
  MeshEditor editor(trial.mesh);
  for (int i = 0; i < 60; ++i) {
    const auto region = random_region(trial, 1 + trial.below(20));
    auto fresh = corners_of(trial.mesh, region);
    for (FaceCorners& face : fresh)
      std::rotate(face.begin(), face.begin() + 1, face.begin() + (face[3].valid() ? 4 : 3));
    for (std::size_t k = fresh.size(); k > 1; --k) std::swap(fresh[k - 1], fresh[trial.below(k)]);
    NewIds ids{};
    const auto made = replacer_.replace(editor, trial.tags, region, fresh, ids);
    ASSERT_EQ(std::vector(made.begin(), made.end()), region);
    for (std::size_t k = 0; k < made.size(); ++k) EXPECT_EQ(corners_of(trial.mesh, made[k]), fresh[k]);
    expect_valid(trial, charge);
  }
  EXPECT_EQ(faces_of(trial.mesh, trial.tags), before);
}

TEST_P(Replacing, FacesByOthersAndBackGivesTheSameFaces) {
  Trial trial = make_trial(GetParam());
  const auto before = faces_of(trial.mesh, trial.tags);
  const int charge = test::charge_of(trial.mesh);
  for (int i = 0; i < 40; ++i) {
    const auto region = random_region(trial, 1 + trial.below(12));
    const auto saved = corners_of(trial.mesh, region);
    const auto claims = vertices_of(trial.mesh, region);
    const NewIds first{trial.mesh.grow_vertices(4 * region.size()), trial.mesh.grow_faces(4 * region.size())};
    const NewIds end{VertexId(trial.mesh.vertex_slots()), FaceId(trial.mesh.face_slots())};
    const auto fresh = nest(trial.mesh, region, first.vertex);
    reset_claim_violations();
    MeshEditor editor(trial.mesh, claims, first, end);
    NewIds ids = first;
    const auto made = replacer_.replace(editor, trial.tags, region, fresh, ids);
    EXPECT_EQ(made.size(), fresh.size());
    EXPECT_EQ(made[0], region[0]);
    expect_valid(trial, charge);
    replacer_.undo(editor, trial.tags, saved);
    expect_valid(trial, charge);
    EXPECT_EQ(claim_violations().count, 0U) << claim_violations().first;
    ASSERT_EQ(faces_of(trial.mesh, trial.tags), before);
  }
}

// Rotates the edge between two quads somewhere in a region that is larger.
TEST_P(Replacing, TurnsEdgesInsideARegion) {
  Trial trial = make_trial(GetParam());
  const int charge = test::charge_of(trial.mesh);
  int turned = 0;
  for (int i = 0; i < 200; ++i) {
    const Mesh& mesh = trial.mesh;
    const auto region = random_region(trial, 2 + trial.below(8));
    auto fresh = corners_of(mesh, region);
    for (std::size_t k = 0; k < region.size(); ++k) {
      const SideId s(region[k], static_cast<int>(trial.below(3)));
      const SideId t = mesh.neighbour(s);
      const auto other = t.valid() ? std::find(region.begin(), region.end(), t.face()) : region.end();
      if (other == region.end() || mesh.corner_count(s.face()) == 3 || mesh.corner_count(t.face()) == 3)
        continue;
      const VertexId a = mesh.origin(s), b = mesh.origin(t);
      const VertexId x = mesh.target(mesh.next(s)), y = mesh.origin(mesh.previous(s));
      const VertexId p = mesh.target(mesh.next(t)), q = mesh.origin(mesh.previous(t));
      if (mesh.find_side(x, p).valid() || mesh.find_side(p, x).valid() || x == p || y == q) continue;
      fresh[k] = {x, y, a, p};
      fresh[static_cast<std::size_t>(other - region.begin())] = {p, q, b, x};
      ++turned;
      break;
    }
    MeshEditor editor(trial.mesh);
    NewIds ids{};
    replacer_.replace(editor, trial.tags, region, fresh, ids);
    expect_valid(trial, charge);
  }
  EXPECT_GT(turned, 20);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Replacing, testing::Range<std::uint64_t>(1, 9));

TEST(FaceReplacer, KeepsTheConstraintOfAnInnerSideThatStays) {
  // Both faces of an edge may be among those replaced, and the edge among the new ones.
  Trial trial = make_trial(1);
  const Mesh& mesh = trial.mesh;
  const auto before = faces_of(mesh, trial.tags);
  MeshEditor editor(trial.mesh);
  FaceReplacer replacer;
  int tried = 0;
  for (const FaceId f : mesh.faces()) {
    const SideId s(f, 1);
    if (!trial.tags.constrained(s) || !mesh.neighbour(s).valid()) continue;
    const std::array<FaceId, 2> region{f, mesh.neighbour(s).face()};
    const auto corners = corners_of(mesh, region);
    NewIds ids{};
    replacer.replace(editor, trial.tags, region, corners, ids);
    ++tried;
  }
  EXPECT_GT(tried, 10);
  EXPECT_EQ(faces_of(mesh, trial.tags), before);
}

TEST(FaceReplacer, LetsInnerVerticesDieAndComeBack) {
  Mesh mesh = test::fan(6, true);
  const auto tags = ConstraintTags::add_to(mesh);
  std::vector<FaceId> old;
  for (const FaceId f : mesh.faces()) old.push_back(f);
  const auto saved = corners_of(mesh, old);
  const auto v = [](std::uint32_t i) { return VertexId(i); };
  const std::array<FaceCorners, 2> quads = {FaceCorners{v(1), v(2), v(3), v(4)},
                                            FaceCorners{v(1), v(4), v(5), v(6)}};
  FaceReplacer replacer;
  MeshEditor editor(mesh);
  NewIds ids{};
  replacer.replace(editor, tags, old, quads, ids);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_FALSE(mesh.alive(v(0)));
  EXPECT_EQ(mesh.count_alive_faces(), 2U);
  replacer.undo(editor, tags, saved);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_TRUE(mesh.alive(v(0)));
  EXPECT_EQ(corners_of(mesh, old), saved);
}

TEST(StampedMap, ForgetsItsKeysWhenCleared) {
  StampedMap<int> map;
  for (std::size_t job = 1; job < 50; ++job) {
    map.clear(job);
    for (std::uint64_t key = 0; key < job; ++key) {
      EXPECT_EQ(map.find(key << 32), nullptr);
      const auto [value, is_new] = map.insert(key << 32);
      EXPECT_TRUE(is_new);
      value = static_cast<int>(key);
    }
    for (std::uint64_t key = 0; key < job; ++key) EXPECT_EQ(*map.find(key << 32), static_cast<int>(key));
  }
}

}  // namespace
}  // namespace quarry
