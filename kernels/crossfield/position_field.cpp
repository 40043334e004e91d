#include "kernels/crossfield/position_field.hpp"

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

// A square lattice in a tangent plane.
struct Lattice {
  Vec3 at, normal;     // the vertex, and the normal there
  Vec3 along, across;  // unit
  double spacing;

  [[nodiscard]] Vec3 moved(Vec3 origin, double i, double j) const {
    return origin + (i * spacing) * along + (j * spacing) * across;
  }
  [[nodiscard]] Vec2 relative(Vec3 origin, Vec3 p) const {
    const Vec3 d = p - origin;
    return {dot(d, along) / spacing, dot(d, across) / spacing};
  }
  // The lattice point nearest to p.
  [[nodiscard]] Vec3 nearest(Vec3 origin, Vec3 p) const {
    const Vec2 r = relative(origin, p);
    return moved(origin, whole(r.x), whole(r.y));
  }
  // The corner with the smallest coordinates of the cell around p.
  [[nodiscard]] Vec3 before(Vec3 origin, Vec3 p) const {
    const Vec2 r = relative(origin, p);
    return moved(origin, whole(r.x - 0.5), whole(r.y - 0.5));
  }
};

// The point of both tangent planes that is nearest to both vertices.
Vec3 between(const Lattice& a, const Lattice& b) {
  const double aa = dot(a.normal, a.at), ab = dot(a.normal, b.at);
  const double ba = dot(b.normal, a.at), bb = dot(b.normal, b.at);
  const double c = dot(a.normal, b.normal);
  const double factor = 1 / (1 - c * c + 1e-4);
  const double l = 2 * (ab - aa - c * (ba - bb)) * factor;
  const double m = 2 * (ba - bb - c * (ab - aa)) * factor;
  return 0.5 * (a.at + b.at) - 0.25 * (l * a.normal + m * b.normal);
}

// Of the corners of the cell of the first lattice around a place between the vertices that which has a point
// of the second one nearest to it, and that point.
std::pair<Vec3, Vec3> nearest_pair(const Lattice& a, Vec3 origin_a, const Lattice& b, Vec3 origin_b) {
  const Vec3 middle = between(a, b);
  const Vec3 low = a.before(origin_a, middle);
  std::pair<Vec3, Vec3> best;
  double least = -1;
  for (int i = 0; i < 4; ++i) {
    const Vec3 p = a.moved(low, i & 1, i >> 1);
    const Vec3 q = b.nearest(origin_b, p);
    const Vec3 d = q - p;
    const double squared = dot(d, d);
    if (least >= 0 && !(squared < least)) continue;
    least = squared;
    best = {p, q};
  }
  return best;
}

// What is known by vertex of a level.
struct LevelData {
  std::vector<Vec3> crosses;
  std::vector<double> spacing;
  std::vector<Vec3> places;
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
  result.places.resize(coarse.size());
  parallel::for_each(coarse.size(), [&](std::size_t i) {
    result.crosses[i] = cross_of_children(fine, coarse, i, data.crosses);
    for (const std::uint32_t child : coarse.children[i])
      if (child != FieldLevel::kNone)
        result.spacing[i] += fine.mass[child] / coarse.mass[i] * data.spacing[child];
    result.places[i] = data.places[coarse.children[i][0]];
  });
  return result;
}

class PositionSweeper {
 public:
  PositionSweeper(const FieldLevel& level, LevelData& data) : level_(level), data_(data) {}

  void sweep() {
    for (const auto& members : level_.classes)
      parallel::for_each(
          members.size(), [&](std::size_t k) { average(members[k]); }, kFieldChunk);
  }

 private:
  [[nodiscard]] Lattice lattice(std::uint32_t i, double spacing) const {
    return {level_.points[i], level_.normals[i], data_.crosses[i], cross(level_.normals[i], data_.crosses[i]),
            spacing};
  }

  void average(std::uint32_t i) {
    Vec3 sum = data_.places[i];
    double weights = 0;
    for (std::uint32_t e = level_.first[i]; e < level_.first[i + 1]; ++e) {
      const std::uint32_t j = level_.other[e];
      const double w = level_.weight[e];
      if (!(w > 0)) continue;
      const double spacing = 0.5 * (data_.spacing[i] + data_.spacing[j]);
      const auto [mine, theirs] =
          nearest_pair(lattice(i, spacing), sum, lattice(j, spacing), data_.places[j]);
      sum = weights * mine + w * theirs;
      weights += w;
      sum = (1 / weights) * sum;
      const Vec3 n = level_.normals[i];
      sum = sum - dot(n, sum - level_.points[i]) * n;
    }
    if (weights > 0) data_.places[i] = lattice(i, data_.spacing[i]).nearest(sum, level_.points[i]);
  }

  const FieldLevel& level_;
  LevelData& data_;
};

}  // namespace

std::vector<Vec3> position_field(std::span<const FieldLevel> levels, std::span<const Vec3> crosses,
                                 std::span<const double> spacing, std::span<const Vec3> places,
                                 const PositionFieldOptions& options) {
  std::vector<LevelData> data(levels.size());
  data[0] = {
      {crosses.begin(), crosses.end()}, {spacing.begin(), spacing.end()}, {places.begin(), places.end()}};
  for (std::size_t l = 1; l < levels.size(); ++l)
    data[l] = coarser_data(levels[l - 1], levels[l], data[l - 1]);
  std::vector<Vec3> result = levels.back().points;
  for (std::size_t l = levels.size(); l-- > 0;) {
    const FieldLevel& level = levels[l];
    std::vector<Vec3>& mine = data[l].places;
    parallel::for_each(level.size(), [&](std::size_t i) {
      if (level.given[i] != 0) return;
      const Vec3 from = l + 1 < levels.size() ? result[level.parent[i]] : level.points[i];
      mine[i] = from - dot(level.normals[i], from - level.points[i]) * level.normals[i];
    });
    PositionSweeper sweeper(level, data[l]);
    for (int s = 0; s < options.sweeps; ++s) sweeper.sweep();
    result = std::move(mine);
  }
  return result;
}

}  // namespace quarry
