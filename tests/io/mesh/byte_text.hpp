// Values as the bytes of a binary file.
#pragma once

#include <algorithm>
#include <bit>
#include <string>
#include <type_traits>

namespace quarry {

class ByteText {
 public:
  explicit ByteText(std::endian order) : order_(order) {}

  template <class... Values>
  ByteText& add(Values... values) {
    (add_one(values), ...);
    return *this;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  template <class Value>
  void add_one(Value value) {
    static_assert(std::is_arithmetic_v<Value>);
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof(Value));
    if (order_ != std::endian::native) std::reverse(bytes.begin(), bytes.end());
    text_ += bytes;
  }

  std::endian order_;
  std::string text_;
};

}  // namespace quarry
