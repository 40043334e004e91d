#include "io/mesh/inp_sets.hpp"

#include "io/mesh/inp_line.hpp"

namespace quarry {

void InpSets::open(const std::string& name, bool internal) {
  const auto [at, fresh] = by_name_.try_emplace(upper_case(name), sets_.size());
  if (fresh) sets_.push_back({name, internal, {}, {}});
  open_ = at->second;
}

std::size_t InpSets::find(std::string_view name) const {
  const auto at = by_name_.find(upper_case(name));
  return at == by_name_.end() ? sets_.size() : at->second;
}

void InpSets::for_each(std::size_t set, const std::function<void(std::int64_t)>& visit) const {
  std::vector<bool> entered(sets_.size(), false);
  std::vector<std::size_t> todo{set};
  while (!todo.empty()) {
    const std::size_t current = todo.back();
    todo.pop_back();
    if (current >= sets_.size() || entered[current]) continue;
    entered[current] = true;
    for (const Range& range : sets_[current].ranges)
      for (std::int64_t number = range.first; number <= range.last; number += range.step) visit(number);
    for (const std::string& name : sets_[current].sets) todo.push_back(find(name));
  }
}

}  // namespace quarry
