#include "kernels/cleanup/patch_fill.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "engine/geometry/vec.hpp"
#include "kernels/cleanup/patch_layout.hpp"
#include "kernels/cleanup/patch_placement.hpp"

namespace quarry {
namespace {

using Lengths = std::vector<std::uint32_t>;

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : seed_(seed) {}
  std::uint32_t between(std::uint32_t low, std::uint32_t high) {
    return low + static_cast<std::uint32_t>(uniform01(seed_, counter_++) * (high - low + 1));
  }

 private:
  std::uint64_t seed_, counter_ = 0;
};

Lengths lengths_of_spokes(const Lengths& spokes) {
  const std::size_t n = spokes.size();
  Lengths lengths;
  for (std::size_t i = 0; i < n; ++i) lengths.push_back(spokes[(i + n - 1) % n] + spokes[(i + 1) % n]);
  return lengths;
}

// Corners of a patch whose sides have these lengths, the first of them `shift` edges after the rim's start.
Lengths corners_of(const Lengths& lengths, std::uint32_t shift) {
  Lengths corners;
  for (const std::uint32_t length : lengths) {
    corners.push_back(shift);
    shift += length;
  }
  return corners;
}

// Every inside edge has two quads, every rim edge one, in the rim's own direction; vertices have the faces
// that the fill promises.
void expect_closed(const PatchLayout& layout, const Lengths& corners, const PatchFill& fill, int defects) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  std::vector<int> faces(layout.vertices(), 0);
  for (const PatchLayout::Quad& quad : layout.quads()) {
    EXPECT_EQ(std::set<std::uint32_t>(quad.begin(), quad.end()).size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
      ++sides[{quad[k], quad[(k + 1) % 4]}];
      ++faces[quad[k]];
    }
  }
  std::size_t rim_sides = 0;
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    if (sides.contains({side.second, side.first})) continue;
    ++rim_sides;
    EXPECT_EQ(side.second, (side.first + 1) % layout.rim());
  }
  EXPECT_EQ(rim_sides, layout.rim());
  int fives = 0;
  for (std::uint32_t v = 0; v < layout.rim(); ++v) {
    const bool corner = std::find(corners.begin(), corners.end(), v) != corners.end();
    if (faces[v] == 3 && fill.kind == FillKind::kPair)
      ++fives;
    else
      EXPECT_EQ(faces[v], corner ? 1 : 2) << "rim vertex " << v;
  }
  EXPECT_EQ(fives, fill.kind == FillKind::kPair ? 1 : 0);
  int found = 0;
  for (std::uint32_t v = layout.rim(); v < layout.vertices(); ++v) found += faces[v] != 4 ? 1 : 0;
  EXPECT_EQ(found, defects);
}

TEST(PatchFill, FindsTheSpokesFromWhichTheSidesWereMade) {
  const std::uint64_t seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Dice dice(seed);
  for (int round = 0; round < 3000; ++round) {
    for (const std::size_t n : {3U, 5U}) {
      Lengths spokes;
      for (std::size_t i = 0; i < n; ++i) spokes.push_back(dice.between(1, 12));
      const auto solved = solve_spokes(lengths_of_spokes(spokes));
      ASSERT_TRUE(solved.has_value());
      EXPECT_TRUE(std::equal(spokes.begin(), spokes.end(), solved->begin()));
    }
  }
}

TEST(PatchFill, SolvesEverySystemThatHasASolutionAndNoOther) {
  for (const std::size_t n : {3U, 5U, 6U}) {
    const std::uint32_t most = n == 3 ? 9 : 4;
    // Every choice of spokes up to `most`; then all lengths that could come of them are known.
    std::set<Lengths> solvable;
    Lengths spokes(n, 1);
    for (;;) {
      solvable.insert(lengths_of_spokes(spokes));
      std::size_t i = 0;
      while (i < n && ++spokes[i] > most) spokes[i++] = 1;
      if (i == n) break;
    }
    // Lengths up to most + 1 need no longer spokes.
    Lengths lengths(n, 1);
    for (;;) {
      const auto solved = solve_spokes(lengths);
      EXPECT_EQ(solved.has_value(), solvable.contains(lengths)) << n << " sides";
      std::size_t i = 0;
      while (i < n && ++lengths[i] > most + 1) lengths[i++] = 1;
      if (i == n) break;
    }
  }
}

