// Outputs are looked at before a job starts: hours of work should not end at a folder that does not exist.
// What is asked for on the standard output arrives there, or is told to be lost.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quarry::cli {

// Throws Error(kOutput) for an output that cannot be written, and Error(kUsage) for one that is also an input
// or that is named twice. Empty names are passed over. No file is touched.
void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

// Writes to the standard output. Throws Error(kOutput) where not all of it arrives.
void write_standard_output(std::string_view text);

}  // namespace quarry::cli
