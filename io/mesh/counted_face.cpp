#include "io/mesh/counted_face.hpp"

#include <fmt/format.h>

namespace quarry {

std::string wrong_corner_count(std::int64_t count) {
  if (count > 4) return "a face has more than 4 corners; cut it into triangles and quads";
  return fmt::format("a face has {} corners; 3 or 4 are needed", count);
}

std::string missing_point(std::int64_t number, std::size_t points) {
  return fmt::format("point {} does not exist; there are {} points, counted from 0", number, points);
}

}  // namespace quarry
