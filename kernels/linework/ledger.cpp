#include "kernels/linework/ledger.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/parallel/parallel.hpp"
#include "kernels/linework/raw_stretch.hpp"

namespace quarry::linework {
namespace {

void sort_unique(std::vector<LineId>& lines) {
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
}

// Adds the lines other than `line` among those at a place, or the first of them where they are very many:
// with all of them, lines that lie on one course or meet in one node would take memory by their square.
void add_others(std::span<const LineId> there, LineId line, std::vector<LineId>& result) {
  const std::span<const LineId> told = there.first(std::min(there.size(), kMostToldAtOnePlace));
  std::copy_if(told.begin(), told.end(), std::back_inserter(result), [&](LineId id) { return id != line; });
}

struct Meetings {
  std::vector<LineId> along;    // lines that share pieces
  std::vector<LineId> onto;     // lines that an end was moved onto
  std::vector<LineId> between;  // lines met between the ends
  std::vector<LineId> at_ends;  // lines met at the ends, where they met before
};

std::string text_of(const std::vector<LineId>& lines) {
  std::vector<std::uint32_t> numbers;
  for (const LineId line : lines) numbers.push_back(line.value());
  constexpr std::size_t kShown = 8;
  const std::size_t shown = std::min(kShown, numbers.size());
  std::string text = fmt::format(
      "{}", fmt::join(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
  if (numbers.size() > shown) text += fmt::format(" and {} more", numbers.size() - shown);
  return text;
}

// Calls visit(path number, line) for each path with edges that stands for an input line.
template <class Visit>
void for_each_line_path(const PathNetwork& network, Visit&& visit) {
  for (std::size_t p = 0; p < network.paths.size(); ++p) {
    const LineId line = network.raw[network.paths[p].raw].line;
    if (line.valid() && network.paths[p].steps.size() > 1) visit(p, line);
  }
}

LinesAt lines_at_nodes(const PathNetwork& network) {
  std::vector<std::pair<std::uint32_t, LineId>> pairs;
  for_each_line_path(network, [&](std::size_t p, LineId line) {
    for (const PathStep& step : network.paths[p].steps) pairs.emplace_back(step.node.value(), line);
  });
  return {network.nodes.size(), pairs};
}

class LedgerMaker {
 public:
  LedgerMaker(const LineSet& lines, const PathNetwork& network)
      : lines_(lines),
        network_(network),
        at_node_(lines_at_nodes(network)),
        on_edge_(lines_on_edges(network)) {}

  IdVector<LineId, LedgerEntry> run(const std::vector<double>& clipped, const Reasons& reasons) {
    IdVector<LineId, LedgerEntry> ledger(lines_.lines.size());
    for (std::size_t r = 0; r < network_.raw.size(); ++r)
      if (network_.raw[r].line.valid()) ledger[network_.raw[r].line].clipped_length += clipped[r];
    IdVector<LineId, std::uint8_t> alive(lines_.lines.size());
    for_each_line_path(network_, [&](std::size_t, LineId line) { alive[line] = 1; });
    const std::vector<std::size_t> begin = paths_of_raw_lines();
    parallel::for_each(
        begin.size() - 1,
        [&](std::size_t i) {
          const LineId line = network_.raw[network_.paths[begin[i]].raw].line;
          if (!line.valid() || alive[line] == 0) return;
          Meetings meetings;
          follow_line(begin[i], begin[i + 1], meetings, ledger[line]);
          judge(meetings, ledger[line]);
        },
        kLinesPerChunk);
    for (const LineId line : IdRange<LineId>(ledger.size())) {
      if (alive[line] != 0) continue;
      ledger[line].fate = LineFate::kDropped;
      ledger[line].why = reasons[line];
    }
    return ledger;
  }

 private:
  static constexpr std::size_t kLinesPerChunk = 256;

  // Where the paths of each raw line that has any begin, and the end of the last.
  [[nodiscard]] std::vector<std::size_t> paths_of_raw_lines() const {
    std::vector<std::size_t> begin;
    for (std::size_t p = 0; p < network_.paths.size(); ++p)
      if (p == 0 || network_.paths[p].raw != network_.paths[p - 1].raw) begin.push_back(p);
    begin.push_back(network_.paths.size());
    return begin;
  }

  // Paths [begin, end) are those of one raw line, in its order. Clipping cuts a line into several where it
  // passes from the outline into the domain or leaves that; the ends of the line are those of them all
  // together, and where one path ends and the next begins is between the ends.
  void follow_line(std::size_t begin, std::size_t end, Meetings& meetings, LedgerEntry& entry) const {
    const LineId line = network_.raw[network_.paths[begin].raw].line;
    const auto has_edges = [&](std::size_t p) { return network_.paths[p].steps.size() > 1; };
    while (begin < end && !has_edges(begin)) ++begin;
    while (begin < end && !has_edges(end - 1)) --end;
    const NodeId first = network_.paths[begin].steps.front().node;
    const NodeId last = network_.paths[end - 1].steps.back().node;
    for (std::size_t p = begin; p < end; ++p) {
      if (!has_edges(p)) continue;
      follow_pieces(p, line, meetings, entry);
      follow_nodes(p, line, first != last && p == begin, first != last && p + 1 == end, meetings);
    }
  }

  void follow_pieces(std::size_t p, LineId line, Meetings& meetings, LedgerEntry& entry) const {
    const Path& path = network_.paths[p];
    const std::span<const Vec2> raw = network_.raw[path.raw].points;
    for (std::size_t i = 0; i + 1 < path.steps.size(); ++i) {
      add_others(on_edge_.at(network_.edge_of_step[network_.edge_begin[p] + i]), line, meetings.along);
      const PathStep& from = path.steps[i];
      const PathStep& to = path.steps[i + 1];
      const Vec2 a = network_.nodes[from.node];
      const double moved = deviation(raw, from.at, to.at, a, network_.nodes[to.node]);
      if (moved > entry.moved) {
        entry.moved = moved;
        entry.moved_at = a;
      }
    }
  }

  // starts, ends: the path begins where its line begins, ends where that ends.
  void follow_nodes(std::size_t p, LineId line, bool starts, bool ends, Meetings& meetings) const {
    const Path& path = network_.paths[p];
    const std::span<const Vec2> raw = network_.raw[path.raw].points;
    const std::size_t last = path.steps.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      const bool end = (starts && i == 0) || (ends && i == last);
      const Vec2 p_now = network_.nodes[path.steps[i].node];
      const bool moved = !(raw_point(raw, path.steps[i].at) == p_now);
      add_others(at_node_.at(path.steps[i].node.value()), line,
                 !end ? meetings.between : (moved ? meetings.onto : meetings.at_ends));
    }
  }

  static void judge(Meetings& meetings, LedgerEntry& entry) {
    for (std::vector<LineId>* group :
         {&meetings.along, &meetings.onto, &meetings.between, &meetings.at_ends}) {
      sort_unique(*group);
      entry.with.insert(entry.with.end(), group->begin(), group->end());
    }
    sort_unique(entry.with);
    if (!meetings.along.empty()) {
      entry.fate = LineFate::kJoined;
      entry.why = "runs along line " + text_of(meetings.along);
    } else if (!meetings.onto.empty()) {
      entry.fate = LineFate::kJoined;
      entry.why = "an end was joined to line " + text_of(meetings.onto);
    } else if (!meetings.between.empty()) {
      entry.fate = LineFate::kSplit;
      entry.why = "meets line " + text_of(meetings.between);
    }
    if (entry.clipped_length > 0) {
      entry.fate = LineFate::kClipped;
      const std::string more = entry.why.empty() ? "" : "; " + entry.why;
      entry.why = fmt::format("a length of {:.6g} lies outside the outline{}", entry.clipped_length, more);
    }
  }

  const LineSet& lines_;
  const PathNetwork& network_;
  LinesAt at_node_;
  LinesAt on_edge_;
};

}  // namespace

LinesAt lines_on_edges(const PathNetwork& network) {
  std::vector<std::pair<std::uint32_t, LineId>> pairs;
  for_each_line_path(network, [&](std::size_t p, LineId line) {
    for (std::size_t i = network.edge_begin[p]; i < network.edge_begin[p + 1]; ++i)
      pairs.emplace_back(network.edge_of_step[i], line);
  });
  return {network.edges.size(), pairs};
}

void note_lost_lines(const PathNetwork& network, const std::string& why, Reasons& reasons) {
  IdVector<LineId, std::uint8_t> alive(reasons.size());
  for (const Path& path : network.paths) {
    const LineId line = network.raw[path.raw].line;
    if (line.valid() && path.steps.size() > 1) alive[line] = 1;
  }
  for (const LineId line : IdRange<LineId>(reasons.size()))
    if (alive[line] == 0 && reasons[line].empty()) reasons[line] = why;
}

IdVector<LineId, LedgerEntry> make_ledger(const LineSet& lines, const PathNetwork& network,
                                          const std::vector<double>& clipped, const Reasons& reasons) {
  return LedgerMaker(lines, network).run(clipped, reasons);
}

}  // namespace quarry::linework

namespace quarry {

const char* name_of(LineFate fate) {
  switch (fate) {
    case LineFate::kDropped:
      return "dropped";
    case LineFate::kClipped:
      return "clipped";
    case LineFate::kJoined:
      return "joined";
    case LineFate::kSplit:
      return "split";
    case LineFate::kKept:
      break;
  }
  return "kept";
}

}  // namespace quarry
