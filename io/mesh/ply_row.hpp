// One row of an element of a .ply file, as text or as bytes: both are read property by property, in order, by
// the same code.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>

#include "io/mesh/counted_face.hpp"
#include "io/mesh/ply_header.hpp"
#include "io/text_cursor.hpp"

namespace quarry {

class PlyTextRow {
 public:
  explicit PlyTextRow(TextCursor& cursor) : cursor_(cursor) {}

  void skip(const PlyProperty& property) {
    if (!property.length_type) {
      cursor_.word_in_line(property.name.c_str());
      return;
    }
    const auto length = cursor_.number_in_line<std::int64_t>("the length of a list");
    if (length < 0) cursor_.fail("the length of a list is negative");
    for (std::int64_t i = 0; i < length; ++i) cursor_.word_in_line(property.name.c_str());
  }
  double coordinate(const PlyProperty&) { return cursor_.coordinate(); }
  std::int64_t whole(const PlyProperty& property) {
    return cursor_.number_in_line<std::int64_t>(property.name.c_str());
  }
  FaceCorners face(const PlyProperty&, std::size_t points) { return read_counted_face(cursor_, points); }
  [[noreturn]] void fail(const std::string& message) const { cursor_.fail(message); }

 private:
  TextCursor& cursor_;
};

// A place in a binary body, with who tells its errors.
class PlyBytes {
 public:
  PlyBytes(const std::string& path, std::string_view text, std::endian order)
      : path_(path), text_(text), swap_(order != std::endian::native) {}

  [[nodiscard]] std::string_view text() const { return text_; }
  template <class Value>
  [[nodiscard]] Value load(std::size_t at) const {
    char bytes[sizeof(Value)];
    std::memcpy(bytes, text_.data() + at, sizeof(Value));
    if (swap_) std::reverse(bytes, bytes + sizeof(Value));
    Value value;
    std::memcpy(&value, bytes, sizeof(Value));
    return value;
  }
  // A value as a number of the given sort, which must hold it.
  template <class Number>
  [[nodiscard]] Number number(std::size_t at, PlyType type) const {
    switch (type) {
      case PlyType::kInt8:
        return static_cast<Number>(load<std::int8_t>(at));
      case PlyType::kUint8:
        return static_cast<Number>(load<std::uint8_t>(at));
      case PlyType::kInt16:
        return static_cast<Number>(load<std::int16_t>(at));
      case PlyType::kUint16:
        return static_cast<Number>(load<std::uint16_t>(at));
      case PlyType::kInt32:
        return static_cast<Number>(load<std::int32_t>(at));
      case PlyType::kUint32:
        return static_cast<Number>(load<std::uint32_t>(at));
      case PlyType::kFloat:
        return static_cast<Number>(load<float>(at));
      case PlyType::kDouble:
        break;
    }
    return static_cast<Number>(load<double>(at));
  }
  // Throws Error(kInput): "path: byte at: message".
  [[noreturn]] void fail(std::size_t at, const std::string& message) const;

 private:
  const std::string& path_;
  std::string_view text_;
  bool swap_;
};

// Rows, one after the other, whose bytes are known to be there.
class PlyBinaryRows {
 public:
  PlyBinaryRows(const PlyBytes& bytes, std::size_t at) : bytes_(bytes), at_(at) {}

  void skip(const PlyProperty& property) {
    if (property.length_type) {
      const auto length = bytes_.number<std::size_t>(at_, *property.length_type);
      at_ += size_of(*property.length_type) + length * size_of(property.type);
    } else {
      at_ += size_of(property.type);
    }
  }
  double coordinate(const PlyProperty& property) {
    const auto value = bytes_.number<double>(at_, property.type);
    if (!std::isfinite(value)) fail("a coordinate is not a finite number");
    at_ += size_of(property.type);
    return value;
  }
  std::int64_t whole(const PlyProperty& property) {
    const auto value = bytes_.number<std::int64_t>(at_, property.type);
    at_ += size_of(property.type);
    return value;
  }
  FaceCorners face(const PlyProperty& property, std::size_t points) {
    const auto count = bytes_.number<std::int64_t>(at_, *property.length_type);
    if (count != 3 && count != 4) fail(wrong_corner_count(count));
    at_ += size_of(*property.length_type);
    FaceCorners corners;
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
      const auto number = bytes_.number<std::int64_t>(at_, property.type);
      if (number < 0 || static_cast<std::size_t>(number) >= points) fail(missing_point(number, points));
      corners[k] = VertexId(static_cast<std::size_t>(number));
      at_ += size_of(property.type);
    }
    return corners;
  }
  [[noreturn]] void fail(const std::string& message) const { bytes_.fail(at_, message); }

 private:
  const PlyBytes& bytes_;
  std::size_t at_;
};

// Where the rows of one element lie in a binary body. They are read in parts of so many rows.
class PlyLayout {
 public:
  static constexpr std::size_t kRowsInPart = 16384;

  // Throws Error(kInput) where the file ends before the last row does.
  PlyLayout(const PlyBytes& bytes, const PlyElement& element, std::size_t begin);

  [[nodiscard]] std::size_t parts() const { return begins_.size(); }
  // Where the first row of a part begins.
  [[nodiscard]] std::size_t begin_of(std::size_t part) const { return begins_[part]; }
  [[nodiscard]] std::size_t end() const { return end_; }

 private:
  // Values of constant size, then a list.
  struct Step {
    std::size_t constant = 0;
    PlyType length_type = PlyType::kUint8;
    std::size_t value_size = 0;  // 0: no list follows
  };
  // Sets steps_ and shortest_.
  void take_steps(const PlyElement& element);
  [[nodiscard]] std::size_t end_of_row(const PlyBytes& bytes, std::size_t at) const;

  std::vector<Step> steps_;
  std::size_t shortest_ = 0;  // bytes of a row whose lists are empty
  std::vector<std::size_t> begins_;
  std::size_t end_ = 0;
};

}  // namespace quarry
