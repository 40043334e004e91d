#include "pipeline/cli/page_output.hpp"

#include <filesystem>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "io/page/page.hpp"
#include "kernels/quality/face.hpp"

namespace quarry::cli {
namespace {

std::vector<PageFigure> figures_of(const QualitySummary& quality) {
  const ShapeSummary& all = quality.all;
  std::vector<PageFigure> figures;
  if (quality.quads.faces > 0) figures.push_back({"quads", fmt::format("{}", quality.quads.faces)});
  if (quality.triangles.faces > 0)
    figures.push_back({"triangles", fmt::format("{}", quality.triangles.faces)});
  figures.insert(
      figures.end(),
      {{"vertices", fmt::format("{}", quality.vertices)},
       {"area", fmt::format("{:.5g}", quality.area)},
       {"scaled Jacobian, smallest", fmt::format("{:.3f}", all.scaled_jacobian.min)},
       {"mean", fmt::format("{:.4f}", all.scaled_jacobian.mean)},
       {"below 0.2", fmt::format("{:.3f} %", 100 * all.share(all.scaled_jacobian_below_0p2))},
       {"smallest angle", fmt::format("{:.1f}\u00b0", all.min_angle.min)},
       {"smallest angles in 80 to 90",
        fmt::format("{:.1f} %", 100 * all.share(all.min_angle_histogram.back()))},
       {"longest by shortest edge", fmt::format("{:.2f}", all.aspect.max)},
       {"irregular inner vertices", fmt::format("{:.2f} %", 100 * quality.valence.irregular_share())}});
  return figures;
}

PageHistogram histogram_of(const char* name, double high, std::span<const std::size_t> counts) {
  return {name, 0, high, std::vector<std::size_t>(counts.begin(), counts.end())};
}

}  // namespace

void write_mesh_page(const std::string& path, const Mesh& mesh, const QualitySummary& quality,
                     const std::string& source) {
  const std::vector<double> jacobians = scaled_jacobians(mesh);
  PageOptions options;
  options.title = std::filesystem::path(source).filename().string();
  options.figures = figures_of(quality);
  options.histograms = {
      histogram_of("Scaled Jacobian", 1, quality.all.scaled_jacobian_histogram),
      histogram_of("Smallest angle of each element, degrees", 90, quality.all.min_angle_histogram)};
  options.quality = jacobians;
  write_page(path, mesh, options);
}

}  // namespace quarry::cli
