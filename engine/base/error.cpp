#include "engine/base/error.hpp"

#include <fmt/format.h>

namespace quarry {

std::string format_point(double x, double y) { return fmt::format("({:.10g}, {:.10g})", x, y); }

}  // namespace quarry
