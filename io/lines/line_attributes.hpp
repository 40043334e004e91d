// The properties of features that travel with their lines: name, set, aperture and material, in either case
// of letters. All others stay behind.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "engine/geometry/line_set.hpp"

namespace quarry {

// Collects them for one feature after the other of a file.
class AttributeCollector {
 public:
  // Takes a property if it is one of the four; "" says nothing.
  void set(std::string_view key, std::string_view value);
  void set(std::string_view key, double value);

  [[nodiscard]] static bool knows(std::string_view key);

  // Gives what was set to the lines from `first` on, and forgets it.
  void assign(std::size_t first, LineSet& lines);

  // Warns once if there were apertures that are no number of 0 or more; they are left out.
  void tell(const std::string& file) const;

 private:
  LineAttributes current_;
  std::size_t unreadable_ = 0;
};

}  // namespace quarry
