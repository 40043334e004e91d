// As much of XML as VTK's files need: a tree of elements with attributes and text that stays in the file.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quarry {

struct XmlElement {
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string_view>> attributes;
  std::string_view text;  // of an element without children
  std::vector<XmlElement> children;

  // The value, or an empty text.
  [[nodiscard]] std::string_view attribute(std::string_view key) const {
    for (const auto& [name_of, value] : attributes)
      if (name_of == key) return value;
    return {};
  }
  // The first child of that name, or null.
  [[nodiscard]] const XmlElement* child(std::string_view name_of) const {
    for (const XmlElement& element : children)
      if (element.name == name_of) return &element;
    return nullptr;
  }
};

// Parses up to the end, or up to the start tag of an element called `stop`, which becomes the last child of
// its parent, with everything behind it as its text: binary data that are no XML. Throws Error(kInput) with
// path and byte.
[[nodiscard]] XmlElement parse_xml(const std::string& path, std::string_view text, std::string_view stop);

}  // namespace quarry
