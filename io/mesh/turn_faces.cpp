#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/parallel/sort.hpp"
#include "io/mesh/read_cells.hpp"

namespace quarry {
namespace {

int corner_count(const FaceCorners& face) { return face[3].valid() ? 4 : 3; }

// Faces across edges, as the mesh store has them, but for edges that both faces pass the same way as well.
class FaceGraph {
 public:
  struct Neighbour {
    std::uint32_t face = kNone;
    bool same_way = false;
  };
  static constexpr std::uint32_t kNone = 0xffffffff;

  explicit FaceGraph(const std::vector<FaceCorners>& faces) : neighbours_(4 * faces.size()) {
    std::vector<std::uint64_t> keys;
    std::vector<std::uint32_t> sides;
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (int k = 0; k < corner_count(faces[f]); ++k) {
        const auto [a, b] = side(faces, 4 * f + static_cast<std::size_t>(k));
        keys.push_back((std::uint64_t{std::min(a, b)} << 32) | std::max(a, b));
        sides.push_back(static_cast<std::uint32_t>(4 * f + static_cast<std::size_t>(k)));
      }
    parallel::stable_sort_by_key(keys, sides);
    for (std::size_t i = 0; i < keys.size();) {
      std::size_t end = i + 1;
      while (end < keys.size() && keys[end] == keys[i]) ++end;
      if (end - i == 2) {
        const bool same = side(faces, sides[i]).first == side(faces, sides[i + 1]).first;
        neighbours_[sides[i]] = {sides[i + 1] / 4, same};
        neighbours_[sides[i + 1]] = {sides[i] / 4, same};
      }
      i = end;
    }
  }

  [[nodiscard]] Neighbour across(std::uint32_t face, int side) const {
    return neighbours_[4 * std::size_t{face} + static_cast<std::size_t>(side)];
  }

 private:
  static std::pair<std::uint32_t, std::uint32_t> side(const std::vector<FaceCorners>& faces,
                                                      std::size_t side) {
    const FaceCorners& face = faces[side / 4];
    const std::size_t k = side % 4;
    const std::size_t next = k + 1 == static_cast<std::size_t>(corner_count(face)) ? 0 : k + 1;
    return {face[k].value(), face[next].value()};
  }

  std::vector<Neighbour> neighbours_;
};

double doubled_area(const ReadCells& cells, const FaceCorners& face) {
  const auto point = [&](std::size_t k) { return Vec2{cells.x[face[k].value()], cells.y[face[k].value()]}; };
  if (corner_count(face) == 3) return cross(point(1) - point(0), point(2) - point(0));
  return cross(point(2) - point(0), point(3) - point(1));
}

void turn(FaceCorners& face) { std::swap(face[1], face[corner_count(face) == 4 ? 3 : 2]); }

// Faces of one connected part, each with whether it is turned against the first.
enum class Turn : std::uint8_t { kUnknown, kAsFirst, kAgainstFirst };

class FaceTurner {
 public:
  FaceTurner(const std::string& path, ReadCells& cells)
      : path_(path), cells_(cells), graph_(cells.faces), turn_(cells.faces.size(), Turn::kUnknown) {}

  std::size_t run() {
    std::size_t turned = 0;
    for (std::uint32_t seed = 0; seed < turn_.size(); ++seed)
      if (turn_[seed] == Turn::kUnknown) turned += turn_part(seed);
    return turned;
  }

 private:
  std::size_t turn_part(std::uint32_t seed) {
    part_.assign(1, seed);
    turn_[seed] = Turn::kAsFirst;
    double area = 0;
    for (std::size_t i = 0; i < part_.size(); ++i) {
      const double own = doubled_area(cells_, cells_.faces[part_[i]]);
      area += turn_[part_[i]] == Turn::kAsFirst ? own : -own;
      visit_neighbours(part_[i]);
    }
    const Turn wrong = area < 0 ? Turn::kAsFirst : Turn::kAgainstFirst;
    std::size_t turned = 0;
    for (const std::uint32_t f : part_) {
      if (turn_[f] != wrong) continue;
      turn(cells_.faces[f]);
      ++turned;
    }
    return turned;
  }

  void visit_neighbours(std::uint32_t f) {
    for (int k = 0; k < corner_count(cells_.faces[f]); ++k) {
      const auto [other, same_way] = graph_.across(f, k);
      if (other == FaceGraph::kNone) continue;
      const bool as_first = (turn_[f] == Turn::kAsFirst) != same_way;
      const Turn wanted = as_first ? Turn::kAsFirst : Turn::kAgainstFirst;
      if (turn_[other] == Turn::kUnknown) {
        turn_[other] = wanted;
        part_.push_back(other);
      } else if (turn_[other] != wanted) {
        const std::uint32_t v = cells_.faces[f][static_cast<std::size_t>(k)].value();
        throw Error(ErrorKind::kInput,
                    fmt::format("{}: the faces around {} cannot all be turned counter-clockwise: they form a "
                                "band that is twisted",
                                path_, format_point(cells_.x[v], cells_.y[v])));
      }
    }
  }

  const std::string& path_;
  ReadCells& cells_;
  FaceGraph graph_;
  std::vector<Turn> turn_;
  std::vector<std::uint32_t> part_;
};

// Corners out of range are told by what makes a mesh of them.
bool corners_exist(const ReadCells& cells) {
  return std::all_of(cells.faces.begin(), cells.faces.end(), [&](const FaceCorners& face) {
    for (int k = 0; k < corner_count(face); ++k)
      if (face[static_cast<std::size_t>(k)].value() >= cells.x.size()) return false;
    return true;
  });
}

}  // namespace

std::size_t turn_counterclockwise(const std::string& path, ReadCells& cells) {
  return corners_exist(cells) ? FaceTurner(path, cells).run() : 0;
}

}  // namespace quarry
