// ASCII text in small letters: for extensions, keywords and keys that files write in either case.
#pragma once

#include <string>
#include <string_view>

namespace quarry {

[[nodiscard]] inline std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

}  // namespace quarry
