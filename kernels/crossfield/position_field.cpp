#include "kernels/crossfield/position_field.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

#include "engine/parallel/parallel.hpp"
#include "kernels/crossfield/cross_field.hpp"

namespace quarry {
namespace {

// The nearest whole number, for numbers up to 2^51: std::round is a call, and half of the time here.
double whole(double x) {
  constexpr double kRounder = 0x1.8p52;
  return (x + kRounder) - kRounder;
}
// Beside the nearest point of the lattice.
Vec2 wrapped(Vec2 p) { return {p.x - whole(p.x), p.y - whole(p.y)}; }

// A vector by its coordinates along a cross and across it, as seen after so many quarter turns of the cross
// to the left.
Vec2 after_turns(Vec2 p, int turns) {
  switch (turns) {
    case 1:
      return {p.y, -p.x};
    case 2:
      return {-p.x, -p.y};
    case 3:
      return {-p.y, p.x};
    default:
      return p;
  }
}

// What is known by vertex of a level. offsets: of the lattice point from the vertex, in spacings, along the
// cross and across it.
struct LevelData {
  std::vector<Vec3> crosses;
  std::vector<double> spacing;
  std::vector<Vec2> offsets;
};

// The direction that stands for those of a vertex's children.
Vec3 cross_of_children(const FieldLevel& fine, const FieldLevel& coarse, std::size_t i,
                       const std::vector<Vec3>& crosses) {
  Vec2 sum;
  for (const std::uint32_t child : coarse.children[i])
    if (child != FieldLevel::kNone)
      sum = sum + fine.mass[child] * complex_product(conjugate(fine.from_parent[child]),
                                                     cross_number(fine, child, crosses[child]));
  return cross_direction(coarse, i, sum);
}

LevelData coarser_data(const FieldLevel& fine, const FieldLevel& coarse, const LevelData& data) {
  LevelData result;
  result.crosses.resize(coarse.size());
  result.spacing.resize(coarse.size());
  result.offsets.resize(coarse.size());
  parallel::for_each(coarse.size(), [&](std::size_t i) {
    result.crosses[i] = cross_of_children(fine, coarse, i, data.crosses);
    for (const std::uint32_t child : coarse.children[i])
      if (child != FieldLevel::kNone)
        result.spacing[i] += fine.mass[child] / coarse.mass[i] * data.spacing[child];
    result.offsets[i] = data.offsets[coarse.children[i][0]];
  });
  return result;
}

// From a vertex to its neighbour in a row: the way there in spacings of the lattice between the two, along
// the cross here and across it; and how many quarter turns to the left take the cross there to the one here.
struct Step {
  Vec2 way;
  int turns;
};

Step step_between(const FieldLevel& level, const LevelData& data, std::size_t i, std::size_t j) {
  const Vec3 along = data.crosses[i];
  const Vec3 across = cross(level.normals[i], along);
  Vec3 theirs = data.crosses[j];
  Vec3 theirs_across = cross(level.normals[j], theirs);
  const double c = dot(along, theirs);
  const double s = dot(along, theirs_across);
  Step step{{}, 0};
  if (std::abs(s) > std::abs(c)) {
    step.turns = s > 0 ? 1 : 3;
    std::swap(theirs, theirs_across);
    (s > 0 ? theirs_across : theirs) = -1.0 * (s > 0 ? theirs_across : theirs);
  } else if (c < 0) {
    step.turns = 2;
    theirs = -1.0 * theirs;
    theirs_across = -1.0 * theirs_across;
  }
  const Vec3 d = level.points[j] - level.points[i];
  const double size = data.spacing[i] + data.spacing[j];
  step.way = {dot(d, along + theirs) / size, dot(d, across + theirs_across) / size};
  return step;
}

class PositionSweeper {
 public:
  PositionSweeper(const FieldLevel& level, LevelData& data)
      : level_(level), offsets_(data.offsets), steps_(level.other.size()) {
    parallel::for_each(level.size(), [&](std::size_t i) {
      if (level.given[i] != 0) return;
      for (std::uint32_t e = level.first[i]; e < level.first[i + 1]; ++e)
        steps_[e] = step_between(level, data, i, level.other[e]);
    });
  }

  void sweep() {
    for (const auto& members : level_.classes)
      parallel::for_each(
          members.size(), [&](std::size_t k) { average(members[k]); }, kFieldChunk);
  }

 private:
  // To the middle of where the neighbours see the lattice, one after the other: each has the point that is
  // nearest to the middle of those before, which forgets where the vertex had its own.
  void average(std::uint32_t i) {
    Vec2 middle = offsets_[i];
    double weights = 0;
    for (std::uint32_t e = level_.first[i]; e < level_.first[i + 1]; ++e) {
      const double w = level_.weight[e];
      if (!(w > 0)) continue;
      const Step& step = steps_[e];
      weights += w;
      const Vec2 seen = step.way + after_turns(offsets_[level_.other[e]], step.turns);
      middle = middle + (w / weights) * wrapped(seen - middle);
    }
    offsets_[i] = wrapped(middle);
  }

  const FieldLevel& level_;
  std::vector<Vec2>& offsets_;
  std::vector<Step> steps_;
};

// The point of a lattice, and its offset.
Vec3 place_of(const FieldLevel& level, const LevelData& data, std::size_t i) {
  const Vec3 along = data.crosses[i];
  const Vec2 p = data.spacing[i] * data.offsets[i];
  return level.points[i] + p.x * along + p.y * cross(level.normals[i], along);
}
Vec2 offset_of(const FieldLevel& level, const LevelData& data, std::size_t i, Vec3 place) {
  const Vec3 d = (1 / data.spacing[i]) * (place - level.points[i]);
  return {dot(d, data.crosses[i]), dot(d, cross(level.normals[i], data.crosses[i]))};
}

}  // namespace

std::vector<Vec3> position_field(std::span<const FieldLevel> levels, std::span<const Vec3> crosses,
                                 std::span<const double> spacing, std::span<const Vec3> places,
                                 const PositionFieldOptions& options) {
  std::vector<LevelData> data(levels.size());
  data[0] = {{crosses.begin(), crosses.end()}, {spacing.begin(), spacing.end()}, {}};
  data[0].offsets.resize(levels[0].size());
  parallel::for_each(levels[0].size(), [&](std::size_t i) {
    if (levels[0].given[i] != 0) data[0].offsets[i] = offset_of(levels[0], data[0], i, places[i]);
  });
  for (std::size_t l = 1; l < levels.size(); ++l)
    data[l] = coarser_data(levels[l - 1], levels[l], data[l - 1]);
  std::vector<Vec3> result;
  for (std::size_t l = levels.size(); l-- > 0;) {
    const FieldLevel& level = levels[l];
    parallel::for_each(level.size(), [&](std::size_t i) {
      if (level.given[i] != 0) return;
      data[l].offsets[i] =
          result.empty() ? Vec2() : wrapped(offset_of(level, data[l], i, result[level.parent[i]]));
    });
    PositionSweeper sweeper(level, data[l]);
    for (int s = 0; s < options.sweeps; ++s) sweeper.sweep();
    result.resize(level.size());
    parallel::for_each(level.size(), [&](std::size_t i) { result[i] = place_of(level, data[l], i); });
  }
  return result;
}

}  // namespace quarry
