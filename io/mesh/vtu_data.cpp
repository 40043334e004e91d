#include "io/mesh/vtu_data.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

#include <fmt/format.h>
#include <zlib.h>

#include "engine/base/error.hpp"

namespace quarry {
namespace {

constexpr std::array<std::int8_t, 256> make_base64_values() {
  std::array<std::int8_t, 256> values{};
  for (auto& value : values) value = -1;
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < kDigits.size(); ++i)
    values[static_cast<unsigned char>(kDigits[i])] = static_cast<std::int8_t>(i);
  return values;
}

// At most `count` bytes from the start of the text; fewer where it ends or breaks off.
std::string decode_base64(std::string_view text, std::size_t count) {
  static constexpr std::array<std::int8_t, 256> kValues = make_base64_values();
  std::string bytes;
  std::uint32_t bits = 0;
  int held = 0;
  for (std::size_t i = 0; i < text.size() && bytes.size() < count; ++i) {
    const std::int8_t value = kValues[static_cast<unsigned char>(text[i])];
    if (value < 0) break;
    bits = (bits << 6) | static_cast<std::uint32_t>(value);
    held += 6;
    if (held >= 8) {
      held -= 8;
      bytes += static_cast<char>((bits >> held) & 0xffU);
    }
  }
  return bytes;
}

// The first bytes of a stored block, and what follows them.
struct Split {
  std::string bytes;
  std::string_view rest;
};

Split take(std::string_view stored, std::size_t count, bool base64) {
  if (!base64) {
    const std::size_t taken = std::min(count, stored.size());
    return {std::string(stored.substr(0, taken)), stored.substr(taken)};
  }
  const std::size_t characters = std::min(stored.size(), (count / 3 + (count % 3 != 0 ? 1 : 0)) * 4);
  return {decode_base64(stored.substr(0, characters), count), stored.substr(characters)};
}

std::string_view without_space(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

// False where a value is not a whole number that an int64 holds.
template <class T, class Stored>
bool convert(Stored value, T& out) {
  if constexpr (std::is_floating_point_v<Stored> && std::is_integral_v<T>) {
    if (!(std::abs(value) < static_cast<Stored>(9e18)) || std::trunc(value) != value) return false;
  }
  out = static_cast<T>(value);
  return true;
}

template <class T, class Stored>
bool convert_all(std::string_view bytes, std::vector<T>& values) {
  values.resize(bytes.size() / sizeof(Stored));
  for (std::size_t i = 0; i < values.size(); ++i) {
    Stored value;
    std::memcpy(&value, bytes.data() + i * sizeof(Stored), sizeof(Stored));
    if (!convert<T>(value, values[i])) return false;
  }
  return bytes.size() % sizeof(Stored) == 0;
}

template <class T>
bool convert_bytes(std::string_view type, std::string_view bytes, std::vector<T>& values) {
  if (type == "Float64") return convert_all<T, double>(bytes, values);
  if (type == "Float32") return convert_all<T, float>(bytes, values);
  if (type == "Int64" || type == "UInt64") return convert_all<T, std::int64_t>(bytes, values);
  if (type == "Int32") return convert_all<T, std::int32_t>(bytes, values);
  if (type == "UInt32") return convert_all<T, std::uint32_t>(bytes, values);
  if (type == "Int16") return convert_all<T, std::int16_t>(bytes, values);
  if (type == "UInt16") return convert_all<T, std::uint16_t>(bytes, values);
  if (type == "Int8") return convert_all<T, std::int8_t>(bytes, values);
  if (type == "UInt8") return convert_all<T, std::uint8_t>(bytes, values);
  return false;
}

template <class T>
bool convert_text(std::string_view text, std::vector<T>& values) {
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    while (at != end && (*at == ' ' || *at == '\n' || *at == '\t' || *at == '\r')) ++at;
    if (at == end) return true;
    double value = 0;
    const auto result = std::from_chars(at, end, value);
    T converted;
    if (result.ec != std::errc() || !convert<T>(value, converted)) return false;
    values.push_back(converted);
    at = result.ptr;
  }
}

}  // namespace

VtuData::VtuData(std::string path, const XmlElement& root) : path_(std::move(path)) {
  const auto refuse = [&](std::string_view what) {
    throw Error(ErrorKind::kInput, fmt::format("{}: {}", path_, what));
  };
  const std::string_view header = root.attribute("header_type");
  if (header == "UInt64") header_bytes_ = 8;
  if (root.attribute("byte_order") == "BigEndian") refuse("big-endian data; save it as little-endian");
  const std::string_view compressor = root.attribute("compressor");
  compressed_ = !compressor.empty();
  if (compressed_ && compressor != "vtkZLibDataCompressor")
    refuse(fmt::format("compressor {} is not known; save it with zlib or without", compressor));
  if (const XmlElement* appended = root.child("AppendedData")) {
    appended_base64_ = appended->attribute("encoding") == "base64";
    const std::size_t begin = appended->text.find('_');
    if (begin == std::string_view::npos) refuse("appended data do not start with _");
    appended_ = appended->text.substr(begin + 1);
  }
}

