#include "bench/geos_noder.hpp"

#include <vector>

#include <geos/geom/Coordinate.h>
#include <geos/geom/CoordinateArraySequence.h>
#include <geos/geom/PrecisionModel.h>
#include <geos/noding/NodedSegmentString.h>
#include <geos/noding/snapround/SnapRoundingNoder.h>

namespace quarry::bench {
namespace {

using geos::noding::NodedSegmentString;
using geos::noding::SegmentString;

std::unique_ptr<NodedSegmentString> string_of(const InputLine& line) {
  auto points = std::make_unique<geos::geom::CoordinateArraySequence>();
  for (const Vec2 p : line.points) points->add(geos::geom::Coordinate(p.x, p.y));
  return std::make_unique<NodedSegmentString>(points.release(), nullptr);
}

}  // namespace

struct GeosNoder::Parts {
  const LineSet& lines;
  geos::geom::PrecisionModel rounding;
};

GeosNoder::GeosNoder(const LineSet& lines, double cell)
    : parts_(std::make_unique<Parts>(lines, geos::geom::PrecisionModel(1 / cell))) {}

GeosNoder::~GeosNoder() = default;

std::size_t GeosNoder::node() const {
  std::vector<std::unique_ptr<NodedSegmentString>> strings;
  std::vector<SegmentString*> given;
  for (const InputLine& line : parts_->lines.lines) {
    strings.push_back(string_of(line));
    given.push_back(strings.back().get());
  }
  geos::noding::snapround::SnapRoundingNoder noder(&parts_->rounding);
  noder.computeNodes(&given);
  const std::unique_ptr<std::vector<SegmentString*>> noded(noder.getNodedSubstrings());
  std::size_t segments = 0;
  for (SegmentString* string : *noded) {
    segments += string->size() - 1;
    delete string;
  }
  return segments;
}

}  // namespace quarry::bench
