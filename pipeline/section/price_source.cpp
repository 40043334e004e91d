#include "pipeline/section/price_source.hpp"

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/number_text.hpp"
#include "io/raster/raster_file.hpp"

namespace quarry {
namespace {

constexpr std::string_view kNearLines = "lines:";

Raster read_prices(const std::string& path) {
  Raster raster = read_raster(path);
  for (std::size_t i = 0; i < raster.values.size(); ++i)
    if (raster.values[i] <= 0)
      throw Error(ErrorKind::kInput,
                  fmt::format("{}: row {}, column {}: the price is {}: it must be above 0, or NODATA for the "
                              "usual price",
                              path, i / raster.columns + 1, i % raster.columns + 1, raster.values[i]));
  return raster;
}

}  // namespace

std::optional<LinePrice> parse_line_price(const std::string& text) {
  if (!text.starts_with(kNearLines)) return std::nullopt;
  const std::string_view rest = std::string_view(text).substr(kNearLines.size());
  const std::size_t colon = rest.find(':');
  LinePrice price{0, 0};
  if (colon != std::string_view::npos)
    price = {parse_finite(rest.substr(0, colon)).value_or(0),
             parse_finite(rest.substr(colon + 1)).value_or(0)};
  if (!(price.distance > 0 && price.factor > 0))
    throw Error(
        ErrorKind::kUsage,
        fmt::format("--irregular-price {}: give it as lines:DISTANCE:FACTOR with two numbers above 0", text));
  return price;
}

std::string price_file(const std::string& text) { return parse_line_price(text) ? "" : text; }

std::string price_text(const std::string& text) { return price_file(text).empty() ? text : "file"; }

PriceSource::PriceSource(const std::string& text) : near_lines_(parse_line_price(text)) {
  if (!near_lines_ && !text.empty()) raster_ = read_prices(text);
}

IrregularPrice PriceSource::price(const NodedLines& lines) const {
  if (raster_) {
    const auto raster = std::make_shared<const Raster>(*raster_);
    return [raster](Vec3 p) { return raster->at({p.x, p.y}).value_or(1); };
  }
  if (!near_lines_) return {};
  std::vector<Segment> segments;
  for (const Piece& piece : lines.pieces)
    if (piece.kind == PieceKindOf::kInterior)
      segments.push_back({lines.nodes[piece.from], lines.nodes[piece.to]});
  return price_near(std::move(segments), *near_lines_);
}

}  // namespace quarry
