// The properties of features that travel with their lines and points: name, set, aperture and material, in
// either case of letters. The layer of a drawing (DXF, QGIS) is the set of what has none. All others stay
// behind.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "engine/geometry/line_set.hpp"

namespace quarry {

// Collects them for one feature after the other of a file.
class AttributeCollector {
 public:
  // Takes a property if it is one of these; "" says nothing. A text that is no UTF-8 is taken for
  // Windows-1252, in which most files are that do not say.
  void set(std::string_view key, std::string_view value);
  void set(std::string_view key, double value);

  [[nodiscard]] static bool knows(std::string_view key);

  // Gives what was set to the lines and points from `first` on, and forgets it.
  void assign(const LineSetMark& first, LineSet& lines);

  // Warns once if there were apertures that are no number of 0 or more, which are left out, and once of texts
  // whose encoding was guessed.
  void tell(const std::string& file) const;

 private:
  LineAttributes current_;
  std::string layer_;
  std::size_t unreadable_ = 0;
  bool guessed_ = false;
};

}  // namespace quarry
