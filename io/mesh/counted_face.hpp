// A face as a count of corners and the numbers of so many points: what several formats have in common.
#pragma once

#include <cstdint>

#include "engine/mesh/build.hpp"
#include "io/text_cursor.hpp"

namespace quarry {

// What is wrong with a number of corners that is neither 3 nor 4.
[[nodiscard]] std::string wrong_corner_count(std::int64_t count);
// What is wrong with the number of a point, where points are counted from 0.
[[nodiscard]] std::string missing_point(std::int64_t number, std::size_t points);

// Reads "3 0 1 2" from this line, as a face of that many points that are counted from 0.
[[nodiscard]] inline FaceCorners read_counted_face(TextCursor& cursor, std::size_t points) {
  const auto count = cursor.number_in_line<std::int64_t>("the number of corners");
  if (count != 3 && count != 4) cursor.fail(wrong_corner_count(count));
  FaceCorners corners;
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    const auto number = cursor.number_in_line<std::int64_t>("the number of a point");
    if (number < 0 || static_cast<std::size_t>(number) >= points) cursor.fail(missing_point(number, points));
    corners[k] = VertexId(static_cast<std::size_t>(number));
  }
  return corners;
}

}  // namespace quarry
