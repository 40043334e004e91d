// A size field given by a raster, with its growth limited.
#pragma once

#include "engine/geometry/raster.hpp"
#include "kernels/field/graded_size.hpp"
#include "kernels/field/size_field.hpp"

namespace quarry {

// Cells without data want the largest size. What one cell wants holds its neighbours down: values grow by at
// most the gradation times the distance between the middles of cells, measured along steps to the eight cells
// around (which are up to 8 % longer than the straight way). Between middles the field is bilinear; outside
// the raster it grows from the nearest place on its rim.
class RasterSize final : public SizeField {
 public:
  // Throws Error(kUsage) if a value, the largest size or the gradation is not positive and finite.
  RasterSize(Raster raster, const GradedSizeOptions& options);
  [[nodiscard]] double at(Vec2 p) const override;

 private:
  Raster raster_;
  GradedSizeOptions options_;
};

}  // namespace quarry
