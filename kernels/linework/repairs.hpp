// Tells each line what was mended of it, beside what the ledger says of its course.
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/linework/clean_lines.hpp"

namespace quarry::linework {

// Adds to the reasons of lines, and to the counts: segments of no length, lines with the points of an earlier
// line (in either direction), and dangling ends that were cut. cut_dangles: how many of each line were.
void tell_repairs(const LineSet& lines, const IdVector<LineId, std::uint32_t>& cut_dangles,
                  IdVector<LineId, LedgerEntry>& ledger, CleanCounts& counts);

}  // namespace quarry::linework
