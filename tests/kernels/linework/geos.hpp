// Lines and polygons in GEOS, by its C interface.
#pragma once

#include <utility>
#include <vector>

#include <geos_c.h>

#include "tests/kernels/linework/line_samples.hpp"

namespace quarry {

struct Geos {
  Geos() : handle(GEOS_init_r()) {}
  ~Geos() { GEOS_finish_r(handle); }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  GEOSGeometry* line_of(const Points& points) const {
    return GEOSGeom_createLineString_r(handle, sequence_of(points));
  }

  // To be destroyed by the caller, as all that these return; takes the parts over.
  GEOSGeometry* collection_of(int kind, std::vector<GEOSGeometry*> parts) const {
    return GEOSGeom_createCollection_r(handle, kind, parts.data(), static_cast<unsigned>(parts.size()));
  }

  GEOSGeometry* polygon_of(const Points& ring) const {
    GEOSCoordSequence* sequence = sequence_of(ring);
    return GEOSGeom_createPolygon_r(handle, GEOSGeom_createLinearRing_r(handle, sequence), nullptr, 0);
  }

  GEOSCoordSequence* sequence_of(const Points& points) const {
    GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(handle, static_cast<unsigned>(points.size()), 2);
    for (unsigned i = 0; i < points.size(); ++i)
      GEOSCoordSeq_setXY_r(handle, sequence, i, points[i].x, points[i].y);
    return sequence;
  }

  GEOSContextHandle_t handle;
};

}  // namespace quarry
