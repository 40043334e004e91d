#include "pipeline/generate/model.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "io/lines/feature_writer.hpp"
#include "pipeline/generate/refuse.hpp"

namespace quarry {
namespace {

const char* name_of(LineLabel::Kind kind) {
  switch (kind) {
    case LineLabel::Kind::kOutline:
      return "outline";
    case LineLabel::Kind::kFracture:
      return "fracture";
    case LineLabel::Kind::kHorizon:
      return "horizon";
    default:
      return "fault";
  }
}

// One side of the box: the inside has coordinate (x or y) * sign >= bound * sign.
struct Side {
  double Vec2::*coordinate;
  double bound;
  double sign;
};

// The part of a segment in the box (Liang & Barsky 1984), with ends on a side put there exactly.
std::optional<std::pair<Vec2, Vec2>> clip(Vec2 a, Vec2 b, const Box2& box) {
  const Side sides[] = {{&Vec2::x, box.low.x, 1},
                        {&Vec2::x, box.high.x, -1},
                        {&Vec2::y, box.low.y, 1},
                        {&Vec2::y, box.high.y, -1}};
  double begin = 0, end = 1;
  const Side *enters = nullptr, *leaves = nullptr;
  for (const Side& side : sides) {
    const double from = side.sign * (a.*side.coordinate - side.bound);
    const double to = side.sign * (b.*side.coordinate - side.bound);
    if (from < 0 && to < 0) return std::nullopt;
    if (from >= 0 && to >= 0) continue;
    const double share = from / (from - to);
    if (from < 0 && share > begin) {
      begin = share;
      enters = &side;
    }
    if (to < 0 && share < end) {
      end = share;
      leaves = &side;
    }
  }
  if (begin > end) return std::nullopt;
  const auto at = [&](double share, const Side* side) {
    Vec2 p = a + share * (b - a);
    if (side != nullptr) p.*side->coordinate = side->bound;
    return p;
  };
  return std::pair(enters == nullptr ? a : at(begin, enters), leaves == nullptr ? b : at(end, leaves));
}

}  // namespace

void require_box(const Box2& box) {
  const bool good = std::isfinite(box.low.x) && std::isfinite(box.low.y) && std::isfinite(box.high.x) &&
                    std::isfinite(box.high.y) && box.width() > 0 && box.height() > 0;
  if (!good)
    refuse_option(
        "--box, --origin: finite numbers, and sides above 0 that are large enough to be seen there");
}

void write_model(const std::string& path, const GeneratedModel& model) {
  write_features_geojson(path, model.lines, [&](LineId line) {
    const LineLabel& label = model.labels[line.value()];
    std::string text = fmt::format("\"kind\":\"{}\"", name_of(label.kind));
    if (label.kind != LineLabel::Kind::kOutline) text += fmt::format(",\"number\":{}", label.number);
    if (label.kind == LineLabel::Kind::kFracture) text += fmt::format(",\"set\":{}", label.set);
    return text;
  });
}

ModelFrame::ModelFrame(const Box2& box, double coarsest_step) : box_(box) {
  // Powers of ten up to 10^22 are doubles.
  for (int k = 0; k < 22 && 1 / steps_in_unit_ > coarsest_step; ++k) steps_in_unit_ *= 10;
}

// The quotient of two whole numbers below 2^53 is the double that is nearest to the decimal number. The box
// need not lie on the grid: what is on its sides stays there.
Vec2 ModelFrame::rounded(Vec2 point) const {
  const auto round = [&](double value, double low, double high) {
    if (value == low || value == high) return value;
    return std::clamp(std::round(value * steps_in_unit_) / steps_in_unit_, low, high);
  };
  return {round(point.x, box_.low.x, box_.high.x), round(point.y, box_.low.y, box_.high.y)};
}

void ModelFrame::finish(std::vector<Vec2>& part, LineLabel label, double& length,
                        GeneratedModel& model) const {
  if (part.size() >= 2) {
    for (std::size_t i = 1; i < part.size(); ++i) length += distance(part[i - 1], part[i]);
    model.segments += part.size() - 1;
    InputLine line;
    line.points = part;
    line.feature = static_cast<std::uint32_t>(model.lines.lines.size());
    model.lines.lines.push_back(std::move(line));
    model.labels.push_back(label);
  }
  part.clear();
}

double ModelFrame::add(const std::vector<Vec2>& line, LineLabel label, GeneratedModel& model) const {
  double length = 0;
  std::vector<Vec2> part;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto inside = clip(line[i - 1], line[i], box_);
    if (!inside) {
      finish(part, label, length, model);
      continue;
    }
    const Vec2 from = rounded(inside->first), to = rounded(inside->second);
    if (!part.empty() && part.back() != from) finish(part, label, length, model);
    if (part.empty()) part.push_back(from);
    if (part.back() != to) part.push_back(to);
  }
  finish(part, label, length, model);
  model.total_length += length;
  return length;
}

void ModelFrame::add_outline(GeneratedModel& model) const {
  InputLine ring;
  ring.points = {box_.low, {box_.high.x, box_.low.y}, box_.high, {box_.low.x, box_.high.y}, box_.low};
  ring.polygon_ring = true;
  ring.feature = static_cast<std::uint32_t>(model.lines.lines.size());
  model.lines.lines.push_back(std::move(ring));
  model.labels.push_back({LineLabel::Kind::kOutline, 0, 0});
}

}  // namespace quarry
