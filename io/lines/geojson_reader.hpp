// GeoJSON (RFC 7946, and the member "crs" of its forerunner) read as a stream of tokens, so that memory holds
// the lines alone, never the document.
#pragma once

#include "io/lines/line_source.hpp"

namespace quarry {

// Appends the lines of a file: LineString, MultiLineString, Polygon, MultiPolygon, also within (nested)
// GeometryCollections, Features and FeatureCollections. Points and geometries that are null are passed over;
// the third coordinate is the height, those beyond are ignored; keys may come in any order; a ring that is
// not closed is closed. Errors as in read_lines.
void read_geojson_lines(const LineSource& source, LineSet& lines);

}  // namespace quarry
