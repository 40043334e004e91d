// A file of lines as its reader gets it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/geometry/line_set.hpp"

namespace quarry {

struct LineSource {
  std::string name;        // for messages: the path, or what the bytes come from
  std::string_view text;   // all bytes, without a byte order mark
  std::uint32_t file = 0;  // index into LineSet::files

  // Throws Error(kInput): "name:row: message". Rows count from 1.
  [[noreturn]] void fail_at(std::size_t row, const std::string& message) const;
};

// Appends a line that was collected from the rows of a text. Throws as LineSource::fail_at for a line of one
// point; rows name the place.
void append_line(const LineSource& source, std::size_t row, InputLine line, LineSet& lines);

}  // namespace quarry
