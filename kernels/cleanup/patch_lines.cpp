#include "kernels/cleanup/patch_lines.hpp"

#include <algorithm>
#include <cmath>

namespace quarry {
namespace {

constexpr std::uint32_t kByLine = 1, kByNode = 2;

}  // namespace

bool PatchLines::trace(const PatchLayout& layout, const PatchStrands& strands) {
  layout_ = &layout;
  strands_ = &strands;
  gather();
  const auto count = static_cast<std::uint32_t>(strands.strands().size());
  ways_.resize(std::max<std::size_t>(ways_.size(), count));
  strand_of_.assign(strands.stops().size(), 0);
  at_.assign(strands.stops().size(), 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const PatchStrands::Strand& strand = strands.strands()[i];
    if (!walk(strand, ways_[i])) return false;
    std::fill(strand_of_.begin() + strand.begin, strand_of_.begin() + strand.end, i);
  }
  if (!place_crossings()) return false;
  for (std::uint32_t i = 0; i < count; ++i)
    if (!place_between(i)) return false;
  return cut_at_nodes();
}

void PatchLines::gather() {
  const std::span<const PatchLayout::Quad> quads = layout_->quads();
  faces_.assign(layout_->vertices(), 0);
  taken_.assign(layout_->vertices(), 0);
  sides_.clear(4 * quads.size());
  for (std::uint32_t q = 0; q < quads.size(); ++q) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t v = quads[q][k];
      ++faces_[v];
      sides_.insert(stamped_key(VertexId(v), VertexId(quads[q][(k + 1) % 4]))).value = 4 * q + k;
    }
  }
}

// The next edge around v, counter-clockwise, after the one to w.
std::uint32_t PatchLines::turn(std::uint32_t v, std::uint32_t w) {
  const std::uint32_t s = *sides_.find(stamped_key(VertexId(v), VertexId(w)));
  return layout_->quads()[s / 4][(s + 3) % 4];
}

// Straight from the rim on: to the rim for a strand that leaves, else as far as vertices are regular.
bool PatchLines::walk(const PatchStrands::Strand& strand, Way& way) {
  const std::uint32_t rim = layout_->rim();
  const bool leaves = strand.to != PatchStrands::kNone;
  if (faces_[strand.from] != 2) return false;
  way.assign(1, strand.from);
  std::uint32_t v = strand.from;
  std::uint32_t w = turn(v, (v + 1) % rim);
  while (w >= rim && faces_[w] == 4) {
    // A way around the irregular vertex meets itself.
    if (way.size() > layout_->vertices()) return false;
    way.push_back(w);
    const std::uint32_t across = turn(w, turn(w, v));
    v = w;
    w = across;
  }
  if (leaves) way.push_back(w);
  return !leaves || (w == strand.to && faces_[w] == 2);
}

bool PatchLines::place_crossings() {
  for (const PatchStrands::Strand& strand : strands_->strands())
    if (strand.to != PatchStrands::kNone)
      at_[strand.end - 1] = static_cast<std::uint32_t>(ways_[strand_of_[strand.begin]].size() - 1);
  const auto nodes = strands_->nodes();
  return std::all_of(nodes.begin(), nodes.end(), [&](const PatchStrands::Node& node) {
    return node.second == PatchStrands::kNone || cross(node.first, node.second);
  });
}

// Where the second strand first meets the first one in the order in which they did around the node.
bool PatchLines::cross(std::uint32_t first, std::uint32_t second) {
  const Way& way = ways_[strand_of_[first]];
  const Way& other = ways_[strand_of_[second]];
  const int turns = (strands_->stops()[second].slot - strands_->stops()[first].slot + 4) % 4;
  for (std::uint32_t j = 1; j < other.size() && other[j] >= layout_->rim(); ++j) {
    const auto met = std::find(way.begin() + 1, way.end(), other[j]);
    if (met == way.end()) continue;
    std::uint32_t around = *(met - 1);
    for (int i = 0; i < turns; ++i) around = turn(*met, around);
    if (around != other[j - 1]) continue;
    at_[first] = static_cast<std::uint32_t>(met - way.begin());
    at_[second] = j;
    return true;
  }
  return false;
}

