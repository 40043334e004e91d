// A check of options that are whole numbers.
#pragma once

#include <algorithm>
#include <string>

#include <CLI/CLI.hpp>
#include <cctype>
#include <fmt/format.h>

namespace quarry::cli {

// The parser alone takes "-1" for the largest unsigned number.
inline CLI::Validator whole_number() {
  const auto check = [](const std::string& text) -> std::string {
    const bool digits = !text.empty() && std::all_of(text.begin(), text.end(),
                                                     [](unsigned char c) { return std::isdigit(c) != 0; });
    return digits ? "" : fmt::format("{} is no whole number of 0 or more", text);
  };
  return {check, ""};
}

}  // namespace quarry::cli
