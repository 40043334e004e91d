// Lines of every format that GDAL's ogr2ogr knows, by running it where it is installed: it is not linked.
#pragma once

#include <optional>
#include <string>

#include "engine/base/progress.hpp"
#include "io/lines/line_source.hpp"

namespace quarry {

struct OgrOptions {
  // The largest distance between an arc and the lines that stand for it, in input units; unset: steps of 1
  // degree.
  std::optional<double> arc_tolerance;
  Progress progress;
};

// Appends the lines of all layers of a file (or folder), in their order. source.name is its path, and
// source.text is not looked at. Throws Error(kInput), with the remedy, where GDAL is not installed and where
// it cannot read the file; Error(kInterrupted) and Error(kBudget) as run_program.
void read_ogr_lines(const LineSource& source, const OgrOptions& options, LineSet& lines);

}  // namespace quarry
