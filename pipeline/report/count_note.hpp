// What the user is told where the number of elements is not the one asked for.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "engine/mesh/mesh.hpp"

namespace quarry {

// None if the mesh has so many elements to within 5 %, or if no number was asked for. what: elements have
// to fit this, as a phrase.
[[nodiscard]] inline std::optional<std::string> count_note(std::optional<double> asked, const Mesh& mesh,
                                                           const char* what) {
  constexpr double kLeeway = 0.05;
  const auto made = static_cast<double>(mesh.count_alive_faces());
  if (!asked || std::abs(made - *asked) <= kLeeway * *asked) return {};
  return fmt::format("--count asks for {:.0f} elements, and there are {:.0f}: they have to fit {}", *asked,
                     made, what);
}

}  // namespace quarry
