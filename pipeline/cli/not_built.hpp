// Commands and values whose place is kept, but which this release does not have: they end with exit code 2
// and one line, and never do something else.
#pragma once

#include <string_view>

namespace quarry::cli {

// what: as the user wrote it, "--method front". instead: what works today, or nothing.
[[noreturn]] void fail_not_built(std::string_view what, std::string_view instead = "");

}  // namespace quarry::cli
