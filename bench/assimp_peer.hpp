// Reading surfaces with assimp, the yardstick of mesh_reader_bench, where that library is at hand.
#pragma once

#include <cstddef>
#include <string>

namespace quarry::bench {

// The number of triangles. With `weld`, equal points become one, as quarry's reader of .stl makes them.
[[nodiscard]] std::size_t read_with_assimp(const std::string& path, bool weld);

}  // namespace quarry::bench
