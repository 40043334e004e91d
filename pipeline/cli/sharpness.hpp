// The option --sharp, which `quarry mesh` and `quarry improve` share.
#pragma once

#include <optional>
#include <string>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/number_text.hpp"

namespace quarry::cli {

// Degrees, or none for "auto". Throws Error(kUsage) for anything else.
inline std::optional<double> sharpness_of(const std::string& text) {
  if (text == "auto") return std::nullopt;
  const std::optional<double> degrees = parse_finite(text);
  if (!degrees || !(*degrees > 0 && *degrees <= 180))
    throw Error(ErrorKind::kUsage,
                fmt::format("--sharp {}: give auto, or degrees above 0 and up to 180", text));
  return degrees;
}

}  // namespace quarry::cli
