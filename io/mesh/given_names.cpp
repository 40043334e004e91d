#include "io/mesh/given_names.hpp"

#include <utility>

#include <cctype>
#include <fmt/format.h>

#include "io/lower_case.hpp"
#include "io/mesh/group_name.hpp"

namespace quarry {
namespace {

std::map<std::int32_t, std::string> add_all(GivenNames& names,
                                            const std::map<std::int32_t, std::string>& given) {
  std::map<std::int32_t, std::string> added;
  for (const auto& [number, name] : given) added.emplace(number, names.add(name));
  return added;
}

// Without what would end it.
std::string quoted(std::string name) {
  for (char& c : name) {
    if (c == '"') c = '\'';
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = ' ';
  }
  return name;
}

}  // namespace

std::string GivenNames::add(std::string name) {
  name = form_ == NameForm::kWord ? word_of(std::move(name)) : quoted(std::move(name));
  const auto take = [&](const std::string& tried) {
    const std::string key = form_ == NameForm::kWord ? lower_case(tried) : tried;
    return !is_own_name(key) && taken_.insert(key).second;
  };
  if (take(name)) return name;
  for (int k = 2;; ++k)
    if (std::string tried = fmt::format("{}_{}", name, k); take(tried)) return tried;
}

FileNames::FileNames(const GroupNames& given, NameForm form) : lines_(form), regions_(form) {
  numbered_.lines = add_all(lines_, given.lines);
  GivenNames points = form == NameForm::kWord ? lines_ : GivenNames(form);
  numbered_.points = add_all(points, given.points);
  if (form == NameForm::kWord) regions_ = lines_;
  numbered_.regions = add_all(regions_, given.regions);
}

}  // namespace quarry
