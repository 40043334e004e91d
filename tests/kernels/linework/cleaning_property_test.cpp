// Random soups: whatever the lines, cleaning ends, keeps its promises (checked exactly by clean_lines) and
// stays within its budget.
#include <cmath>
#include <cstdint>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "engine/parallel/parallel.hpp"
#include "line_samples.hpp"

namespace quarry {
namespace {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : seed_(seed) {}
  double operator()(double low, double high) { return low + (high - low) * uniform01(seed_, counter_++); }

 private:
  std::uint64_t seed_;
  std::uint64_t counter_ = 0;
};

// Lines in a box of side 10: random segments, short and crooked lines, copies shifted by about the snapping
// distance, ends near other lines, lines through common points, shared vertices, some on a coarse lattice.
LineSet soup(std::uint64_t seed, Vec2 origin) {
  Dice dice(seed);
  std::vector<Points> lines;
  const auto anywhere = [&] { return Vec2{dice(0, 10), dice(0, 10)}; };
  const auto near = [&](Vec2 p, double r) { return p + Vec2{dice(-r, r), dice(-r, r)}; };
  const int count = 4 + static_cast<int>(dice(0, 26));
  for (int i = 0; i < count; ++i) {
    const double kind = dice(0, 1);
    Points line{anywhere()};
    const double step = std::pow(10, dice(-2, 1));
    const int length = 1 + static_cast<int>(dice(0, 8));
    if (kind < 0.5 || lines.empty()) {
      for (int k = 0; k < length; ++k) line.push_back(near(line.back(), step));
    } else {
      const Points& other = lines[static_cast<std::size_t>(dice(0, static_cast<double>(lines.size())))];
      const double shift = std::pow(10, dice(-4, -0.5));
      if (kind < 0.65) {
        line.clear();
        for (const Vec2 p : other) line.push_back(near(p, shift));
      } else if (kind < 0.8) {
        const std::size_t s = static_cast<std::size_t>(dice(0, static_cast<double>(other.size() - 1)));
        line.push_back(near(point_at(dice(0, 1), other[s], other[s + 1]), shift));
      } else {
        line.push_back(other[static_cast<std::size_t>(dice(0, static_cast<double>(other.size())))]);
        line.push_back(anywhere());
      }
    }
    if (dice(0, 1) < 0.15)
      for (Vec2& p : line) p = {std::round(p.x), std::round(p.y)};
    if (dice(0, 1) < 0.1 && line.size() > 2) line.push_back(line.front());
    lines.push_back(line);
  }
  for (Points& line : lines)
    for (Vec2& p : line) p = p + origin;
  return lines_of(lines);
}

void expect_same(const CleanedLines& a, const CleanedLines& b) {
  EXPECT_EQ(a.lines.nodes.raw(), b.lines.nodes.raw());
  EXPECT_EQ(a.lines.line_begin, b.lines.line_begin);
  EXPECT_EQ(a.lines.line_numbers, b.lines.line_numbers);
  ASSERT_EQ(a.lines.pieces.size(), b.lines.pieces.size());
  for (const PieceId p : IdRange<PieceId>(a.lines.pieces.size())) {
    EXPECT_EQ(a.lines.pieces[p].from, b.lines.pieces[p].from);
    EXPECT_EQ(a.lines.pieces[p].to, b.lines.pieces[p].to);
  }
}

void clean_soups(std::uint64_t first, std::uint64_t last, Vec2 origin, double size) {
  const CleanOptions options{0.05 * size, 0.1 * size, 0.05 * size};
  for (std::uint64_t seed = first; seed < last; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const LineSet raw = soup(seed, origin);
    const Outline outline = seed % 2 == 0 ? box_outline(raw, options.snap) : wide_box(raw);
    CleanedLines result;
    ASSERT_NO_THROW(result = clean_lines(raw, outline, options));
    expect_faithful(raw, result);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(CleaningSoups, StayWithinTheBudget) { clean_soups(0, 600, {}, 0.3); }
TEST(CleaningSoups, StayWithinTheBudgetWhereSnapIsLarge) { clean_soups(1000, 1600, {}, 1.0); }
TEST(CleaningSoups, StayWithinTheBudgetWhereSnapIsSmall) { clean_soups(2000, 2300, {}, 0.001); }
TEST(CleaningSoups, StayWithinTheBudgetFarFromTheOrigin) {
  clean_soups(3000, 3400, {466'000, 6'700'000}, 0.2);
}

TEST(CleaningSoups, AreTheSameOnAnyNumberOfThreads) {
  LineSet raw;
  raw.files = {"made.geojson"};
  for (std::uint64_t seed = 0; seed < 60; ++seed)
    for (const InputLine& line : soup(seed, {}).lines) raw.lines.push_back(line);
  const CleanOptions options{0.005, 0.01, 0.005};
  CleanedLines serial;
  parallel::with_threads(1, [&] { serial = clean_lines(raw, box_outline(raw, 0.005), options); });
  for (const int threads : {2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    CleanedLines other;
    parallel::with_threads(threads, [&] { other = clean_lines(raw, box_outline(raw, 0.005), options); });
    expect_same(serial, other);
    EXPECT_GT(probe.chunks_of_other_threads(), 0U);
  }
}

}  // namespace
}  // namespace quarry
