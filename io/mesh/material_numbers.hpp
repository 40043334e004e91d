// One number for what a cell is made of, for formats and programs that know no more: regions come first, in
// the order of their numbers, and the lines after them, so that a fracture has a material of its own.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "io/mesh/mesh_file.hpp"
#include "io/mesh/numbering.hpp"

namespace quarry {

class MaterialNumbers {
 public:
  MaterialNumbers(const Mesh& mesh, const LiveNumbering& numbering) : tags_(mesh) {
    for (std::size_t i = 0; i < numbering.face_count(); ++i) {
      const std::int32_t region = tags_.region(numbering.face(i));
      if (regions_.empty() || regions_.back() != region) regions_.push_back(region);
      if (regions_.size() > 2 * kept_) keep_different(regions_, kept_);
    }
    for (const EdgeId e : numbering.edges()) lines_.push_back(tags_.constraint(e));
    keep_different(regions_, kept_);
    keep_different(lines_, kept_);
  }

  // From 0 for the region with the smallest number.
  [[nodiscard]] std::int32_t of(FaceId f) const { return rank(regions_, tags_.region(f)); }
  // From the number of regions on for the line with the smallest number; edges without one come first.
  [[nodiscard]] std::int32_t of(EdgeId e) const {
    return static_cast<std::int32_t>(regions_.size()) + rank(lines_, tags_.constraint(e));
  }

 private:
  static void keep_different(std::vector<std::int32_t>& numbers, std::size_t& kept) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    kept = std::max(numbers.size(), kFew);
  }
  static std::int32_t rank(const std::vector<std::int32_t>& numbers, std::int32_t number) {
    return static_cast<std::int32_t>(std::lower_bound(numbers.begin(), numbers.end(), number) -
                                     numbers.begin());
  }

  static constexpr std::size_t kFew = 1 << 12;
  MeshFileTags tags_;
  std::vector<std::int32_t> regions_, lines_;  // ascending
  std::size_t kept_ = kFew;
};

}  // namespace quarry