TEST(PatchFill, GivesTheKnownSpokesOfAFiveSidedPatch) {
  const auto spokes = solve_spokes(Lengths{6, 4, 3, 5, 4});
  ASSERT_TRUE(spokes.has_value());
  EXPECT_EQ((Lengths{spokes->begin(), spokes->begin() + 5}), (Lengths{3, 2, 1, 1, 4}));
}

TEST(PatchFill, HasNoFillWhereTheParityOrTheTriangleInequalityFails) {
  EXPECT_FALSE(solve_fill(Lengths{2, 2, 3}).has_value());
  EXPECT_FALSE(solve_fill(Lengths{1, 1, 2}).has_value());
  EXPECT_FALSE(solve_fill(Lengths{3, 2, 3, 4}).has_value());
  EXPECT_FALSE(solve_pair(Lengths{1, 3, 3, 3}, 0).has_value());
}

TEST(PatchFill, ClosesAroundOneDefectOfThreeFiveOrSix) {
  const std::uint64_t seed = 23;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Dice dice(seed);
  PatchLayout layout;
  for (int round = 0; round < 600; ++round) {
    const std::size_t n = std::array<std::size_t, 3>{3, 5, 6}[dice.between(0, 2)];
    Lengths spokes;
    for (std::size_t i = 0; i < n; ++i) spokes.push_back(dice.between(1, 5));
    const Lengths lengths = lengths_of_spokes(spokes);
    const auto fill = solve_fill(lengths);
    // Six spokes are not unique: what is found may still have to be the given ones' equal in length.
    ASSERT_TRUE(fill.has_value() || n == 6);
    if (!fill) continue;
    const Lengths corners = corners_of(lengths, dice.between(0, lengths.back() - 1));
    std::uint32_t rim = 0;
    for (const std::uint32_t length : lengths) rim += length;
    layout.build(*fill, rim, {}, corners);
    expect_closed(layout, corners, *fill, 1);
    EXPECT_EQ(layout.quads().size(), count_faces(*fill, lengths));
  }
}

TEST(PatchFill, ClosesAGridWithoutADefect) {
  PatchLayout layout;
  for (std::uint32_t a = 1; a < 6; ++a) {
    for (std::uint32_t b = 1; b < 6; ++b) {
      const Lengths lengths{a, b, a, b};
      const auto fill = solve_fill(lengths);
      ASSERT_TRUE(fill.has_value());
      layout.build(*fill, 2 * (a + b), {}, corners_of(lengths, 0));
      expect_closed(layout, corners_of(lengths, 0), *fill, 0);
      EXPECT_EQ(layout.quads().size(), a * b);
    }
  }
}

TEST(PatchFill, ClosesUnequalSidesWithAPair) {
  const std::uint64_t seed = 37;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Dice dice(seed);
  PatchLayout layout;
  int filled = 0;
  for (int round = 0; round < 4000; ++round) {
    const Lengths lengths{dice.between(1, 9), dice.between(1, 9), dice.between(1, 9), dice.between(1, 9)};
    const auto first = static_cast<std::uint8_t>(dice.between(0, 3));
    auto fill = solve_pair(lengths, first);
    if (!fill) continue;
    ++filled;
    fill->split = dice.between(1, lengths[first] - 1);
    const Lengths corners = corners_of(lengths, dice.between(0, lengths.back() - 1));
    layout.build(*fill, lengths[0] + lengths[1] + lengths[2] + lengths[3], {}, corners);
    expect_closed(layout, corners, *fill, 1);
    EXPECT_EQ(layout.quads().size(), count_faces(*fill, lengths));
  }
  EXPECT_GT(filled, 150);
}

