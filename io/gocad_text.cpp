#include "io/gocad_text.hpp"

#include <algorithm>

#include <cctype>
#include <fmt/format.h>

namespace quarry {

bool GocadText::next_object() {
  if (cursor_.at_end()) return false;
  if (const std::string_view word = cursor_.word(); word != "GOCAD")
    cursor_.fail(fmt::format("GOCAD and the sort of an object are expected, not \"{}\"", word.substr(0, 40)));
  sort_ = cursor_.word_in_line("the sort of an object");
  cursor_.line();
  name_ = {};
  depth_ = false;
  return true;
}

bool GocadText::next_line() {
  for (;; cursor_.line()) {
    if (cursor_.at_end()) cursor_.fail("the file ends too early: END is missing");
    key_ = cursor_.word();
    if (key_ == "END") cursor_.line();
    if (!key_.starts_with('#')) return key_ != "END";
  }
}

void GocadText::read_direction() {
  const std::string_view direction = cursor_.word_in_line("Elevation or Depth");
  depth_ = direction == "Depth";
  if (!depth_ && direction != "Elevation")
    cursor_.fail(fmt::format("Elevation or Depth is expected, not \"{}\"", direction.substr(0, 40)));
  cursor_.line();
}

// "HEADER {", lines of attributes, "}", or all of that on one line; "HDR name:..."; the rest of a line that
// says nothing to us.
void GocadText::read_attributes() {
  if (key_ == "ZPOSITIVE") return read_direction();
  if (std::isalpha(static_cast<unsigned char>(key_.front())) == 0)
    cursor_.fail(fmt::format("a key is expected, not \"{}\"", key_.substr(0, 40)));
  const bool header = key_ == "HEADER" || key_ == "HDR";
  std::string_view line = cursor_.line();
  const bool block = line.find('{') != std::string_view::npos;
  for (;;) {
    if (header) read_name(line);
    if (!block || line.find('}') != std::string_view::npos) return;
    if (cursor_.at_end()) cursor_.fail("the file ends too early: } is missing");
    line = cursor_.line();
  }
}

void GocadText::read_name(std::string_view attribute) {
  constexpr std::string_view kBlanks = " \t\r{";
  constexpr std::string_view kKey = "name:";
  attribute.remove_prefix(std::min(attribute.find_first_not_of(kBlanks), attribute.size()));
  if (!attribute.starts_with(kKey)) return;
  attribute.remove_prefix(std::min(attribute.find_first_not_of(kBlanks, kKey.size()), attribute.size()));
  attribute = attribute.substr(0, attribute.find('}'));
  name_ = attribute.substr(0, attribute.find_last_not_of(kBlanks) + 1);
}

}  // namespace quarry
