// Element sets and surfaces of an Abaqus input file, resolved to elements once all are read.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace quarry {

class InpSets {
 public:
  struct Range {
    std::int64_t first, last, step;
  };

  // Opens a set, or goes on with one of that name. internal: made by a program, for its own use.
  void open(const std::string& name, bool internal);
  // To the open set.
  void add(Range range) { open_set().ranges.push_back(range); }
  void add_set(std::string_view name) { open_set().sets.emplace_back(name); }

  [[nodiscard]] std::size_t size() const { return sets_.size(); }
  [[nodiscard]] const std::string& name(std::size_t set) const { return sets_[set].name; }
  [[nodiscard]] bool internal(std::size_t set) const { return sets_[set].internal; }
  // The set of a name, or size() if there is none.
  [[nodiscard]] std::size_t find(std::string_view name) const;

  // Calls visit(number) for each element number of a set and of the sets within it; a set is entered once.
  void for_each(std::size_t set, const std::function<void(std::int64_t)>& visit) const;

 private:
  struct Set {
    std::string name;  // as written first
    bool internal = false;
    std::vector<Range> ranges;
    std::vector<std::string> sets;
  };
  [[nodiscard]] Set& open_set() { return sets_[open_]; }

  std::vector<Set> sets_;
  std::map<std::string, std::size_t, std::less<>> by_name_;  // upper case
  std::size_t open_ = 0;
};

}  // namespace quarry
