#include "io/text_parts.hpp"

namespace quarry {
namespace {

constexpr std::size_t kPartBytes = std::size_t{1} << 18;

// The begin of the first line after `from` that may start a part, or the end of the text.
std::size_t next_start(std::string_view text, std::size_t from, std::string_view starts) {
  for (std::size_t at = from; at < text.size();) {
    at = text.find('\n', at);
    if (at == std::string_view::npos) break;
    ++at;
    const std::size_t word = text.find_first_not_of(" \t\r", at);
    if (starts.empty() || (word < text.size() && starts.find(text[word]) != std::string_view::npos))
      return at;
  }
  return text.size();
}

}  // namespace

std::vector<TextPart> split_lines(std::string_view text, std::size_t begin, std::string_view starts) {
  std::vector<TextPart> parts;
  while (begin < text.size()) {
    const std::size_t end =
        text.size() - begin <= kPartBytes ? text.size() : next_start(text, begin + kPartBytes - 1, starts);
    parts.push_back({begin, end});
    begin = end;
  }
  return parts;
}

}  // namespace quarry
