// How the jobs that draw models refuse an option.
#pragma once

#include <string>
#include <utility>

#include "engine/base/error.hpp"

namespace quarry {

[[noreturn]] inline void refuse_option(std::string message) {
  throw Error(ErrorKind::kUsage, std::move(message));
}

}  // namespace quarry
