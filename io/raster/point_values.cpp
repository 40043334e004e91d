#include "io/raster/point_values.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <cctype>
#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/mapped_file.hpp"
#include "io/text_cursor.hpp"

namespace quarry {
namespace {

// The text with blanks in place of commas, semicolons and comments, and of the first line if that is a
// heading.
std::string plain(std::string_view text) {
  std::string result(text);
  const auto is_letter = [](unsigned char c) { return std::isalpha(c) != 0 || c == '"'; };
  const auto first =
      std::find_if(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c) == 0; });
  bool hidden = first != text.end() && is_letter(static_cast<unsigned char>(*first));
  for (char& c : result) {
    if (c == '\n') hidden = false;
    if (c == '#') hidden = true;
    if (c != '\n' && (hidden || c == ',' || c == ';')) c = ' ';
  }
  return result;
}

}  // namespace

std::vector<PointValue> read_point_values(const std::string& path) {
  const std::string text = plain(MappedFile(path).text());
  TextCursor cursor(path, text);
  std::vector<PointValue> points;
  while (!cursor.at_end()) {
    PointValue point;
    point.at.x = cursor.coordinate();
    point.at.y = cursor.coordinate();
    point.value = cursor.number_in_line<double>("a value");
    if (!std::isfinite(point.value)) cursor.fail("the value is not a finite number");
    if (!cursor.at_line_end()) cursor.fail("x, y and one value are expected, and nothing more");
    points.push_back(point);
  }
  if (points.empty()) throw Error(ErrorKind::kInput, fmt::format("{}: there are no points in it", path));
  return points;
}

}  // namespace quarry
