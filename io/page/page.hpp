// One self-contained .html file of a mesh: a view that turns, a table of figures, histograms. It asks nothing
// of the network.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry {

struct PageFigure {
  std::string name, value;
};

// Counts of values from low to high, in bins of one width.
struct PageHistogram {
  std::string name;
  double low = 0, high = 1;
  std::vector<std::size_t> counts;
};

struct PageOptions {
  std::string title;
  std::vector<PageFigure> figures;
  std::vector<PageHistogram> histograms;
  // In [0, 1], for each face slot; what is not positive is drawn in black.
  std::span<const double> quality;
};

// Faces have the colours of their quality or of the tag "region"; edge entities and rims are drawn strong.
// The same bytes for the same mesh and options. Throws Error(kUsage) for another extension than .html, or a
// mesh without faces; Error(kOutput) where it cannot be written.
void write_page(const std::string& path, const Mesh& mesh, const PageOptions& options);

// Throws Error(kUsage) unless write_page knows the extension: for a check before a long job.
void check_page_extension(const std::string& path);
[[nodiscard]] bool is_page(const std::string& path);

}  // namespace quarry