// The lengths of the sides after those whose bits are set have been pushed outwards.
Lengths pushed(Lengths lengths, std::uint32_t sides) {
  const std::size_t n = lengths.size();
  for (std::size_t i = 0; i < n; ++i) {
    if ((sides >> i & 1U) == 0) continue;
    ++lengths[(i + 1) % n];
    ++lengths[(i + n - 1) % n];
  }
  return lengths;
}

TEST(PatchFill, FindsAFillByPushingTheSidesThatItNames) {
  const std::uint64_t seed = 41;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Dice dice(seed);
  int helped = 0;
  for (int round = 0; round < 3000; ++round) {
    Lengths lengths(std::array<std::size_t, 4>{3, 4, 5, 6}[dice.between(0, 3)]);
    for (std::uint32_t& length : lengths) length = dice.between(1, 9);
    const auto solved = [&] {
      bool found = solve_fill(lengths).has_value();
      for (std::uint8_t first = 0; lengths.size() == 4 && first < 4; ++first)
        found = found || solve_pair(lengths, first).has_value();
      return found;
    };
    if (solved() || sides_to_push(lengths) == 0) continue;
    ++helped;
    for (int i = 0; i < 20 && !solved(); ++i) lengths = pushed(lengths, sides_to_push(lengths));
    EXPECT_TRUE(solved()) << lengths.size() << " sides";
  }
  EXPECT_GT(helped, 200);
}

TEST(PatchFill, PushesNothingWhereTheParityIsWrong) {
  EXPECT_EQ(sides_to_push(Lengths{1, 1, 4}), 1U << 2);
  EXPECT_EQ(sides_to_push(Lengths{1, 2, 4}), 0U);
  EXPECT_EQ(sides_to_push(Lengths{2, 2, 3, 2}), 0U);
}

// An L with the reflex vertex first: a, b, c = a + e, d = b + f, e, f are the sides from it on.
PatchRing ring_of_l(std::uint32_t a, std::uint32_t b, std::uint32_t e, std::uint32_t f) {
  PatchRing ring;
  ring.targets.push_back(3);
  for (const std::uint32_t length : {a, b, a + e, b + f, e}) {
    ring.targets.insert(ring.targets.end(), length - 1, std::uint8_t{2});
    ring.targets.push_back(1);
  }
  ring.targets.insert(ring.targets.end(), f - 1, std::uint8_t{2});
  for (std::uint32_t i = 0; i < ring.targets.size(); ++i) ring.ids.push_back(i);
  return ring;
}

TEST(PatchCuts, LeaveAGridOfAnLWhicheverWayTheyAreMade) {
  const std::uint64_t seed = 43;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Dice dice(seed);
  PatchLayout layout;
  for (int round = 0; round < 200; ++round) {
    const std::uint32_t a = dice.between(1, 5), b = dice.between(1, 5), e = dice.between(1, 5),
                        f = dice.between(1, 5);
    const PatchRing ring = ring_of_l(a, b, e, f);
    const auto rim = static_cast<std::uint32_t>(ring.size());
    for (const bool mirrored : {false, true}) {
      const auto cut = find_cut(ring, 0, mirrored);
      ASSERT_TRUE(cut.has_value());
      PatchRing left;
      cut_off(ring, *cut, rim, left);
      Lengths corners, lengths;
      for (std::uint32_t i = 0; i < left.size(); ++i)
        if (left.targets[i] == 1) corners.push_back(i);
      ASSERT_EQ(corners.size(), 4U);
      for (std::size_t i = 0; i < 4; ++i)
        lengths.push_back((corners[(i + 1) % 4] + static_cast<std::uint32_t>(left.size()) - corners[i]) %
                          static_cast<std::uint32_t>(left.size()));
      const auto fill = solve_fill(lengths);
      ASSERT_TRUE(fill.has_value());
      layout.build(*fill, rim, std::vector{*cut}, corners);
      EXPECT_EQ(layout.quads().size(), a * b + e * (b + f));
      std::vector<int> faces(layout.vertices(), 0);
      for (const PatchLayout::Quad& quad : layout.quads())
        for (const std::uint32_t v : quad) ++faces[v];
      for (std::uint32_t v = 0; v < layout.vertices(); ++v)
        EXPECT_EQ(faces[v], v < rim ? ring.targets[v] : 4) << "vertex " << v;
    }
  }
}

