#include "pipeline/cli/mesh_output.hpp"

#include <utility>

#include "engine/base/log.hpp"
#include "io/mesh/mesh_format.hpp"
#include "pipeline/split/split_fractures.hpp"

namespace quarry::cli {

MeshWriteOptions MeshOutput::write_options() const {
  MeshWriteOptions options;
  options.compress = compress;
  options.order = order == "2"        ? ElementOrder::kQuadratic
                  : order == "2-full" ? ElementOrder::kBiquadratic
                                      : ElementOrder::kLinear;
  options.consumer = consumer == "ogs"     ? MeshConsumer::kOpenGeoSys
                     : consumer == "moose" ? MeshConsumer::kMoose
                                           : MeshConsumer::kAny;
  return options;
}

void MeshOutput::check(const std::string& path) const {
  const MeshWriteOptions options = write_options();
  check_writable_order(path, options.order);
  check_writable_for(path, options.consumer);
}

std::string MeshOutput::text() const {
  std::string text;
  if (order != "1") text += " order=" + order;
  if (consumer != "any") text += " for=" + consumer;
  if (split_fractures) text += " split-fractures=1";
  return text;
}

void MeshOutput::prepare(Mesh& mesh) const {
  if (!split_fractures) return;
  SplitReport report;
  mesh = quarry::split_fractures(std::move(mesh), report);
  log::info("split: {} edges of lines have become two, with {} more nodes", report.edges, report.new_nodes);
}

void add_mesh_output_options(CLI::App& command, MeshOutput& output, const char* group) {
  command
      .add_option(
          "--order", output.order,
          "of the elements: 2 has a node in the middle of each edge too (8 a quadrilateral, 6 a triangle), "
          "2-full one in the middle of each quadrilateral as well; default 1")
      ->check(CLI::IsMember({"1", "2", "2-full"}).description(""))
      ->type_name("1|2|2-full")
      ->group(group);
  command
      .add_option("--for", output.consumer,
                  "ogs: a .vtu with MaterialIDs, in which each edge of an interior line is one cell and the "
                  "boundary none; "
                  "moose: a .msh with sidesets and blocks of lower dimension")
      ->check(CLI::IsMember({"any", "ogs", "moose"}).description(""))
      ->type_name("ogs|moose")
      ->group(group);
  command
      .add_flag("--split-fractures", output.split_fractures,
                "each side of an interior line has nodes of its own: lines have a left and a right side in "
                "the file")
      ->group(group);
  command
      .add_flag("--compress", output.compress,
                "deflate in a .vtu or .vtkhdf: about half the bytes, slower to write")
      ->group(group);
}

}  // namespace quarry::cli
