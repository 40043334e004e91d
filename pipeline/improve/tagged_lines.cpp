#include "pipeline/improve/tagged_lines.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "engine/geometry/straight_runs.hpp"
#include "engine/mesh/build.hpp"
#include "engine/mesh/domain.hpp"
#include "engine/mesh/pinch.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/mesh_file.hpp"
#include "pipeline/improve/side_chains.hpp"

namespace quarry {
namespace {

using Meaning = TaggedLines::Meaning;

// A constrained side of the mesh, seen from the face of smaller side number.
struct BoundSide {
  SideId side;
  Meaning meaning;
};

std::uint64_t key_of(VertexId a, VertexId b) {
  const auto [low, high] = std::minmax(a, b);
  return (std::uint64_t{low.value()} << 32) | high.value();
}

class LineFinder {
 public:
  LineFinder(Mesh& mesh, std::vector<TaggedEdge> tagged, double tolerance)
      : mesh_(mesh),
        region_(mesh.find_tag<FaceId, std::int32_t>("region")),
        point_(mesh.find_tag<VertexId, std::int32_t>(kPointTag)),
        tolerance_(tolerance),
        tagged_(std::move(tagged)) {}

  TaggedLines run() {
    sort_tagged();
    find_sides();
    find_ends();
    make_pieces();
    bind();
    return std::move(result_);
  }

 private:
  void sort_tagged() {
    const auto order = [](const TaggedEdge& e) { return std::pair(key_of(e.a, e.b), e.number); };
    std::sort(tagged_.begin(), tagged_.end(),
              [&](const TaggedEdge& e, const TaggedEdge& f) { return order(e) < order(f); });
    tagged_.erase(std::unique(tagged_.begin(), tagged_.end(),
                              [&](const TaggedEdge& e, const TaggedEdge& f) { return order(e) == order(f); }),
                  tagged_.end());
    for (const TaggedEdge& edge : tagged_) result_.numbers.push_back(edge.number);
  }

  // The range of an edge's numbers, empty if it is not tagged.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> numbers_of(SideId s) const {
    const std::uint64_t key = key_of(mesh_.origin(s), mesh_.target(s));
    const auto begin =
        std::lower_bound(tagged_.begin(), tagged_.end(), key,
                         [](const TaggedEdge& e, std::uint64_t k) { return key_of(e.a, e.b) < k; });
    auto end = begin;
    while (end != tagged_.end() && key_of(end->a, end->b) == key) ++end;
    return {static_cast<std::uint32_t>(begin - tagged_.begin()),
            static_cast<std::uint32_t>(end - tagged_.begin())};
  }

  [[nodiscard]] bool is_bound(SideId s) const {
    if (!mesh_.origin(s).valid()) return false;
    const SideId t = mesh_.neighbour(s);
    if (!t.valid()) return true;
    if (t < s) return false;
    if (region_[s.face()] != region_[t.face()]) return true;
    const auto [begin, end] = numbers_of(s);
    return begin != end;
  }

  void find_sides() {
    std::vector<bool> met(tagged_.size(), false);
    for (const std::uint32_t i : parallel::filter_indices(4 * mesh_.face_slots(), [&](std::size_t s) {
           return is_bound(SideId(static_cast<std::uint32_t>(s)));
         })) {
      const SideId s(i);
      const SideId t = mesh_.neighbour(s);
      auto [begin, end] = numbers_of(s);
      std::fill(met.begin() + begin, met.begin() + end, true);
      // A boundary is one without an unnumbered edge on it as well.
      if (!t.valid() && end != begin && result_.numbers[begin] == -1) ++begin;
      sides_.push_back(
          {s, {begin, end, region_[s.face()], t.valid() ? region_[t.face()] : TaggedLines::kNoRegion}});
    }
    auto constraint = mesh_.add_tag<EdgeId, std::int32_t>("constraint", -1);
    for (std::size_t i = 0; i < tagged_.size(); ++i)
      if (!met[i]) constraint[mesh_.add_edge(tagged_[i].a, tagged_[i].b)] = tagged_[i].number;
    result_.apart = mesh_.edge_slots();
  }