TEST(PatchCuts, AreNotMadeWhereTheWallWouldEndInACorner) {
  PatchRing ring = ring_of_l(3, 2, 1, 1);
  // The side opposite is three long, as the cut is: the wall ends where it does.
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (i == 3 + 2 + 3) ring.targets[i] = 1;
  EXPECT_FALSE(find_cut(ring, 0, false).has_value());
}

TEST(PatchPlacement, PutsAGridOfASquareOnItsLattice) {
  const Lengths lengths{4, 3, 4, 3};
  PatchLayout layout;
  layout.build(*solve_fill(lengths), 14, {}, corners_of(lengths, 0));
  std::vector<Vec2> points;
  for (int i = 0; i < 4; ++i) points.push_back({1.0 * i, 0});
  for (int i = 0; i < 3; ++i) points.push_back({4, 1.0 * i});
  for (int i = 0; i < 4; ++i) points.push_back({4.0 - i, 3});
  for (int i = 0; i < 3; ++i) points.push_back({0, 3.0 - i});
  place_layout(layout, points);
  std::set<std::pair<int, int>> places;
  for (std::size_t v = layout.rim(); v < layout.vertices(); ++v) {
    EXPECT_NEAR(points[v].x, std::round(points[v].x), 1e-12);
    EXPECT_NEAR(points[v].y, std::round(points[v].y), 1e-12);
    places.insert({static_cast<int>(std::lround(points[v].x)), static_cast<int>(std::lround(points[v].y))});
  }
  EXPECT_EQ(places.size(), 6U);
  for (const PatchLayout::Quad& quad : layout.quads())
    EXPECT_GT(cross(points[quad[1]] - points[quad[0]], points[quad[2]] - points[quad[0]]), 0);
}

// A horseshoe: the straight spokes of its grid would leave it.
TEST(PatchPlacement, RelaxesAGridInABentPatchUntilNoFaceIsTurnedOver) {
  constexpr std::uint32_t kLong = 24, kWide = 6;
  const Lengths lengths{kLong, kWide, kLong, kWide};
  PatchLayout layout;
  layout.build(*solve_fill(lengths), 2 * (kLong + kWide), {}, corners_of(lengths, 0));
  std::vector<Vec2> points;
  const auto at = [](double along, double across) {
    const double angle = -1.5 * 3.14159265358979323846 * along / kLong;
    const double radius = 1 + across / kWide;
    return Vec2{radius * std::cos(angle), radius * std::sin(angle)};
  };
  for (std::uint32_t i = 0; i < kLong; ++i) points.push_back(at(i, 0));
  for (std::uint32_t i = 0; i < kWide; ++i) points.push_back(at(kLong, i));
  for (std::uint32_t i = 0; i < kLong; ++i) points.push_back(at(kLong - i, kWide));
  for (std::uint32_t i = 0; i < kWide; ++i) points.push_back(at(0, kWide - i));
  place_layout(layout, points);
  for (std::size_t v = layout.rim(); v < layout.vertices(); ++v) points[v] = {};
  const std::vector<Vec2> rim(points.begin(), points.begin() + layout.rim());
  LayoutNeighbours neighbours;
  relax_layout(layout, std::vector<bool>(layout.vertices()), points, neighbours);
  EXPECT_TRUE(std::equal(rim.begin(), rim.end(), points.begin()));
  for (const PatchLayout::Quad& quad : layout.quads())
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_GT(
          cross(points[quad[(k + 1) % 4]] - points[quad[k]], points[quad[(k + 3) % 4]] - points[quad[k]]), 0);
}

}  // namespace
}  // namespace quarry
