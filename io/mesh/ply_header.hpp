// The header of a .ply file: which elements follow, and what each row of them holds.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quarry {

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

[[nodiscard]] constexpr std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kInt32:
    case PlyType::kUint32:
    case PlyType::kFloat:
      return 4;
    case PlyType::kDouble:
      break;
  }
  return 8;
}
[[nodiscard]] constexpr bool is_whole(PlyType type) {
  return type != PlyType::kFloat && type != PlyType::kDouble;
}

struct PlyProperty {
  std::string name;
  PlyType type;                        // of the value, or of each value of a list
  std::optional<PlyType> length_type;  // of a list
};

struct PlyElement {
  std::string name;
  std::size_t rows = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  std::optional<std::endian> byte_order;  // of the body; nothing: it is text
  std::vector<PlyElement> elements;       // in the order of the body
  std::size_t end = 0;                    // where the body begins

  // The element of a name, or nullptr.
  [[nodiscard]] const PlyElement* find(std::string_view name) const;
};

// Throws Error(kInput) with file and line.
[[nodiscard]] PlyHeader read_ply_header(const std::string& path, std::string_view text);

}  // namespace quarry
