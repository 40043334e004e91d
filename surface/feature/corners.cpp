#include "surface/feature/corners.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geometry/space_segment.hpp"
#include "engine/geometry/straight_runs.hpp"

namespace quarry {
namespace {

// A corner beside another one that a straight way would miss by no more than this, in sizes, is a tooth.
constexpr double kLowest = 0.1;

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

class Turns {
 public:
  Turns(std::span<const Vec3> chain, ChainEnds ends, double reach)
      : chain_(chain), closed_(ends == ChainEnds::kClosed), reach_(reach), along_(chain.size(), 0) {
    for (std::size_t i = 1; i < chain.size(); ++i)
      along_[i] = along_[i - 1] + length(chain[i] - chain[i - 1]);
    // Round a short closed course the chords would meet.
    if (closed_) reach_ = std::min(reach_, along_.back() / 4);
  }

  // In radians; with the reach of all others, or with a shorter one.
  [[nodiscard]] double at(std::size_t i) const { return at(i, reach_); }
  [[nodiscard]] double at(std::size_t i, double reach) const {
    const double before = i > 0 ? along_[i - 1] : along_[chain_.size() - 2] - total();
    const Vec3 in = chain_[i] - place(std::min(along_[i] - reach, before));
    const Vec3 out = place(std::max(along_[i] + reach, along_[i + 1])) - chain_[i];
    return std::atan2(length(cross(in, out)), dot(in, out));
  }

  // How far the chain leaves a straight way from a point that stays past this one, to where the reach ends
  // on the other side of it.
  [[nodiscard]] double height(std::size_t i, std::size_t stays) const {
    double back = along_[stays] - along_[i];
    if (closed_ && std::abs(back) > 0.5 * total()) back -= std::copysign(total(), back);
    const Vec3 beyond = place(along_[i] + (back > 0 ? -reach_ : reach_));
    return length(chain_[i] - closest_on_segment(chain_[i], chain_[stays], beyond));
  }

  // Along the chain, the shorter way where it is closed.
  [[nodiscard]] double distance(std::size_t i, std::size_t j) const {
    const double straight = std::abs(along_[i] - along_[j]);
    return closed_ ? std::min(straight, total() - straight) : straight;
  }

 private:
  [[nodiscard]] double total() const { return along_.back(); }

  // The point at a length along the chain: kept between its ends, or round the course.
  [[nodiscard]] Vec3 place(double s) const {
    if (closed_) s -= std::floor(s / total()) * total();
    if (s <= 0) return chain_.front();
    if (s >= total()) return chain_.back();
    const auto after =
        static_cast<std::size_t>(std::upper_bound(along_.begin(), along_.end(), s) - along_.begin());
    const double edge = along_[after] - along_[after - 1];
    return chain_[after - 1] + ((s - along_[after - 1]) / edge) * (chain_[after] - chain_[after - 1]);
  }

  std::span<const Vec3> chain_;
  bool closed_;
  double reach_;
  std::vector<double> along_;
};

// A closed course may begin in the middle of a straight stretch.
std::vector<std::uint32_t> bends_between(std::span<const Vec3> chain, ChainEnds ends, double straightness) {
  std::vector<std::uint32_t> bends = find_bends(chain, straightness);
  bends.pop_back();
  if (ends == ChainEnds::kNodes) {
    bends.erase(bends.begin());
    return bends;
  }
  const std::uint32_t first = bends[1];
  const auto count = static_cast<std::uint32_t>(chain.size() - 1);
  std::vector<Vec3> course(chain.begin(), chain.end() - 1);
  std::rotate(course.begin(), course.begin() + first, course.end());
  course.push_back(course.front());
  bends = find_bends(course, straightness);
  bends.pop_back();
  for (std::uint32_t& bend : bends) bend = (bend + first) % count;
  std::sort(bends.begin(), bends.end());
  return bends;
}

}  // namespace

std::vector<std::uint32_t> find_corners(std::span<const Vec3> chain, ChainEnds ends,
                                        const FeatureOptions& options) {
  if (options.straightness) return bends_between(chain, ends, *options.straightness);
  struct Corner {
    double turn;
    std::uint32_t at;
  };
  const Turns turns(chain, ends, options.size);
  const std::uint32_t first = ends == ChainEnds::kClosed ? 0 : 1;
  std::vector<Corner> found;
  for (std::uint32_t i = first; i + 1 < chain.size(); ++i) {
    const double turn = turns.at(i);
    if (degrees(turn) >= options.corner_degrees) found.push_back({turn, i});
  }
  std::sort(found.begin(), found.end(), [](const Corner& a, const Corner& b) {
    return a.turn != b.turn ? a.turn > b.turn : a.at < b.at;
  });
  std::vector<std::uint32_t> corners;
  for (const Corner& corner : found) {
    // Between two that are close a curve may be bent all the way.
    const auto close = [&](std::size_t other) {
      const double away = turns.distance(corner.at, other);
      if (away >= options.size) return false;
      return degrees(turns.at(corner.at, away)) < options.corner_degrees ||
             turns.height(corner.at, other) <= kLowest * options.size;
    };
    const bool at_node = ends == ChainEnds::kNodes && (close(0) || close(chain.size() - 1));
    if (!at_node && std::none_of(corners.begin(), corners.end(), close)) corners.push_back(corner.at);
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

}  // namespace quarry
