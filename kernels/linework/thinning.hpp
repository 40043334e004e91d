// Removal of bends and of short edges from a noded network that keeps it noded: nothing that is done here
// lets two edges cross or a node come nearer than the snapping distance to a foreign edge.
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/linework/clean_lines.hpp"
#include "kernels/linework/path_network.hpp"

namespace quarry::linework {

// Removes bends within options.tolerance, collapses edges shorter than options.min_edge where that moves no
// line by more than snap + min_edge, and removes bends again. What is refused is left as it was. Returns for
// each raw line how many dangling ends of it were cut back to a node where others meet.
std::vector<std::uint32_t> thin_out(PathNetwork& network, const CleanOptions& options, CleanCounts& counts,
                                    const Progress& progress);

}  // namespace quarry::linework
