// The option --mixed-quality, which `quarry mesh` and `quarry improve` share.
#pragma once

#include <optional>
#include <string>

#include "engine/base/error.hpp"
#include "kernels/cluster/low_quads.hpp"

namespace quarry::cli {

inline constexpr const char* kMixedQualityHelp =
    "with --elements mixed: quads with a smaller scaled Jacobian are cut in two where that helps; default "
    "0.3";

// The value given, or the default. Throws Error(kUsage) for one that has no meaning with these elements.
inline double mixed_quality_of(const std::string& elements, const std::optional<double>& given) {
  if (given && elements != "mixed") throw Error(ErrorKind::kUsage, "--mixed-quality needs --elements mixed");
  return given.value_or(LowQuadOptions().quality);
}

}  // namespace quarry::cli
