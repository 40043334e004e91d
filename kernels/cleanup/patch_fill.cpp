#include "kernels/cleanup/patch_fill.hpp"

#include <cassert>
#include <cstdlib>

namespace quarry {
namespace {

// Twice the edges of spoke i of n: the sums of the forms for 3, 5 and 6 sides.
std::int64_t doubled_spoke(std::span<const std::uint32_t> lengths, std::size_t i) {
  const std::size_t n = lengths.size();
  const auto at = [&](std::size_t offset) { return std::int64_t{lengths[(i + offset) % n]}; };
  if (n == 3) return at(1) + at(2) - at(0);
  if (n == 5) return at(4) + at(0) + at(1) - at(2) - at(3);
  return at(1) + at(5) - at(3);
}

std::uint64_t faces_between(std::span<const std::uint32_t> spokes) {
  std::uint64_t faces = 0;
  for (std::size_t i = 0; i < spokes.size(); ++i)
    faces += std::uint64_t{spokes[i]} * spokes[(i + 1) % spokes.size()];
  return faces;
}

// With six sides the forms solve every second equation; the other ones are conditions.
bool spokes_fit(std::span<const std::uint32_t> spokes, std::span<const std::uint32_t> lengths) {
  const std::size_t n = lengths.size();
  for (std::size_t i = 0; i < n; ++i)
    if (lengths[i] != spokes[(i + n - 1) % n] + spokes[(i + 1) % n]) return false;
  return true;
}

}  // namespace

std::optional<std::array<std::uint32_t, 6>> solve_spokes(std::span<const std::uint32_t> lengths) {
  const std::size_t n = lengths.size();
  assert(n == 3 || n == 5 || n == 6);
  std::array<std::uint32_t, 6> spokes{};
  for (std::size_t i = 0; i < n; ++i) {
    const std::int64_t doubled = doubled_spoke(lengths, i);
    if (doubled < 2 || doubled % 2 != 0) return std::nullopt;
    spokes[i] = static_cast<std::uint32_t>(doubled / 2);
  }
  if (!spokes_fit(std::span(spokes).first(n), lengths)) return std::nullopt;
  return spokes;
}

std::optional<PatchFill> solve_fill(std::span<const std::uint32_t> lengths) {
  if (lengths.size() == 4) {
    if (lengths[0] != lengths[2] || lengths[1] != lengths[3]) return std::nullopt;
    return PatchFill{};
  }
  const auto spokes = solve_spokes(lengths);
  if (!spokes) return std::nullopt;
  PatchFill fill;
  fill.kind =
      lengths.size() == 3 ? FillKind::kThree : (lengths.size() == 5 ? FillKind::kFive : FillKind::kSix);
  fill.spokes = *spokes;
  return fill;
}

std::optional<PatchFill> solve_pair(std::span<const std::uint32_t> lengths, std::uint8_t first) {
  assert(lengths.size() == 4);
  const std::uint32_t near = lengths[first % 4U];
  const std::uint32_t far = lengths[(first + 2U) % 4U];
  if (near < 2 || far <= near) return std::nullopt;
  const std::array<std::uint32_t, 3> between = {lengths[(first + 1U) % 4U], far - near,
                                                lengths[(first + 3U) % 4U]};
  const auto spokes = solve_spokes(between);
  if (!spokes) return std::nullopt;
  return PatchFill{FillKind::kPair, first, *spokes, 0};
}

std::uint32_t sides_to_push(std::span<const std::uint32_t> lengths) {
  const std::size_t n = lengths.size();
  std::uint32_t sides = 0;
  if (n == 4) {
    for (std::size_t first = 0; first < 4; ++first) {
      const std::int64_t near = lengths[first], far = lengths[(first + 2) % 4];
      const std::int64_t a = lengths[(first + 1) % 4], b = lengths[(first + 3) % 4];
      const std::int64_t more = far - near;
      if (more <= 0 || (more + a + b) % 2 != 0 || more <= std::abs(a - b)) continue;
      if (near < 2) sides |= 1U << ((first + 1) % 4);
      if (a + b <= more) sides |= 1U << first;
    }
    return sides;
  }
  if (n == 6 &&
      ((lengths[0] + lengths[2] + lengths[4]) % 2 != 0 || (lengths[1] + lengths[3] + lengths[5]) % 2 != 0))
    return 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::int64_t doubled = doubled_spoke(lengths, i);
    if (doubled % 2 != 0) return 0;
    if (doubled < 2) sides |= 1U << i;
  }
  return sides;
}

std::uint64_t count_faces(const PatchFill& fill, std::span<const std::uint32_t> lengths) {
  switch (fill.kind) {
    case FillKind::kGrid:
      return std::uint64_t{lengths[0]} * lengths[1];
    case FillKind::kPair: {
      const std::uint64_t near = lengths[fill.first];
      return fill.split * std::uint64_t{lengths[(fill.first + 3U) % 4U]} +
             (near - fill.split) * lengths[(fill.first + 1U) % 4U] +
             faces_between(std::span(fill.spokes).first(3));
    }
    default:
      return faces_between(std::span(fill.spokes).first(lengths.size()));
  }
}

}  // namespace quarry
