#include "pipeline/section/conservation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "engine/base/error.hpp"

namespace quarry {
namespace {

[[noreturn]] void fail(const char* what, std::size_t number, const std::string& problem) {
  throw Error(ErrorKind::kBug,
              fmt::format("{} {} of the input {}; please report the input", what, number, problem));
}

// Lengths of what bears the number of each line, and of how many parts each is the sum.
struct Lengths {
  explicit Lengths(std::size_t lines) : sum(lines, 0), parts(lines, 0) {}
  void add(LineId line, double length) {
    sum[line] += length;
    ++parts[line];
  }
  IdVector<LineId, double> sum;
  IdVector<LineId, std::uint32_t> parts;
};

Lengths lengths_of_pieces(const CleanedLines& cleaned) {
  Lengths lengths(cleaned.ledger.size());
  for (const PieceId id : IdRange<PieceId>(cleaned.lines.pieces.size())) {
    const Piece& piece = cleaned.lines.pieces[id];
    const double length = distance(cleaned.lines.nodes[piece.from], cleaned.lines.nodes[piece.to]);
    for (const LineId line : cleaned.lines.numbers(id)) lengths.add(line, length);
  }
  return lengths;
}

}  // namespace

void require_all_told(const LineSet& lines, const CleanedLines& cleaned) {
  if (cleaned.ledger.size() != lines.lines.size() || cleaned.points.size() != lines.points.size())
    throw Error(ErrorKind::kBug, fmt::format("{} lines and {} points were read, but {} and {} are accounted "
                                             "for; please report the input",
                                             lines.lines.size(), lines.points.size(), cleaned.ledger.size(),
                                             cleaned.points.size()));
  const Lengths lengths = lengths_of_pieces(cleaned);
  for (const LineId line : IdRange<LineId>(cleaned.ledger.size())) {
    const LedgerEntry& entry = cleaned.ledger[line];
    const bool dropped = entry.fate == LineFate::kDropped;
    if (dropped && lengths.parts[line] > 0) fail("line", line.value(), "is called dropped, but has pieces");
    if (!dropped && lengths.parts[line] == 0) fail("line", line.value(), "has no piece and is not told");
    if (entry.fate != LineFate::kKept && entry.why.empty())
      fail("line", line.value(), fmt::format("is {} without a reason", name_of(entry.fate)));
  }
  for (const PointId point : IdRange<PointId>(cleaned.points.size()))
    if (!cleaned.points[point].node.valid() && cleaned.points[point].why.empty())
      fail("point", point.value(), "is dropped without a reason");
}

void require_lines_kept(const Mesh& mesh, const CleanedLines& cleaned) {
  const Lengths wanted = lengths_of_pieces(cleaned);
  const auto constraint = mesh.find_tag<EdgeId, std::int32_t>("constraint");
  Lengths found(cleaned.ledger.size());
  for (const EdgeId e : IdRange<EdgeId>(mesh.edge_slots())) {
    const auto [a, b] = mesh.edge_ends(e);
    if (constraint[e] >= 0)
      found.add(LineId(static_cast<std::uint32_t>(constraint[e])), distance(mesh.point(a), mesh.point(b)));
  }
  // Vertices on pieces are rounded to the grid of doubles.
  const Box2 box = mesh.box();
  const double largest =
      std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  const double ulp = std::numeric_limits<double>::epsilon() * largest;
  for (const LineId line : IdRange<LineId>(cleaned.ledger.size())) {
    const double slack = 1e-12 * wanted.sum[line] + 4 * ulp * (wanted.parts[line] + found.parts[line]);
    if (std::abs(found.sum[line] - wanted.sum[line]) > slack)
      fail("line", line.value(),
           fmt::format("has edges of length {} on pieces of length {}", found.sum[line], wanted.sum[line]));
  }
}

}  // namespace quarry
