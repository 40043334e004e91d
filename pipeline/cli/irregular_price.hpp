// The option --irregular-price, which `quarry mesh` and `quarry improve` share.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "engine/base/error.hpp"
#include "kernels/cleanup/clean_up.hpp"
#include "pipeline/section/price_source.hpp"

namespace quarry::cli {

inline void add_irregular_price(CLI::App& command, std::string& text) {
  command
      .add_option(
          "--irregular-price", text,
          "how dear irregular vertices are to the clean-up: FACTOR times as dear up to DISTANCE from a "
          "line, smoothly down to the usual price at twice that; or an ESRI ASCII raster (.asc) of "
          "prices, 1 where it has no value")
      ->type_name("lines:DISTANCE:FACTOR|FILE")
      ->group("Elements");
}

// Throws Error(kUsage) for a price that makes no sense, or that this clean-up never looks at.
inline void check_irregular_price(const std::string& text, CleanUpLevel level) {
  (void)parse_line_price(text);
  if (!text.empty() && level == CleanUpLevel::kNone)
    throw Error(ErrorKind::kUsage,
                "--irregular-price needs quadrilaterals and clean-up: it guides nothing else");
}

}  // namespace quarry::cli
