// Texts of files that are not UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace quarry {

[[nodiscard]] bool is_utf8(std::string_view text);

// The name under which the system knows an encoding that a file names: "UTF-8", "1252", "ANSI 1252", "88591",
// or the "LDID/n" of a dBASE file; "" if that says nothing.
[[nodiscard]] std::string encoding_name(std::string_view named);

// The text in UTF-8. Bytes that the encoding does not know, and all beyond ASCII where the system does not
// know the encoding, become "?".
[[nodiscard]] std::string to_utf8(std::string_view text, const std::string& encoding);

}  // namespace quarry
