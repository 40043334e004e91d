#include "kernels/linework/repairs.hpp"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "engine/base/random.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"

namespace quarry::linework {
namespace {

void add_reason(const std::string& why, LedgerEntry& entry) {
  entry.why += (entry.why.empty() ? "" : "; ") + why;
}

std::uint32_t count_empty_segments(const InputLine& line) {
  std::uint32_t count = 0;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
    if (line.points[i] == line.points[i + 1]) ++count;
  return count;
}

// The same for a line and its reverse; 0 and -0 are one.
std::uint64_t hash_of(const InputLine& line) {
  const auto mix_in = [](std::uint64_t hash, Vec2 p) {
    hash = mix64(hash ^ std::bit_cast<std::uint64_t>(p.x + 0.0));
    return mix64(hash ^ std::bit_cast<std::uint64_t>(p.y + 0.0));
  };
  std::uint64_t forward = line.points.size();
  std::uint64_t backward = line.points.size();
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    forward = mix_in(forward, line.points[i]);
    backward = mix_in(backward, line.points[line.points.size() - 1 - i]);
  }
  return std::min(forward, backward);
}

bool same_points(const InputLine& a, const InputLine& b) {
  return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end()) ||
         std::equal(a.points.begin(), a.points.end(), b.points.rbegin(), b.points.rend());
}

// For each line the first one with the same points, if that is another; lines without points have none.
IdVector<LineId, LineId> find_originals(const LineSet& lines) {
  std::vector<std::uint64_t> keys(lines.lines.size());
  parallel::for_each(
      keys.size(), [&](std::size_t i) { keys[i] = hash_of(lines.lines[LineId(i)]); }, 256);
  const std::vector<std::uint32_t> order = parallel::sorted_order(keys);
  IdVector<LineId, LineId> originals(lines.lines.size());
  std::size_t first = 0;  // of those with the same hash
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (keys[order[i]] != keys[order[first]]) first = i;
    const LineId line(order[i]);
    const LineId earlier(order[first]);
    if (first < i && !lines.lines[line].points.empty() &&
        same_points(lines.lines[line], lines.lines[earlier]))
      originals[line] = earlier;
  }
  return originals;
}

}  // namespace

void tell_repairs(const LineSet& lines, const IdVector<LineId, std::uint32_t>& cut_dangles,
                  IdVector<LineId, LedgerEntry>& ledger, CleanCounts& counts) {
  const IdVector<LineId, LineId> originals = find_originals(lines);
  for (const LineId id : IdRange<LineId>(ledger.size())) {
    LedgerEntry& entry = ledger[id];
    const std::uint32_t empty = count_empty_segments(lines.lines[id]);
    counts.empty_segments += empty;
    // What has been dropped for being a point says so.
    if (empty > 0 && entry.fate != LineFate::kDropped)
      add_reason(fmt::format("{} of its segments {} no length", empty, empty == 1 ? "has" : "have"), entry);
    if (originals[id].valid()) {
      ++counts.duplicate_lines;
      add_reason(fmt::format("has the points of line {}", originals[id].value()), entry);
    }
    counts.cut_dangles += cut_dangles[id];
    if (cut_dangles[id] > 0)
      add_reason(cut_dangles[id] == 1 ? "a dangling end shorter than the shortest piece (min-edge) was cut"
                                      : "dangling ends shorter than the shortest piece (min-edge) were cut",
                 entry);
  }
}

}  // namespace quarry::linework
