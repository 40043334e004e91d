#include "io/lines/line_attributes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "engine/base/log.hpp"
#include "io/lines/text_encoding.hpp"
#include "io/lower_case.hpp"
#include "io/number_text.hpp"
#include "io/text_rows.hpp"

namespace quarry {
namespace {

constexpr const char* kGuess = "CP1252";

// One line, without the blanks around it.
std::string one_line(std::string_view text) {
  std::string line(trimmed(text));
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  return line;
}

}  // namespace

bool AttributeCollector::knows(std::string_view key) {
  const std::string name = lower_case(trimmed(key));
  return name == "name" || name == "set" || name == "material" || name == "aperture" || name == "layer";
}

void AttributeCollector::set(std::string_view key, std::string_view value) {
  const std::string name = lower_case(trimmed(key));
  value = trimmed(value);
  if (name == "aperture" && !value.empty()) {
    double number = -1;
    const auto [stop, failure] = read_number(value.data(), value.data() + value.size(), number);
    const bool whole = failure == std::errc() && stop == value.data() + value.size();
    set(key, whole ? number : -1);
    return;
  }
  if (!knows(name)) return;
  guessed_ = guessed_ || !is_utf8(value);
  const std::string text = one_line(is_utf8(value) ? std::string(value) : to_utf8(value, kGuess));
  if (name == "name") current_.name = text;
  if (name == "set") current_.set = text;
  if (name == "material") current_.material = text;
  if (name == "layer") layer_ = text;
}

void AttributeCollector::set(std::string_view key, double value) {
  if (lower_case(trimmed(key)) != "aperture") return set(key, fmt::format("{}", value));
  if (std::isfinite(value) && value >= 0)
    current_.aperture = value;
  else
    ++unreadable_;
}

void AttributeCollector::assign(const LineSetMark& first, LineSet& lines) {
  LineAttributes attributes = std::exchange(current_, {});
  const std::string layer = std::exchange(layer_, {});
  if (attributes.set.empty()) attributes.set = layer;
  if (attributes.empty() || (first.lines == lines.lines.size() && first.points == lines.points.size()))
    return;
  if (lines.attributes.empty() || lines.attributes.back() != attributes)
    lines.attributes.push_back(attributes);
  const auto index = static_cast<std::uint32_t>(lines.attributes.size() - 1);
  for (std::size_t i = first.lines; i < lines.lines.size(); ++i) lines.lines[LineId(i)].attributes = index;
  for (std::size_t i = first.points; i < lines.points.size(); ++i)
    lines.points[PointId(i)].attributes = index;
}

void AttributeCollector::tell(const std::string& file) const {
  if (unreadable_ > 0)
    log::warn("{}: {} aperture{} no number of 0 or more: left out", file, unreadable_,
              unreadable_ == 1 ? " is" : "s are");
  if (guessed_)
    log::warn("{}: texts are neither UTF-8 nor in an encoding that is told: taken for {}", file, kGuess);
}

}  // namespace quarry
