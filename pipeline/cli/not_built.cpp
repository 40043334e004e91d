#include "pipeline/cli/not_built.hpp"

#include <fmt/format.h>

#include "engine/base/error.hpp"

namespace quarry::cli {

void fail_not_built(std::string_view what, std::string_view instead) {
  throw Error(ErrorKind::kUsage,
              fmt::format("{} is not built yet{}{}", what, instead.empty() ? "" : "; ", instead));
}

}  // namespace quarry::cli
