// A hash of what a job read, so that its output tells whether the input is the same.
#pragma once

#include <string>
#include <vector>

namespace quarry {

// FNV-1a (64 bits, hexadecimal) of the bytes of the files in order; each is preceded by its length in 8
// bytes, lowest first. Throws Error(kInput) for one that cannot be read.
[[nodiscard]] std::string hash_files(const std::vector<std::string>& paths);

}  // namespace quarry
