// What became of each input line, read from the network before and after.
#pragma once

#include <vector>

#include "kernels/linework/clean_lines.hpp"
#include "kernels/linework/lines_at.hpp"
#include "kernels/linework/path_network.hpp"

namespace quarry::linework {

// Why lines have no piece left, as known so far; empty where they have one.
using Reasons = IdVector<LineId, std::string>;

// Adds `why` to lines that have no edge in the network and no reason yet.
void note_lost_lines(const PathNetwork& network, const std::string& why, Reasons& reasons);

// The input lines that take each edge.
[[nodiscard]] LinesAt lines_on_edges(const PathNetwork& network);

// clipped: the length outside the outline, for each raw line.
[[nodiscard]] IdVector<LineId, LedgerEntry> make_ledger(const LineSet& lines, const PathNetwork& network,
                                                        const std::vector<double>& clipped,
                                                        const Reasons& reasons);

}  // namespace quarry::linework
