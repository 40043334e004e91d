#include "io/mesh/inp_line.hpp"

#include <algorithm>

#include <cctype>

namespace quarry {

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string upper_case(std::string_view text) {
  std::string upper(text);
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return upper;
}

std::string InpKeyword::value(std::string_view parameter) const {
  for (const auto& [name_of, value_of] : parameters)
    if (name_of == parameter) return value_of;
  return {};
}

bool InpKeyword::has(std::string_view parameter) const {
  return std::any_of(parameters.begin(), parameters.end(),
                     [&](const auto& p) { return p.first == parameter; });
}

InpKeyword parse_keyword(std::string_view line) {
  InpFields fields(line.substr(1));
  InpKeyword keyword;
  // Blanks within a keyword count once: "*SOLID  SECTION".
  for (const char c : upper_case(fields.next()))
    if (c != ' ' || keyword.name.empty() || keyword.name.back() != ' ') keyword.name += c;
  while (!fields.at_end()) {
    const std::string_view field = fields.next();
    const std::size_t equals = field.find('=');
    std::string_view value = equals == std::string_view::npos ? "" : trimmed(field.substr(equals + 1));
    if (value.size() >= 2 && value.front() == '"' && value.back() == '"')
      value = value.substr(1, value.size() - 2);
    if (!field.empty()) keyword.parameters.emplace_back(upper_case(trimmed(field.substr(0, equals))), value);
  }
  return keyword;
}

}  // namespace quarry
