#include "pipeline/section/boundary_rule.hpp"

#include <string_view>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/number_text.hpp"

namespace quarry {

BoundaryRule parse_boundary(const std::string& text) {
  constexpr std::string_view kBoxWithMargin = "box:";
  if (text.empty()) return {};
  if (text == "hull") return {BoundaryRule::Kind::kHull};
  if (text == "box") return {BoundaryRule::Kind::kBox};
  if (!text.starts_with(kBoxWithMargin)) return {BoundaryRule::Kind::kFile};
  std::string_view number = std::string_view(text).substr(kBoxWithMargin.size());
  BoundaryRule rule{BoundaryRule::Kind::kBox};
  rule.margin_is_share = number.ends_with('%');
  if (rule.margin_is_share) number.remove_suffix(1);
  const auto margin = parse_finite(number);
  if (!margin || *margin < 0)
    throw Error(ErrorKind::kUsage,
                fmt::format("--boundary {}: give the margin of the box as a length, box:50, or as a share of "
                            "its longer side, box:5%",
                            text));
  rule.margin = rule.margin_is_share ? *margin / 100 : *margin;
  return rule;
}

}  // namespace quarry
