// What stands below a picture: a scale bar, the counts of elements, the scale of the quality.
#pragma once

#include "engine/mesh/mesh.hpp"
#include "io/picture/canvas.hpp"
#include "io/picture/picture.hpp"
#include "io/picture/view.hpp"

namespace quarry {

void draw_legend(Canvas& canvas, const PictureView& view, const Mesh& mesh, const PictureOptions& options);

// The largest of 1, 2 or 5 times a power of ten that is not above the limit, which is positive.
[[nodiscard]] double round_length(double limit);

// 1234567 as "1,234,567".
[[nodiscard]] std::string grouped_digits(std::size_t number);

}  // namespace quarry
