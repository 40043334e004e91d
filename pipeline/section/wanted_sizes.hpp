// How large elements are wanted, by place, as the user says it: a file of sizes, groups of lines near which
// they are smaller, gaps between lines into which they are to fit.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/geometry/box.hpp"
#include "engine/geometry/line_set.hpp"
#include "kernels/field/graded_size.hpp"
#include "kernels/field/size_field.hpp"

namespace quarry {

struct SizeOptions {
  std::string file = {};               // a raster (.asc), or points with a size each (any other)
  std::vector<std::string> near = {};  // GROUP:SIZE:DISTANCE each
  std::optional<double> between = {};  // elements wanted across a gap between lines
  double gradation = GradedSizeOptions().gradation;
  std::optional<double> smallest = {};  // unset: a tenth of the largest, or the least that is accepted

  // All elements are to be of the same size.
  [[nodiscard]] bool uniform() const { return file.empty() && near.empty() && !between; }
};

// Of one --refine-near.
struct NearGroup {
  std::string group;
  double size = 0, distance = 0;
};
// The meaning of GROUP:SIZE:DISTANCE. Throws Error(kUsage).
[[nodiscard]] NearGroup parse_near_group(const std::string& text);

class WantedSizes {
 public:
  // files: what the groups of the files of lines are called. largest: wanted where nothing else is asked for,
  // in input units. Reads the file. Throws Error(kUsage) for what makes no sense, for a smallest size that
  // coordinates of the lines do not tell apart and for a group that no line belongs to, Error(kInput) for a
  // file that cannot be used.
  WantedSizes(const SizeOptions& options, const LineSet& lines, const std::vector<std::string>& files,
              double largest);

  // From here on these lines ask for sizes as well where they run close, in place of those of the last call.
  void set_gaps(const NodedLines& lines);
  // Multiplies all sizes, so that about so many squares fill what of the box is inside.
  void fit(double count, const Box2& box, const std::function<bool(Vec2)>& inside);
  void multiply(double factor) { rescale(factor * factor_); }
  // About how many squares of the wanted sizes fill the box; not counted far beyond `most`.
  [[nodiscard]] double count_squares(const Box2& box, double most) const;

  [[nodiscard]] const SizeField& field() const { return *scaled_; }
  // The largest size, and the one below which none is wanted.
  [[nodiscard]] double largest() const { return factor_ * largest_; }
  [[nodiscard]] double smallest() const { return factor_ * smallest_; }
  // The smallest size wanted at a point of the lines.
  [[nodiscard]] double smallest_on(const LineSet& lines) const;

 private:
  void rescale(double factor);
  [[nodiscard]] GradedSizeOptions grading() const { return {largest_, options_.gradation}; }

  SizeOptions options_;
  double largest_, smallest_;
  double factor_ = 1;
  std::vector<std::shared_ptr<const SizeField>> asked_;
  std::shared_ptr<const SizeField> gaps_;
  std::unique_ptr<const SmallestSize> sizes_;
  std::unique_ptr<const ScaledSize> scaled_;
};

}  // namespace quarry