// Nodes on this strand alone, between those that have their places. A dead end keeps its distance in edges.
bool PatchLines::place_between(std::uint32_t strand) {
  const auto [from, to, begin, end] = strands_->strands()[strand];
  const std::span<const PatchStrands::Stop> stops = strands_->stops();
  std::uint32_t before = 0;
  for (std::uint32_t i = begin; i < end;) {
    std::uint32_t j = i;
    double all = stops[i].length;
    std::uint32_t edges = stops[i].edges;
    for (; at_[j] == 0 && j + 1 < end; edges += stops[j].edges) all += stops[++j].length;
    if (at_[j] == 0) at_[j] = before + edges;
    if (at_[j] >= ways_[strand].size() || at_[j] < before + (j - i + 1)) return false;
    const double step = (at_[j] - before) / all;
    const std::uint32_t start = before;
    double run = 0;
    for (; i < j; ++i) {
      run += stops[i].length;
      const std::uint32_t nearest = start + static_cast<std::uint32_t>(std::lround(step * run));
      at_[i] = before = std::clamp(nearest, before + 1, at_[j] - (j - i));
    }
    before = at_[j];
    i = j + 1;
  }
  return true;
}

bool PatchLines::take(std::uint32_t vertex, std::uint32_t by) {
  std::uint32_t& taken = taken_[vertex];
  if (taken != 0 && (taken != by || by == kByLine)) return false;
  taken = by;
  return true;
}

bool PatchLines::cut_at_nodes() {
  lines_.resize(strands_->stops().size());
  nodes_.clear();
  for (std::uint32_t i = 0; i < strands_->strands().size(); ++i) {
    const PatchStrands::Strand& strand = strands_->strands()[i];
    if (!take(ways_[i].front(), kByLine)) return false;
    for (std::uint32_t k = strand.begin, before = 0; k < strand.end; before = at_[k++]) {
      const auto way = ways_[i].begin();
      lines_[k].support = strands_->stops()[k].support;
      lines_[k].trace.assign(way + before, way + at_[k] + 1);
      for (std::uint32_t j = before + 1; j < at_[k]; ++j)
        if (!take(way[j], kByLine)) return false;
      const std::uint32_t node = strands_->stops()[k].node;
      if (!take(way[at_[k]], node == PatchStrands::kNone ? kByLine : kByNode + node)) return false;
      if (node != PatchStrands::kNone && strands_->nodes()[node].first == k)
        nodes_.push_back({strands_->nodes()[node].vertex, way[at_[k]]});
    }
  }
  return true;
}

void tag_traces(MeshEditor& editor, ConstraintTags tags, const PatchLayout& layout,
                std::span<const PatchLine> lines, std::span<const FaceId> made, StampedMap<char>& keys) {
  const auto key = [](std::uint32_t a, std::uint32_t b) { return stamped_key(VertexId(a), VertexId(b)); };
  const std::span<const PatchLayout::Quad> quads = layout.quads();
  keys.clear(4 * quads.size());
  for (const PatchLine& line : lines) {
    for (std::size_t i = 0; i + 1 < line.trace.size(); ++i) {
      keys.insert(key(line.trace[i], line.trace[i + 1]));
      keys.insert(key(line.trace[i + 1], line.trace[i]));
    }
  }
  for (std::size_t q = 0; q < quads.size(); ++q) {
    std::uint8_t bits = tags.sides[made[q]];
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t a = quads[q][k];
      const std::uint32_t b = quads[q][(k + 1) % 4];
      if (a < layout.rim() && b == (a + 1) % layout.rim()) continue;
      const auto bit = static_cast<std::uint8_t>(1U << k);
      bits = static_cast<std::uint8_t>(keys.find(key(a, b)) != nullptr ? bits | bit : bits & ~bit);
    }
    editor.set(tags.sides, made[q], bits);
  }
}

}  // namespace quarry
