#include "pipeline/batch/ranks.hpp"

namespace quarry {

std::unique_ptr<Ranks> join_ranks() { return std::make_unique<Ranks>(); }

}  // namespace quarry
