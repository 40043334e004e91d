// The arrays of a .vtu file as functions of an item's number, so that any part of one can be made at any time
// and on any thread: the file is never held as a whole.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "io/mesh/mesh_file.hpp"
#include "io/mesh/numbering.hpp"

namespace quarry {

struct VtuArray {
  std::string name;
  std::string type;  // VTK's name of the scalar
  int components = 1;
  std::size_t items = 0;
  std::size_t item_bytes = 0;
  // Writes items [begin, end) to out.
  std::function<void(std::size_t begin, std::size_t end, std::byte* out)> fill;
};

struct VtuArrays {
  VtuArray points;
  std::vector<VtuArray> cells;  // connectivity, offsets, types
  std::vector<VtuArray> point_data;
  std::vector<VtuArray> cell_data;
};

// Of connectivity and offsets: kNarrow takes 32 bits where they suffice.
enum class IndexWidth { kNarrow, kWide };

// The arrays refer to mesh, numbering and options, which must outlive them.
[[nodiscard]] VtuArrays make_vtu_arrays(const Mesh& mesh, const LiveNumbering& numbering,
                                        const MeshWriteOptions& options,
                                        IndexWidth width = IndexWidth::kNarrow);

}  // namespace quarry
