#include "pipeline/section/read_input.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/lines/coordinate_system.hpp"
#include "io/lines/line_format.hpp"
#include "io/lines/line_reader.hpp"
#include "pipeline/section/boundary_rule.hpp"
#include "pipeline/section/vertical_plane.hpp"

namespace quarry {
namespace {

// Arcs follow --tolerance. With --count the size, and so its default, is known once the lines are: they are
// read again.
LineSet read_files(const SectionOptions& options, const std::vector<std::string>& paths,
                   const Progress& progress, std::optional<double>& arc_tolerance) {
  constexpr double kShareOfSize = 0.05;
  const bool may_have_arcs = std::ranges::any_of(paths, is_read_by_ogr);
  if (options.tolerance)
    arc_tolerance = options.tolerance;
  else if (options.size)
    arc_tolerance = kShareOfSize * *options.size;
  if (arc_tolerance && !(*arc_tolerance > 0 && std::isfinite(*arc_tolerance))) arc_tolerance.reset();
  LineSet lines = read_lines(paths, {arc_tolerance, progress});
  if (arc_tolerance || !may_have_arcs || !options.count || !(*options.count > 0)) return lines;
  const Box2 box = lines.box();
  const double tolerance = kShareOfSize * std::sqrt(box.width() * box.height() / *options.count);
  if (!(tolerance > 0 && std::isfinite(tolerance))) return lines;
  arc_tolerance = tolerance;
  return read_lines(paths, {arc_tolerance, progress});
}

bool has_degrees(const LineSet& lines) {
  return std::ranges::any_of(lines.systems, &CoordinateSystem::geographic);
}

void refuse_degrees(const LineSet& lines) {
  for (std::size_t i = 0; i < lines.systems.size(); ++i) {
    const CoordinateSystem& system = lines.systems[i];
    if (!system.geographic) continue;
    throw Error(
        ErrorKind::kInput,
        fmt::format("{}: its coordinates {}: --project turns them into metres (the local UTM zone), --as-is "
                    "takes them for lengths",
                    lines.files[i],
                    system.assumed ? "look like degrees, which GeoJSON without crs has (RFC 7946)"
                                   : "are degrees of longitude and latitude"));
  }
}

// The system of all files that name one; "" where they name different ones, which is noted.
std::string find_common_system(const LineSet& lines, std::vector<std::string>& notes) {
  const CoordinateSystem* common = nullptr;
  for (std::size_t i = 0; i < lines.systems.size(); ++i) {
    const CoordinateSystem& system = lines.systems[i];
    if (system.definition.empty()) continue;
    if (common == nullptr) common = &system;
    if (same_system(system.definition, common->definition)) continue;
    notes.push_back(
        fmt::format("{} and {} have different coordinate systems: their lines may not lie where they "
                    "belong",
                    lines.files[static_cast<std::size_t>(common - lines.systems.data())], lines.files[i]));
    return {};
  }
  return common == nullptr ? "" : common->definition;
}

}  // namespace

SectionInput read_section_input(const SectionOptions& options, const Progress& progress) {
  SectionInput input;
  std::optional<double> arc_tolerance;
  input.lines = read_files(options, options.inputs, progress, arc_tolerance);
  if (parse_boundary(options.boundary).kind == BoundaryRule::Kind::kFile)
    input.boundary = read_lines({options.boundary}, {arc_tolerance, progress});
  if (options.project) {
    if (!has_degrees(input.lines))
      throw Error(ErrorKind::kUsage,
                  "--project is for degrees of longitude and latitude; no input file is said to have them");
    input.projected = project_to_utm(input.lines, input.boundary ? &*input.boundary : nullptr);
    input.system = input.projected.substr(0, input.projected.find(' '));
    input.notes.push_back(fmt::format("coordinates are projected to {}", input.projected));
  } else if (!options.as_is) {
    refuse_degrees(input.lines);
    if (input.boundary) refuse_degrees(*input.boundary);
  }
  if (!options.project) input.system = find_common_system(input.lines, input.notes);
  if (!options.section.empty()) {
    take_vertical_plane(input.lines, options.section);
    input.system.clear();
  } else {
    refuse_vertical_planes(input.lines);
  }
  return input;
}

}  // namespace quarry
