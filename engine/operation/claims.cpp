#include "engine/operation/claims.hpp"

#include "engine/base/random.hpp"

namespace quarry {

std::uint32_t rank_of(std::uint32_t position, std::uint32_t round) {
  return mix32(position ^ mix32(round + 1));
}

}  // namespace quarry
