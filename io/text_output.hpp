// Prints long lists of numbers: chunks are printed in parallel and written in order. Numbers are as short as
// they can be and read back to the same bits.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "engine/parallel/parallel.hpp"
#include "io/atomic_file.hpp"

namespace quarry {

class TextLine {
 public:
  explicit TextLine(std::string& text) : text_(text) {}

  TextLine& operator<<(std::string_view text) {
    text_ += text;
    return *this;
  }
  template <class Number>
    requires std::is_arithmetic_v<Number>
  TextLine& operator<<(Number value) {
    std::array<char, 32> digits{};
    const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text_.append(digits.data(), static_cast<std::size_t>(result.ptr - digits.data()));
    return *this;
  }
  // The bytes of a value, for formats whose lists are binary.
  template <class Value>
    requires std::is_arithmetic_v<Value>
  TextLine& bytes(Value value) {
    char copy[sizeof(Value)];
    std::memcpy(copy, &value, sizeof(Value));
    text_.append(copy, sizeof(Value));
    return *this;
  }

 private:
  std::string& text_;
};

// print(TextLine, index) for each index of [0, size), in order in the file.
template <class Print>
void write_lines(AtomicFile& file, std::size_t size, Print&& print) {
  constexpr std::size_t kLinesInChunk = 8192;
  constexpr std::size_t kChunksInBatch = 32;
  std::vector<std::string> texts(std::min(kChunksInBatch, size / kLinesInChunk + 1));
  for (std::size_t first = 0; first < size; first += kLinesInChunk * kChunksInBatch) {
    const std::size_t count = std::min(size - first, kLinesInChunk * kChunksInBatch);
    parallel::for_each_chunk(count, kLinesInChunk, [&](std::size_t begin, std::size_t end) {
      std::string& text = texts[begin / kLinesInChunk];
      text.clear();
      for (std::size_t i = begin; i < end; ++i) print(TextLine(text), first + i);
    });
    for (std::size_t i = 0; i * kLinesInChunk < count; ++i) file.write(texts[i]);
  }
}

}  // namespace quarry
