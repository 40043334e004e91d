// The arguments of `quarry mesh`: declared, checked, and turned into the options of the section job.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "pipeline/cli/common_arguments.hpp"
#include "pipeline/cli/demands.hpp"
#include "pipeline/cli/mesh_output.hpp"
#include "pipeline/section/options.hpp"

namespace quarry::cli {

struct MeshArguments {
  SectionOptions section;
  CommonArguments common;
  std::string output, report, picture, page, config;
  std::vector<std::string> require;
  MeshOutput written;

  // As written; fill_section() reads them.
  std::string elements = "quad", method = "deferred", start, orient, quads, cleanup, preset = "default";
  std::optional<double> mixed_quality;
  bool keep_boundary = false;

  // Of surfaces.
  std::string sharp = "auto", repaired;
  std::vector<std::string> lines;
  double weld = 0;
  std::optional<double> curvature;
  std::uint32_t fill_holes = 0;
};

// Lines in and lengths: what `quarry mesh` and `quarry clean` share.
void add_line_options(CLI::App& command, SectionOptions& section);

void add_mesh_options(CLI::App& command, MeshArguments& arguments);

// Writes what was given into arguments.section. Throws Error(kUsage) for what is missing, makes no sense or
// is not built yet.
void fill_section(MeshArguments& arguments);

}  // namespace quarry::cli
