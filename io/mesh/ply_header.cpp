#include "io/mesh/ply_header.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "io/text_cursor.hpp"

namespace quarry {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array kTypeNames = {
    TypeName{"char", PlyType::kInt8},     TypeName{"int8", PlyType::kInt8},
    TypeName{"uchar", PlyType::kUint8},   TypeName{"uint8", PlyType::kUint8},
    TypeName{"short", PlyType::kInt16},   TypeName{"int16", PlyType::kInt16},
    TypeName{"ushort", PlyType::kUint16}, TypeName{"uint16", PlyType::kUint16},
    TypeName{"int", PlyType::kInt32},     TypeName{"int32", PlyType::kInt32},
    TypeName{"uint", PlyType::kUint32},   TypeName{"uint32", PlyType::kUint32},
    TypeName{"float", PlyType::kFloat},   TypeName{"float32", PlyType::kFloat},
    TypeName{"double", PlyType::kDouble}, TypeName{"float64", PlyType::kDouble},
};

class HeaderReader {
 public:
  HeaderReader(const std::string& path, std::string_view text) : cursor_(path, text) {}

  PlyHeader read() {
    if (cursor_.word() != "ply") cursor_.fail("the file does not start with \"ply\"");
    end_line();
    for (;;) {
      const std::string_view key = cursor_.word();
      if (key == "end_header") break;
      if (key == "format")
        read_format();
      else if (key == "element")
        read_element();
      else if (key == "property")
        read_property();
      else if (key != "comment" && key != "obj_info")
        cursor_.fail(fmt::format("\"{}\" is no key of a PLY header", key.substr(0, 40)));
      if (key == "comment" || key == "obj_info")
        cursor_.line();
      else
        end_line();
    }
    if (!format_known_) cursor_.fail("the header has no format");
    end_line();
    header_.end = cursor_.position();
    return std::move(header_);
  }

 private:
  void end_line() {
    if (!cursor_.at_line_end())
      cursor_.fail(fmt::format("the line should end before \"{}\"", cursor_.word().substr(0, 40)));
    cursor_.line();
  }

  void read_format() {
    const std::string_view format = cursor_.word_in_line("a format");
    if (format == "binary_little_endian")
      header_.byte_order = std::endian::little;
    else if (format == "binary_big_endian")
      header_.byte_order = std::endian::big;
    else if (format != "ascii")
      cursor_.fail(
          fmt::format("ascii, binary_little_endian or binary_big_endian is expected, not \"{}\"", format));
    const std::string_view version = cursor_.word_in_line("a version");
    if (version != "1.0") cursor_.fail(fmt::format("version {} is not known, only 1.0", version));
    format_known_ = true;
  }

  void read_element() {
    PlyElement element;
    element.name = cursor_.word_in_line("the name of an element");
    const auto rows = cursor_.number_in_line<std::int64_t>("a number of rows");
    if (rows < 0) cursor_.fail(fmt::format("element {} has {} rows", element.name, rows));
    if (header_.find(element.name) != nullptr)
      cursor_.fail(fmt::format("element {} stands twice in the header", element.name));
    element.rows = static_cast<std::size_t>(rows);
    header_.elements.push_back(std::move(element));
  }

  void read_property() {
    if (header_.elements.empty()) cursor_.fail("a property stands before any element");
    PlyProperty property{};
    std::string_view type = cursor_.word_in_line("a type");
    if (type == "list") {
      property.length_type = type_of(cursor_.word_in_line("a type"));
      if (!is_whole(*property.length_type)) cursor_.fail("the length of a list is no whole number");
      type = cursor_.word_in_line("a type");
    }
    property.type = type_of(type);
    property.name = cursor_.word_in_line("the name of a property");
    std::vector<PlyProperty>& known = header_.elements.back().properties;
    if (std::any_of(known.begin(), known.end(),
                    [&](const PlyProperty& p) { return p.name == property.name; }))
      cursor_.fail(fmt::format("property {} stands twice in its element", property.name));
    known.push_back(std::move(property));
  }

  [[nodiscard]] PlyType type_of(std::string_view word) const {
    const auto found = std::find_if(kTypeNames.begin(), kTypeNames.end(),
                                    [&](const TypeName& known) { return known.name == word; });
    if (found == kTypeNames.end())
      cursor_.fail(fmt::format("\"{}\" is no type of a property", word.substr(0, 40)));
    return found->type;
  }

  TextCursor cursor_;
  PlyHeader header_;
  bool format_known_ = false;
};

}  // namespace

const PlyElement* PlyHeader::find(std::string_view name) const {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const PlyElement& element) { return element.name == name; });
  return found == elements.end() ? nullptr : &*found;
}

PlyHeader read_ply_header(const std::string& path, std::string_view text) {
  return HeaderReader(path, text).read();
}

}  // namespace quarry
