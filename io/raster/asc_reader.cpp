#include "io/raster/asc_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "io/lower_case.hpp"
#include "io/mapped_file.hpp"
#include "io/text_cursor.hpp"

namespace quarry {
namespace {

enum Key : std::size_t { kColumns, kRows, kXCorner, kXCenter, kYCorner, kYCenter, kCell, kNoData, kKeys };

constexpr std::array<std::string_view, kKeys> kNames = {
    "ncols", "nrows", "xllcorner", "xllcenter", "yllcorner", "yllcenter", "cellsize", "nodata_value"};

std::optional<Key> key_of(std::string_view word) {
  const auto found = std::find(kNames.begin(), kNames.end(), lower_case(word));
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Key>(found - kNames.begin());
}

class AscReader {
 public:
  AscReader(const std::string& path, std::string_view text) : size_(text.size()), cursor_(path, text) {}

  Raster read() {
    const std::string_view first = read_header();
    shape();
    read_values(first);
    return std::move(raster_);
  }

 private:
  // Returns the word after it.
  std::string_view read_header() {
    for (;;) {
      const std::string_view word = cursor_.word();
      if (const std::string lower = lower_case(word); lower == "dx" || lower == "dy")
        cursor_.fail("its cells are not square: `gdalwarp -tr SIDE SIDE` makes them so");
      const std::optional<Key> key = key_of(word);
      if (!key) return word;
      if (header_[*key]) cursor_.fail(fmt::format("{} stands twice in the header", kNames[*key]));
      header_[*key] = cursor_.number<double>("a number");
    }
  }

  [[nodiscard]] double get(Key key) const {
    if (!header_[key]) cursor_.fail(fmt::format("{} is missing in the header", kNames[key]));
    if (!std::isfinite(*header_[key]))
      cursor_.fail(fmt::format("{} is {}: a finite number is expected", kNames[key], *header_[key]));
    return *header_[key];
  }

  [[nodiscard]] std::size_t count(Key key) const {
    const double number = get(key);
    // Each value takes two bytes at least, which also bounds what is asked of memory.
    if (number > static_cast<double>(size_)) too_short();
    if (!(number >= 1 && number == std::floor(number)))
      cursor_.fail(fmt::format("{} is {}: a whole number of 1 or more is expected", kNames[key], number));
    return static_cast<std::size_t>(number);
  }

  // Where the grid begins along one axis.
  [[nodiscard]] double low(Key corner, Key center) const {
    if (header_[corner] && header_[center])
      cursor_.fail(fmt::format("both {} and {} stand in the header", kNames[corner], kNames[center]));
    return header_[center] ? get(center) - 0.5 * raster_.cell : get(corner);
  }

  void shape() {
    raster_.columns = count(kColumns);
    raster_.rows = count(kRows);
    if (raster_.columns > size_ / raster_.rows) too_short();
    raster_.cell = get(kCell);
    if (!(raster_.cell > 0)) cursor_.fail(fmt::format("cellsize is {}: it must be above 0", raster_.cell));
    raster_.low = {low(kXCorner, kXCenter), low(kYCorner, kYCenter)};
  }

  void read_values(std::string_view word) {
    const std::size_t count = raster_.columns * raster_.rows;
    raster_.values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) {
        if (cursor_.at_end())
          cursor_.fail(fmt::format("the file ends at {} of {} values, before {}", i, count, place(i)));
        word = cursor_.word();
      }
      raster_.values.push_back(value(word, i));
    }
    if (!cursor_.at_end())
      cursor_.fail(
          fmt::format("there are more values than {} columns times {} rows", raster_.columns, raster_.rows));
  }

  [[nodiscard]] double value(std::string_view word, std::size_t i) {
    double number = 0;
    const auto [stop, failure] = std::from_chars(word.data(), word.data() + word.size(), number);
    const bool whole = failure == std::errc() && stop == word.data() + word.size();
    const bool no_data = header_[kNoData] && (number == *header_[kNoData] ||
                                              (std::isnan(number) && std::isnan(*header_[kNoData])));
    if (whole && no_data) return std::numeric_limits<double>::quiet_NaN();
    if (!whole || !std::isfinite(number))
      cursor_.fail(fmt::format("{}: a finite number is expected, not \"{}\"", place(i), word.substr(0, 40)));
    return number;
  }

  [[nodiscard]] std::string place(std::size_t i) const {
    return fmt::format("row {}, column {}", i / raster_.columns + 1, i % raster_.columns + 1);
  }

  [[noreturn]] void too_short() const {
    cursor_.fail("the file is too short for the columns and rows of its header");
  }

  std::size_t size_;
  TextCursor cursor_;
  std::array<std::optional<double>, kKeys> header_;
  Raster raster_;
};

}  // namespace

Raster read_asc(const std::string& path, const std::string& name) {
  const MappedFile file(path);
  return AscReader(name.empty() ? path : name, file.text()).read();
}

}  // namespace quarry