  // Index of a bound side and which of its ends is meant, by vertex.
  void find_ends() {
    begin_.assign(mesh_.vertex_slots() + 1, 0);
    for (const BoundSide& s : sides_)
      for (const VertexId v : {mesh_.origin(s.side), mesh_.target(s.side)}) ++begin_[v.value()];
    parallel::exclusive_scan(std::span(begin_));
    ends_.resize(begin_.back());
    std::vector<std::uint32_t> at(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t i = 0; i < sides_.size(); ++i)
      for (const VertexId v : {mesh_.origin(sides_[i].side), mesh_.target(sides_[i].side)})
        ends_[at[v.value()]++] = i;
    node_.assign(mesh_.vertex_slots(), NodeKind::kNone);
    for (const VertexId v : mesh_.vertices()) {
      const std::uint32_t count = begin_[v.value() + 1] - begin_[v.value()];
      if (count != 0 && (count != 2 || !goes_on(v))) node_[v.value()] = NodeKind::kNode;
    }
    for (const EdgeId e : mesh_.edges())
      for (const VertexId v : {mesh_.edge_ends(e).first, mesh_.edge_ends(e).second})
        node_[v.value()] = NodeKind::kNode;
    if (!point_.valid()) return;
    for (const VertexId v : mesh_.vertices())
      if (point_[v] >= 0) node_[v.value()] = NodeKind::kNode;
  }

  // What a side means to one who walks away from v along it.
  [[nodiscard]] Meaning meaning_from(VertexId v, const BoundSide& s) const {
    Meaning meaning = s.meaning;
    if (mesh_.origin(s.side) != v) std::swap(meaning.left, meaning.right);
    return meaning;
  }

  [[nodiscard]] bool same_meaning(const Meaning& a, const Meaning& b) const {
    const auto span_of = [&](const Meaning& m) {
      return std::span(result_.numbers).subspan(m.number_begin, m.number_end - m.number_begin);
    };
    return a.left == b.left && a.right == b.right &&
           std::equal(span_of(a).begin(), span_of(a).end(), span_of(b).begin(), span_of(b).end());
  }

  // Two sides meet at v and mean the same.
  [[nodiscard]] bool goes_on(VertexId v) const {
    const std::uint32_t at = begin_[v.value()];
    Meaning back = meaning_from(v, sides_[ends_[at]]);
    std::swap(back.left, back.right);
    return same_meaning(back, meaning_from(v, sides_[ends_[at + 1]]));
  }

  [[nodiscard]] VertexId other_end(VertexId v, std::uint32_t side) const {
    const SideId s = sides_[side].side;
    return mesh_.origin(s) == v ? mesh_.target(s) : mesh_.origin(s);
  }

  // Follows a line from a node to the next, or around to the vertex where it began.
  void follow(VertexId first, std::uint32_t side) {
    chain_.assign(1, first);
    const Meaning meaning = meaning_from(first, sides_[side]);
    for (VertexId v = first;;) {
      seen_[side] = true;
      v = other_end(v, side);
      chain_.push_back(v);
      if (node_[v.value()] == NodeKind::kNode || v == first) break;
      const std::uint32_t at = begin_[v.value()];
      side = ends_[at] == side ? ends_[at + 1] : ends_[at];
    }
    add_chain(meaning);
  }

  [[nodiscard]] std::vector<std::uint32_t> bends_of_chain() {
    points_.clear();
    for (const VertexId v : chain_) points_.push_back(mesh_.point(v));
    return find_bends(points_, tolerance_);
  }

  void add_chain(const Meaning& meaning) {
    std::vector<std::uint32_t> bends = bends_of_chain();
    if (chain_.front() == chain_.back() && node_[chain_.front().value()] == NodeKind::kNone) {
      // A ring may begin at one of its bends as well as in the middle of a straight run.
      chain_.pop_back();
      std::rotate(chain_.begin(), chain_.begin() + bends[1], chain_.end());
      chain_.push_back(chain_.front());
      bends = bends_of_chain();
    }
    for (std::size_t i = 0; i + 1 < bends.size(); ++i) runs_.push_back({meaning, {}});
    for (std::size_t i = 0; i + 1 < bends.size(); ++i)
      runs_[runs_.size() + i - (bends.size() - 1)].vertices.assign(chain_.begin() + bends[i],
                                                                   chain_.begin() + bends[i + 1] + 1);
  }

  struct Run {
    Meaning meaning;
    std::vector<VertexId> vertices;  // from node to node
  };

  [[nodiscard]] static std::uint64_t ends_key(const Run& run) {
    return key_of(run.vertices.front(), run.vertices.back());
  }

