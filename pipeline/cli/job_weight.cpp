#include "pipeline/cli/job_weight.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/geometry/line_set.hpp"
#include "io/lines/line_format.hpp"
#include "io/lines/line_reader.hpp"
#include "io/mesh/mesh_format.hpp"
#include "pipeline/cli/mesh_surface_command.hpp"

namespace quarry::cli {
namespace {

double elements_of_lines(MeshArguments& mesh) {
  fill_section(mesh);
  const SectionOptions& section = mesh.section;
  // Another program would have to be run.
  for (const std::string& input : section.inputs)
    if (is_read_by_ogr(input)) return 0;
  const LineSet lines = read_lines(section.inputs);
  double points = 0;
  for (const InputLine& line : lines.lines) points += static_cast<double>(line.points.size());
  return points + (section.count ? *section.count
                                 : predict_elements(section, lines.box(), section.size.value_or(0), nullptr));
}

double length(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

double elements_of_surface(const MeshArguments& mesh) {
  double area = 0, faces = 0;
  for (const std::string& input : mesh.section.inputs) {
    const ReadCells cells = read_cells(input);
    faces += static_cast<double>(cells.faces.size());
    for (const FaceCorners& face : cells.faces)
      for (std::size_t i = 2; i < face.size() && face[i].valid(); ++i) {
        const std::size_t a = face[0].value(), b = face[i - 1].value(), c = face[i].value();
        if (std::max({a, b, c}) >= cells.x.size()) continue;
        const double ux = cells.x[b] - cells.x[a], uy = cells.y[b] - cells.y[a], uz = cells.z[b] - cells.z[a];
        const double vx = cells.x[c] - cells.x[a], vy = cells.y[c] - cells.y[a], vz = cells.z[c] - cells.z[a];
        area += 0.5 * length(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
      }
  }
  const double size = mesh.section.size.value_or(0);
  return faces + (mesh.section.count ? *mesh.section.count : area / (size * size));
}

}  // namespace

double foresee_elements(MeshArguments mesh) {
  return is_surface(mesh.section.inputs) ? elements_of_surface(mesh) : elements_of_lines(mesh);
}

double elements_of_bytes(double bytes) {
  // Of a point in text, with its share of all else.
  constexpr double kBytes = 40;
  return 1 + bytes / kBytes;
}

}  // namespace quarry::cli
