// Feeds arbitrary bytes to the reader of one mesh format, QUARRY_FUZZ_EXTENSION: it must return cells that
// agree with each other and whose points are finite, or throw quarry::Error.
#include <cmath>

#include "engine/base/error.hpp"
#include "io/mesh/mesh_format.hpp"
#include "tests/fuzz/fuzz_input.hpp"

namespace {

using quarry::fuzz::require;

void check(const quarry::ReadCells& cells) {
  const std::size_t points = cells.x.size();
  require(cells.y.size() == points && cells.z.size() == points);
  for (std::size_t i = 0; i < points; ++i)
    require(std::isfinite(cells.x[i]) && std::isfinite(cells.y[i]) && std::isfinite(cells.z[i]));
  require(cells.regions.size() == cells.faces.size());
  for (const quarry::FaceCorners& corners : cells.faces)
    for (std::size_t k = 0; k < 4; ++k)
      require(corners[k].value() < points || (k == 3 && !corners[k].valid()));
  require(cells.constraints.size() == cells.edges.size());
  require(cells.kinds.empty() || cells.kinds.size() == cells.edges.size());
  for (const auto& [a, b] : cells.edges) require(a.value() < points && b.value() < points);
  require(cells.point_numbers.size() == cells.points.size());
  for (const quarry::VertexId v : cells.points) require(v.value() < points);
  for (const quarry::ReadGrouping& group : cells.groups) {
    require(group.of_faces.empty() || group.of_faces.size() == cells.faces.size());
    require(group.of_edges.empty() || group.of_edges.size() == cells.edges.size());
    for (const auto* indices : {&group.of_faces, &group.of_edges})
      for (const std::int32_t index : *indices) require(index < std::ssize(group.grouping.names));
  }
  require(cells.apertures.empty() || cells.apertures.size() == cells.edges.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const quarry::fuzz::InputFile file(QUARRY_FUZZ_EXTENSION);
  const std::string& path = file.write(data, size);
  try {
    quarry::ReadCells cells = quarry::read_cells(path);
    check(cells);
    static_cast<void>(quarry::make_mesh(path, std::move(cells)));
  } catch (const quarry::Error&) {
    // Refused in the way that the user sees.
  }
  return 0;
}
