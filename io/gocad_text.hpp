// The syntax that the objects of GOCAD files have in common: "GOCAD sort", lines of a key and values, "END".
#pragma once

#include <string>
#include <string_view>

#include "io/text_cursor.hpp"

namespace quarry {

class GocadText {
 public:
  GocadText(std::string path, std::string_view text) : cursor_(std::move(path), text) {}

  // Moves into the next object; false if there is none. Throws Error(kInput) for what is no object.
  [[nodiscard]] bool next_object();
  // The sort of the object: "TSurf", "PLine", ...
  [[nodiscard]] std::string_view sort() const { return sort_; }

  // Takes the first word of the object's next line that is no comment; false if it ends the object. The end
  // of the file may not come before that.
  [[nodiscard]] bool next_line();
  // That word.
  [[nodiscard]] std::string_view key() const { return key_; }

  // Passes over what is left of the object.
  void pass_object() {
    while (next_line()) cursor_.line();
  }

  // A line that is no geometry, with the block between braces that it may begin: takes the name from HEADER
  // and the direction of heights from ZPOSITIVE. Throws Error(kInput) for what is no key.
  void read_attributes();

  // Of the object, as far as it is read: "" if it has none.
  [[nodiscard]] std::string_view name() const { return name_; }
  // Heights are depths.
  [[nodiscard]] bool depth() const { return depth_; }

  [[nodiscard]] TextCursor& cursor() { return cursor_; }

 private:
  void read_name(std::string_view attribute);
  void read_direction();

  TextCursor cursor_;
  std::string_view sort_;
  std::string_view key_;
  std::string_view name_;
  bool depth_ = false;
};

}  // namespace quarry
