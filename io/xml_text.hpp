// Text as it stands in XML, and in HTML.
#pragma once

#include <string>
#include <string_view>

namespace quarry {

// With the five characters that XML keeps for itself written as entities.
[[nodiscard]] inline std::string escape_xml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else if (c == '\'')
      escaped += "&apos;";
    else
      escaped += c;
  }
  return escaped;
}

}  // namespace quarry