  // Runs that join the same two nodes would be one piece: all but the shortest are cut at all their vertices.
  void part_twins() {
    std::stable_sort(runs_.begin(), runs_.end(), [](const Run& a, const Run& b) {
      return std::pair(ends_key(a), a.vertices.size()) < std::pair(ends_key(b), b.vertices.size());
    });
    const std::size_t count = runs_.size();
    for (std::size_t i = 1; i < count; ++i) {
      if (ends_key(runs_[i]) != ends_key(runs_[i - 1]) || runs_[i].vertices.size() < 3) continue;
      const std::vector<VertexId> vertices = runs_[i].vertices;
      for (std::size_t k = 1; k + 1 < vertices.size(); ++k)
        runs_.push_back({runs_[i].meaning, {vertices[k], vertices[k + 1]}});
      twins_.push_back(i);
    }
    for (const std::size_t i : twins_) runs_[i].vertices.resize(2);
  }

  void make_pieces() {
    seen_.assign(sides_.size(), false);
    for (const VertexId v : mesh_.vertices()) {
      if (node_[v.value()] != NodeKind::kNode) continue;
      for (std::uint32_t i = begin_[v.value()]; i < begin_[v.value() + 1]; ++i)
        if (!seen_[ends_[i]]) follow(v, ends_[i]);
    }
    for (std::uint32_t i = 0; i < sides_.size(); ++i)
      if (!seen_[i]) follow(mesh_.origin(sides_[i].side), i);
    part_twins();
    for (const Run& run : runs_)
      for (const VertexId v : {run.vertices.front(), run.vertices.back()}) node_[v.value()] = NodeKind::kNode;
    node_of_.assign(mesh_.vertex_slots(), NodeId());
    for (const VertexId v : mesh_.vertices()) {
      if (node_[v.value()] != NodeKind::kNode) continue;
      node_of_[v.value()] = result_.lines.nodes.push_back(mesh_.point(v));
      if (point_.valid()) result_.points.push_back(point_[v]);
    }
    for (Run& run : runs_) {
      if (run.vertices.back() < run.vertices.front()) {
        std::reverse(run.vertices.begin(), run.vertices.end());
        std::swap(run.meaning.left, run.meaning.right);
      }
    }
    std::sort(runs_.begin(), runs_.end(), [](const Run& a, const Run& b) {
      return std::pair(a.vertices.front(), a.vertices.back()) <
             std::pair(b.vertices.front(), b.vertices.back());
    });
    for (const Run& run : runs_) add_piece(run);
    result_.lines.line_begin.push_back(static_cast<std::uint32_t>(result_.lines.line_numbers.size()));
  }

  void add_piece(const Run& run) {
    NodedLines& lines = result_.lines;
    const bool outline =
        run.meaning.left == TaggedLines::kNoRegion || run.meaning.right == TaggedLines::kNoRegion;
    lines.line_begin.push_back(static_cast<std::uint32_t>(lines.line_numbers.size()));
    for (std::uint32_t i = run.meaning.number_begin; i < run.meaning.number_end; ++i)
      if (result_.numbers[i] >= 0)
        lines.line_numbers.emplace_back(static_cast<std::uint32_t>(result_.numbers[i]));
    lines.pieces.push_back({node_of_[run.vertices.front().value()], node_of_[run.vertices.back().value()],
                            outline ? PieceKindOf::kOutline : PieceKindOf::kInterior});
    result_.meanings.push_back(run.meaning);
  }

  void bind() {
    ConstraintTags tags = ConstraintTags::add_to(mesh_);
    for (std::size_t p = 0; p < runs_.size(); ++p)
      for (const VertexId v : runs_[p].vertices) tags.support[v] = Support::on(PieceId(p));
    for (const VertexId v : mesh_.vertices())
      if (node_of_[v.value()].valid()) tags.support[v] = Support::at(node_of_[v.value()]);
    for (const BoundSide& bound : sides_) {
      tags.set_constrained(bound.side, true);
      if (const SideId t = mesh_.neighbour(bound.side); t.valid()) tags.set_constrained(t, true);
    }
    split_pinches(mesh_, tags);
  }

  enum class NodeKind : std::uint8_t { kNone, kNode };

