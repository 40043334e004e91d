// Where the prices of irregular vertices come from, as the user says it: "lines:DISTANCE:FACTOR", or the name
// of a raster.
#pragma once

#include <optional>
#include <string>

#include "engine/geometry/line_set.hpp"
#include "engine/geometry/raster.hpp"
#include "kernels/cleanup/irregular_price.hpp"

namespace quarry {

// The meaning of "lines:DISTANCE:FACTOR"; none for a text that does not begin with "lines:", which names a
// file. Throws Error(kUsage) for one that does but makes no sense.
[[nodiscard]] std::optional<LinePrice> parse_line_price(const std::string& text);

// The file that the text names; "" if it names none.
[[nodiscard]] std::string price_file(const std::string& text);

// The text for a list of options that tells no paths.
[[nodiscard]] std::string price_text(const std::string& text);

class PriceSource {
 public:
  // An empty text: all places cost the same. Reads the raster. Throws Error(kUsage) as above, and
  // Error(kInput) for a file that cannot be read or has a price that is not above 0, with its row and column.
  explicit PriceSource(const std::string& text);

  // The price by place. Lines are the pieces inside the domain; where the raster has no value it is 1.
  [[nodiscard]] IrregularPrice price(const NodedLines& lines) const;

 private:
  std::optional<LinePrice> near_lines_;
  std::optional<Raster> raster_;
};

}  // namespace quarry
