// Ctrl-C and SIGTERM: the job is asked to end, and ends with exit code 130 at its next look, with nothing
// half-written.
#pragma once

#include "engine/base/progress.hpp"

namespace quarry::cli {

// From here on SIGINT, SIGTERM and SIGHUP cancel interrupt_token().
void catch_interrupts();

[[nodiscard]] const CancellationToken& interrupt_token();

}  // namespace quarry::cli
