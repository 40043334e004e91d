#include "kernels/field/raster_size.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"

namespace quarry {
namespace {

constexpr double kRootOf2 = 1.4142135623730951;

// Lowers values to what their neighbours allow, from one corner to the other and back, until nothing changes.
// From the first corner a cell looks at the four neighbours before it, on the way back at the four after it.
class GrowthLimit {
 public:
  GrowthLimit(Raster& raster, double gradation)
      : raster_(raster),
        columns_(static_cast<std::ptrdiff_t>(raster.columns)),
        rows_(static_cast<std::ptrdiff_t>(raster.rows)),
        straight_(gradation * raster.cell),
        diagonal_(gradation * raster.cell * kRootOf2) {}

  void run() {
    do {
      changed_ = false;
      for (std::ptrdiff_t r = 0; r < rows_; ++r)
        for (std::ptrdiff_t c = 0; c < columns_; ++c) look(r, c, -1);
      for (std::ptrdiff_t r = rows_; r-- > 0;)
        for (std::ptrdiff_t c = columns_; c-- > 0;) look(r, c, 1);
    } while (changed_);
  }

 private:
  void look(std::ptrdiff_t r, std::ptrdiff_t c, std::ptrdiff_t side) {
    take(r, c, r, c + side, straight_);
    take(r, c, r + side, c, straight_);
    take(r, c, r + side, c + side, diagonal_);
    take(r, c, r + side, c - side, diagonal_);
  }
  void take(std::ptrdiff_t r, std::ptrdiff_t c, std::ptrdiff_t from_row, std::ptrdiff_t from_column,
            double growth) {
    if (from_row < 0 || from_row >= rows_ || from_column < 0 || from_column >= columns_) return;
    double& value = raster_.values[static_cast<std::size_t>(r * columns_ + c)];
    const double most = raster_.values[static_cast<std::size_t>(from_row * columns_ + from_column)] + growth;
    if (!(value > most)) return;
    value = most;
    changed_ = true;
  }

  Raster& raster_;
  std::ptrdiff_t columns_, rows_;
  double straight_, diagonal_;
  bool changed_ = false;
};

}  // namespace

RasterSize::RasterSize(Raster raster, const GradedSizeOptions& options)
    : raster_(std::move(raster)), options_(options) {
  require_grading(options);
  for (std::size_t i = 0; i < raster_.values.size(); ++i) {
    double& value = raster_.values[i];
    if (std::isnan(value)) value = options.largest;
    if (!(value > 0) || !std::isfinite(value))
      throw Error(ErrorKind::kUsage, fmt::format("row {}, column {}: the size is {}: it must be positive",
                                                 i / raster_.columns + 1, i % raster_.columns + 1, value));
    value = std::min(value, options.largest);
  }
  GrowthLimit(raster_, options.gradation).run();
}

double RasterSize::at(Vec2 p) const {
  const Vec2 high = raster_.low + Vec2{static_cast<double>(raster_.columns) * raster_.cell,
                                       static_cast<double>(raster_.rows) * raster_.cell};
  const auto inside = [&](double inset) {
    return Vec2{std::clamp(p.x, raster_.low.x + inset, high.x - inset),
                std::clamp(p.y, raster_.low.y + inset, high.y - inset)};
  };
  // In the outer half of the outermost cells the value is that of their middles: a place away from the rim,
  // where rounding may lead out of the raster, has the same.
  const double at_rim = raster_.at(inside(0.25 * raster_.cell)).value_or(options_.largest);
  return std::min(options_.largest, at_rim + options_.gradation * distance(p, inside(0)));
}

}  // namespace quarry
