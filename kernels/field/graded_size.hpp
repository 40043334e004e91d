// A size field that is fine at given points and segments and grows with the distance from them, up to a
// largest size.
#pragma once

#include <span>
#include <vector>

#include "engine/geometry/grid.hpp"
#include "kernels/field/size_field.hpp"

namespace quarry {

// A segment (or a point: both ends equal) at which a size is wanted.
struct SizeSource {
  Segment segment;
  double size = 1;
  double reach = 0;  // the size holds up to this distance, and grows from there
};

struct GradedSizeOptions {
  double largest = 1;      // far from all sources, in input units
  double gradation = 0.3;  // growth of the size for each unit of distance; > 0
};

// Throws Error(kUsage) unless both are positive and finite.
void require_grading(const GradedSizeOptions& options);

// at(p) is the smallest of `largest` and, over the sources, size + gradation * (distance -
// reach), or the size within its reach: the largest field that is at most the wanted size there and whose
// slope nowhere exceeds the gradation.
class GradedSize final : public SizeField {
 public:
  // Throws Error(kUsage) if a size or the gradation is not positive and finite, or a reach is negative.
  GradedSize(std::vector<SizeSource> sources, const GradedSizeOptions& options);
  GradedSize(const GradedSize&) = delete;
  GradedSize& operator=(const GradedSize&) = delete;

  [[nodiscard]] double at(Vec2 p) const override;

 private:
  std::vector<SizeSource> sources_;
  std::vector<Segment> segments_;
  GradedSizeOptions options_;
  double smallest_;
  double reach_;  // the longest
  SegmentGrid grid_;
};

}  // namespace quarry
