// GEOS's SnapRoundingNoder: the peer of bench/linework_bench.cpp, compiled into that program alone.
#pragma once

#include <cstddef>
#include <memory>

#include "engine/geometry/line_set.hpp"

namespace quarry::bench {

class GeosNoder {
 public:
  // cell: the side of the grid that everything is rounded to, in input units; a line is bent through what it
  // passes at less than half of that.
  GeosNoder(const LineSet& lines, double cell);
  ~GeosNoder();
  GeosNoder(const GeosNoder&) = delete;
  GeosNoder& operator=(const GeosNoder&) = delete;

  // Nodes the lines; returns the number of segments of the noded strings.
  [[nodiscard]] std::size_t node() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace quarry::bench
