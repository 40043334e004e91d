#include "io/lines/text_encoding.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

#include <cctype>
#include <fmt/format.h>
#include <iconv.h>

#include "io/lower_case.hpp"

namespace quarry {
namespace {

struct LanguageDriver {
  int number;
  std::string_view encoding;
};

// The drivers that tables of our times have (dBASE, FoxPro and ESRI's 87 and 88).
constexpr std::array kDrivers{
    LanguageDriver{1, "CP437"},    LanguageDriver{2, "CP850"},    LanguageDriver{3, "CP1252"},
    LanguageDriver{19, "CP932"},   LanguageDriver{77, "CP936"},   LanguageDriver{78, "CP949"},
    LanguageDriver{79, "CP950"},   LanguageDriver{87, "CP1252"},  LanguageDriver{88, "CP1252"},
    LanguageDriver{89, "CP1252"},  LanguageDriver{100, "CP852"},  LanguageDriver{101, "CP866"},
    LanguageDriver{102, "CP865"},  LanguageDriver{106, "CP737"},  LanguageDriver{107, "CP857"},
    LanguageDriver{123, "CP932"},  LanguageDriver{200, "CP1250"}, LanguageDriver{201, "CP1251"},
    LanguageDriver{202, "CP1254"}, LanguageDriver{203, "CP1253"}, LanguageDriver{204, "CP1257"}};

class Converter {
 public:
  explicit Converter(const std::string& encoding) : handle_(iconv_open("UTF-8", encoding.c_str())) {}
  ~Converter() {
    if (known()) iconv_close(handle_);
  }
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;

  // iconv_open's failure is the pointer -1.
  [[nodiscard]] bool known() const { return handle_ != iconv_t(-1); }  // NOLINT
  // Moves past what could be converted.
  void convert(char*& in, std::size_t& in_left, std::string& out) const {
    std::array<char, 256> block;
    char* at = block.data();
    std::size_t left = block.size();
    iconv(handle_, &in, &in_left, &at, &left);
    out.append(block.data(), block.size() - left);
  }

 private:
  iconv_t handle_;
};

}  // namespace

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t more = lead < 0x80                   ? 0
                             : lead >= 0xC2 && lead < 0xE0 ? 1
                             : (lead & 0xF0U) == 0xE0      ? 2
                                                           : 3;
    if (lead >= 0x80 && (lead < 0xC2 || lead > 0xF4)) return false;
    if (text.size() - i <= more) return false;
    for (std::size_t k = 1; k <= more; ++k)
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0U) != 0x80) return false;
    i += more + 1;
  }
  return true;
}

std::string encoding_name(std::string_view named) {
  std::string name;
  for (const char c : lower_case(named))
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '/') name += c;
  const auto number_after = [&](std::size_t begin) {
    int number = 0;
    for (std::size_t i = begin; i < name.size() && i < begin + 6; ++i)
      number = std::isdigit(static_cast<unsigned char>(name[i])) != 0 ? 10 * number + (name[i] - '0') : -1;
    return number;
  };
  if (name.starts_with("ldid/")) {
    const auto driver = std::ranges::find(kDrivers, number_after(5), &LanguageDriver::number);
    return driver == kDrivers.end() ? "" : std::string(driver->encoding);
  }
  for (const std::string_view prefix : {"ansi", "cp", "windows", "iso", "oem"})
    if (name.starts_with(prefix) && name.size() > prefix.size()) name.erase(0, prefix.size());
  if (name == "utf8" || name == "65001") return "UTF-8";
  if (name.starts_with("8859") && name.size() > 4) return fmt::format("ISO-8859-{}", name.substr(4));
  if (!name.empty() && std::ranges::all_of(name, [](unsigned char c) { return std::isdigit(c) != 0; }))
    return fmt::format("CP{}", name);
  return name == "system" ? "" : std::string(named);
}

std::string to_utf8(std::string_view text, const std::string& encoding) {
  std::string source(text);
  char* in = source.data();
  std::size_t left = source.size();
  std::string out;
  const Converter converter(encoding);
  while (left > 0) {
    const std::size_t before = left;
    if (converter.known()) converter.convert(in, left, out);
    if (left < before) continue;
    out += static_cast<unsigned char>(*in) < 0x80 ? *in : '?';
    ++in;
    --left;
  }
  return out;
}

}  // namespace quarry
