// A side of a face: the directed edge from corner `index` to the next corner. The number is face * 4 + index,
// so that face and index are a shift and a mask, and the side on the other face of an edge needs no search.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>

#include "engine/base/id.hpp"

namespace quarry {

class SideId {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  constexpr SideId() = default;
  constexpr explicit SideId(std::uint32_t value) : value_(value) {}
  constexpr SideId(FaceId face, int index) : value_(face.value() * 4 + static_cast<std::uint32_t>(index)) {}

  [[nodiscard]] constexpr std::uint32_t value() const { return value_; }
  [[nodiscard]] constexpr bool valid() const { return value_ != kNone; }
  [[nodiscard]] constexpr FaceId face() const { return FaceId(value_ >> 2); }
  [[nodiscard]] constexpr int index() const { return static_cast<int>(value_ & 3U); }
  friend constexpr auto operator<=>(SideId, SideId) = default;

 private:
  std::uint32_t value_ = kNone;
};

}  // namespace quarry