  Mesh& mesh_;
  Tag<FaceId, std::int32_t> region_;
  Tag<VertexId, std::int32_t> point_;
  double tolerance_;
  std::vector<TaggedEdge> tagged_;  // sorted by ends, then number
  std::vector<BoundSide> sides_;
  std::vector<std::uint32_t> begin_, ends_;  // bound sides by vertex, in rows
  std::vector<NodeKind> node_;               // by vertex
  std::vector<NodeId> node_of_;              // by vertex
  std::vector<bool> seen_;                   // by bound side
  std::vector<VertexId> chain_;
  std::vector<Vec2> points_;
  std::vector<Run> runs_;
  std::vector<std::size_t> twins_;
  TaggedLines result_;
};

// The piece under a constrained side, and whether the side runs along it from `from` to `to`.
struct PieceUnder {
  PieceId piece;
  bool forward;
};

PieceUnder piece_under(const Mesh& mesh, ConstraintTags tags, const PieceFinder& finder,
                       const NodedLines& lines, SideId s) {
  const VertexId a = mesh.origin(s);
  const VertexId b = mesh.target(s);
  const PieceId id = finder.under_edge(tags.support[a], tags.support[b]);
  const Piece& piece = lines.pieces[id];
  return {id, dot(mesh.point(b) - mesh.point(a), lines.nodes[piece.to] - lines.nodes[piece.from]) > 0};
}

}  // namespace

TaggedLines bind_lines(Mesh& mesh, const std::vector<TaggedEdge>& tagged, double tolerance) {
  rebuild_sides_of_vertices(mesh);
  return LineFinder(mesh, follow_sides(mesh, tagged, tolerance), tolerance).run();
}

namespace {

class GroupRestorer {
 public:
  GroupRestorer(Mesh& mesh, const TaggedLines& lines)
      : mesh_(mesh), lines_(lines), tags_(ConstraintTags::of(mesh)), finder_(lines.lines) {}

  void run() {
    const std::int32_t count = label_regions(mesh_, tags_);
    region_ = mesh_.find_tag<FaceId, std::int32_t>("region");
    number_.assign(static_cast<std::size_t>(count), TaggedLines::kNoRegion);
    constraint_ = mesh_.find_tag<EdgeId, std::int32_t>("constraint");
    kind_ = mesh_.add_tag<EdgeId, std::int32_t>("kind", kKindInterior);
    const auto sides = parallel::filter_indices(4 * mesh_.face_slots(), [&](std::size_t i) {
      const SideId s(static_cast<std::uint32_t>(i));
      return mesh_.alive(s.face()) && mesh_.origin(s).valid() && tags_.constrained(s);
    });
    for (const std::uint32_t s : sides) visit(SideId(s));
    for (const FaceId f : mesh_.faces())
      if (mesh_.alive(f)) region_[f] = number_[static_cast<std::size_t>(region_[f])];
    mark_pinches(mesh_, tags_);
    restore_points();
  }

 private:
  // Clean-up may have left another vertex at the node.
  void restore_points() {
    if (lines_.points.empty()) return;
    auto point = mesh_.find_tag<VertexId, std::int32_t>(kPointTag);
    for (const VertexId v : mesh_.vertices()) {
      const Support support = tags_.support[v];
      point[v] = mesh_.alive(v) && support.is_node() ? lines_.points[support.node().value()] : -1;
    }
  }

  void visit(SideId s) {
    const auto [piece, forward] = piece_under(mesh_, tags_, finder_, lines_.lines, s);
    const TaggedLines::Meaning& meaning = lines_.meanings[piece.value()];
    std::int32_t& number = number_[static_cast<std::size_t>(region_[s.face()])];
    if (number == TaggedLines::kNoRegion) number = forward ? meaning.left : meaning.right;
    const SideId t = mesh_.neighbour(s);
    if (t.valid() && t < s) return;
    const std::span<const std::int32_t> numbers = lines_.numbers_of(piece);
    for (const std::int32_t n : numbers) add_edge(s, n);
    if (numbers.empty() && !t.valid()) add_edge(s, -1);
  }

  void add_edge(SideId s, std::int32_t number) {
    const EdgeId e = mesh_.add_edge(mesh_.origin(s), mesh_.target(s));
    constraint_[e] = number;
    kind_[e] = mesh_.neighbour(s).valid() ? kKindInterior : kKindBoundary;
  }

  Mesh& mesh_;
  const TaggedLines& lines_;
  ConstraintTags tags_;
  PieceFinder finder_;
  Tag<FaceId, std::int32_t> region_;
  Tag<EdgeId, std::int32_t> constraint_, kind_;
  std::vector<std::int32_t> number_;  // of the input's region, by label
};

}  // namespace

void restore_groups(Mesh& mesh, const TaggedLines& lines) { GroupRestorer(mesh, lines).run(); }

}  // namespace quarry
