// Cleaning gives the same bits on any number of threads.
#include <cstdint>

#include <gtest/gtest.h>

#include "engine/parallel/parallel.hpp"
#include "tests/kernels/linework/line_samples.hpp"
#include "tests/kernels/linework/random_lines.hpp"

namespace quarry {
namespace {

void expect_same(const CleanedLines& a, const CleanedLines& b) {
  EXPECT_EQ(a.lines.nodes.raw(), b.lines.nodes.raw());
  EXPECT_EQ(a.lines.line_begin, b.lines.line_begin);
  EXPECT_EQ(a.lines.line_numbers, b.lines.line_numbers);
  ASSERT_EQ(a.lines.pieces.size(), b.lines.pieces.size());
  for (const PieceId p : IdRange<PieceId>(a.lines.pieces.size())) {
    EXPECT_EQ(a.lines.pieces[p].from, b.lines.pieces[p].from);
    EXPECT_EQ(a.lines.pieces[p].to, b.lines.pieces[p].to);
  }
  ASSERT_EQ(a.ledger.size(), b.ledger.size());
  for (const LineId id : IdRange<LineId>(a.ledger.size())) {
    EXPECT_EQ(a.ledger[id].fate, b.ledger[id].fate);
    EXPECT_EQ(a.ledger[id].with, b.ledger[id].with);
    EXPECT_EQ(a.ledger[id].why, b.ledger[id].why);
    EXPECT_EQ(a.ledger[id].moved, b.ledger[id].moved);
  }
}

void expect_same_on_threads(const LineSet& raw, const CleanOptions& options) {
  const Outline outline = box_outline(raw, options.snap);
  CleanedLines serial;
  parallel::with_threads(1, [&] { serial = clean_lines(raw, outline, options); });
  for (const int threads : {2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    CleanedLines other;
    parallel::with_threads(threads, [&] { other = clean_lines(raw, outline, options); });
    expect_same(serial, other);
    EXPECT_GT(probe.chunks_of_other_threads(), 0U);
  }
}

TEST(CleaningThreads, GiveTheSameSoups) {
  LineSet raw;
  raw.files = {"made.geojson"};
  for (std::uint64_t seed = 0; seed < 15; ++seed)
    for (const InputLine& line : soup(seed, {}).lines) raw.lines.push_back(line);
  expect_same_on_threads(raw, {0.005, 0.01, 0.005});
}

// So many that every loop has several chunks, and only a part of the network changes in the later rounds.
TEST(CleaningThreads, GiveTheSameLargeNetwork) {
  Dice dice(5);
  std::vector<Points> lines;
  for (int i = 0; i < 2500; ++i) {
    const Vec2 from{dice(0, 100), dice(0, 100)};
    lines.push_back({from, from + Vec2{dice(-5, 5), dice(-5, 5)}});
  }
  expect_same_on_threads(lines_of(lines), {0.02, 0.04, 0.02});
}

}  // namespace
}  // namespace quarry
