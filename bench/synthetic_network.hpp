// The network that the benchmarks share: curved fractures of pipeline/generate, which cross, nearly touch and
// end anywhere, as those of trace maps do.
#pragma once

#include <cstdint>

#include "engine/geometry/line_set.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/linework/clean_lines.hpp"

namespace quarry::bench {

// So many fractures in a box of 1000 units, far from the origin as map coordinates are. Those that are not
// curved are one segment each.
[[nodiscard]] LineSet draw_network(std::uint32_t lines, bool curved = true);

// The network cleaned for elements of the given size, within its box.
[[nodiscard]] CleanedLines clean_network(std::uint32_t lines, double size);

// The crisscross start of that size, with the tags that insertion asks for.
[[nodiscard]] Mesh start_mesh(const NodedLines& lines, double size);

// The start with all lines inserted, what lies outside them removed, in Hilbert order.
[[nodiscard]] Mesh triangle_mesh(const NodedLines& lines, double size);

// The triangles paired and halved: quads, not yet smoothed.
[[nodiscard]] Mesh raw_quad_mesh(const NodedLines& lines, double size);

}  // namespace quarry::bench
