// How a mesh file is written: what the commands that write one have in common.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "io/mesh/mesh_file.hpp"

namespace quarry::cli {

struct MeshOutput {
  std::string order = "1", consumer = "any";
  bool compress = false;
  bool split_fractures = false;

  // Throws Error(kUsage) unless the format of the path can be written, with elements of that order and for
  // that program.
  void check(const std::string& path) const;
  // The options that these words stand for; the rest is the caller's.
  [[nodiscard]] MeshWriteOptions write_options() const;
  // What of it changes the mesh, where it is not the default: " order=2 split-fractures=1".
  [[nodiscard]] std::string text() const;
  // What is to be done to a finished mesh before it is written.
  void prepare(Mesh& mesh) const;
};

void add_mesh_output_options(CLI::App& command, MeshOutput& output, const char* group);

}  // namespace quarry::cli