void VtuData::fail(const XmlElement& array, const std::string& message) const {
  throw Error(ErrorKind::kInput,
              fmt::format("{}: array \"{}\": {}", path_, array.attribute("Name"), message));
}

std::uint64_t VtuData::header_word(std::string_view bytes, std::size_t index) const {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes.data() + index * header_bytes_, header_bytes_);
  return word;
}

void VtuData::inflate_block(const XmlElement& array, std::string_view packed, std::uint64_t expected,
                            std::string& bytes) const {
  // No deflate stream grows more than about a thousandfold: a larger claim is a broken file.
  if (expected > 1100 * (packed.size() + 1)) fail(array, "a compressed block of an impossible size");
  const std::size_t begin = bytes.size();
  uLongf grown = static_cast<uLongf>(expected);
  bytes.resize(begin + grown);
  if (uncompress(reinterpret_cast<Bytef*>(bytes.data() + begin), &grown,
                 reinterpret_cast<const Bytef*>(packed.data()), static_cast<uLong>(packed.size())) != Z_OK)
    fail(array, "a compressed block is broken");
  bytes.resize(begin + grown);
}

std::string VtuData::uncompressed(const XmlElement& array, std::string_view stored, bool base64) const {
  const std::string head = take(stored, header_bytes_, base64).bytes;
  if (head.size() < header_bytes_) fail(array, "the data end too early");
  const std::uint64_t blocks = header_word(head, 0);
  if (blocks > stored.size()) fail(array, "the data end too early");
  const Split table = take(stored, header_bytes_ * (3 + blocks), base64);
  if (table.bytes.size() < header_bytes_ * (3 + blocks)) fail(array, "the data end too early");
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < blocks; ++i) {
    const std::uint64_t size = header_word(table.bytes, 3 + i);
    if (size > stored.size()) fail(array, "the data end too early");
    total += size;
  }
  const std::string packed = take(table.rest, total, base64).bytes;
  if (packed.size() < total) fail(array, "the data end too early");
  std::string bytes;
  std::size_t at = 0;
  for (std::size_t i = 0; i < blocks; ++i) {
    const std::uint64_t size = header_word(table.bytes, 3 + i);
    const std::uint64_t last = header_word(table.bytes, 2);
    const std::uint64_t expected = i + 1 == blocks && last != 0 ? last : header_word(table.bytes, 1);
    inflate_block(array, std::string_view(packed).substr(at, size), expected, bytes);
    at += size;
  }
  return bytes;
}

std::string VtuData::stored_bytes(const XmlElement& array) const {
  const bool appended = array.attribute("format") == "appended";
  const bool base64 = !appended || appended_base64_;
  std::string_view stored = without_space(array.text);
  if (appended) {
    const std::string_view digits = array.attribute("offset");
    std::uint64_t offset = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), offset);
    if (result.ec != std::errc() || offset > appended_.size())
      fail(array, "its offset lies outside the data");
    stored = appended_.substr(offset);
  }
  if (compressed_) return uncompressed(array, stored, base64);
  const std::string head = take(stored, header_bytes_, base64).bytes;
  if (head.size() < header_bytes_) fail(array, "the data end too early");
  const std::uint64_t size = header_word(head, 0);
  if (size > stored.size()) fail(array, "the data end too early");
  std::string bytes = take(stored, header_bytes_ + size, base64).bytes;
  if (bytes.size() < header_bytes_ + size) fail(array, "the data end too early");
  bytes.erase(0, header_bytes_);
  return bytes;
}

template <class T>
std::vector<T> VtuData::read(const XmlElement& array) const {
  std::vector<T> values;
  const std::string_view type = array.attribute("type");
  const bool good = array.attribute("format") == "ascii"
                        ? convert_text<T>(array.text, values)
                        : convert_bytes<T>(type, stored_bytes(array), values);
  if (!good)
    fail(array,
         fmt::format("{} values of type {} cannot be read", std::is_integral_v<T> ? "whole" : "real", type));
  return values;
}

std::vector<double> VtuData::doubles(const XmlElement& array) const { return read<double>(array); }
std::vector<std::int64_t> VtuData::integers(const XmlElement& array) const {
  return read<std::int64_t>(array);
}

std::vector<std::string> VtuData::texts(const XmlElement& array) const {
  std::vector<std::string> texts(1);
  const auto add = [&](auto code) {
    if (code == 0)
      texts.emplace_back();
    else
      texts.back() += static_cast<char>(code);
  };
  if (array.attribute("format") == "ascii")
    for (const std::int64_t code : integers(array)) add(code);
  else
    for (const char code : stored_bytes(array)) add(code);
  texts.pop_back();
  return texts;
}

}  // namespace quarry
