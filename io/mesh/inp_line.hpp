// Lines of an Abaqus input file: keywords with their parameters, and data separated by commas.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quarry {

// Without blanks at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);
// Names and keywords are the same in either case of letters.
[[nodiscard]] std::string upper_case(std::string_view text);

struct InpKeyword {
  std::string name;                                             // upper case, without the asterisk
  std::vector<std::pair<std::string, std::string>> parameters;  // upper-case name; value as written

  // The value of a parameter; "" for one without a value or that is not there.
  [[nodiscard]] std::string value(std::string_view parameter) const;
  [[nodiscard]] bool has(std::string_view parameter) const;
};

// line: "*ELEMENT, TYPE=CPS4, ELSET=rock".
[[nodiscard]] InpKeyword parse_keyword(std::string_view line);

// Goes through the fields of a data line.
class InpFields {
 public:
  explicit InpFields(std::string_view line) : rest_(trimmed(line)) {}
  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  // The next field without blanks; may be empty.
  std::string_view next() {
    const std::size_t comma = rest_.find(',');
    const std::string_view field = trimmed(rest_.substr(0, comma));
    rest_ = comma == std::string_view::npos ? rest_.substr(rest_.size()) : trimmed(rest_.substr(comma + 1));
    return field;
  }

 private:
  std::string_view rest_;
};

}  // namespace quarry
