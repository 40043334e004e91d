#include "kernels/cleanup/patch_lines.hpp"

#include <algorithm>

namespace quarry {
namespace {

// A side on a line inside the patch, from v to a vertex other than `back`; none if there is none.
SideId side_inside(const Mesh& mesh, const PatchStars& stars, const PatchGrowth& growth, VertexId v,
                   VertexId back) {
  SideId found;
  for_each_side_around(mesh, v, [&](SideId s) {
    if (stars.is_line(mesh, s) && mesh.target(s) != back && growth.contains(s.face()) &&
        growth.contains(mesh.neighbour(s).face()))
      found = s;
  });
  return found;
}

}  // namespace

bool PatchLines::find(const Mesh& mesh, const ConstraintTags& tags, const PatchStars& stars,
                      const PatchGrowth& growth, std::span<const VertexId> rim) {
  paths_.clear();
  for (std::uint32_t i = 0; i < rim.size(); ++i) {
    if (!stars.on_line(rim[i])) continue;
    const Support support = tags.support[rim[i]];
    VertexId before;
    VertexId v = rim[i];
    do {
      const SideId s = side_inside(mesh, stars, growth, v, before);
      if (!s.valid()) break;
      before = v;
      v = mesh.target(s);
      if (tags.support[v] != support) return false;
    } while (!growth.on_rim(v));
    if (!before.valid()) continue;  // the line does not enter
    if (!growth.on_rim(v)) return false;
    const auto end = static_cast<std::uint32_t>(std::find(rim.begin(), rim.end(), v) - rim.begin());
    if (end > i) paths_.push_back({i, end, support});
  }
  return !paths_.empty();
}

bool PatchLines::trace(const PatchLayout& layout) {
  gather(layout);
  lines_.resize(paths_.size());
  for (std::size_t i = 0; i < paths_.size(); ++i)
    if (!trace(layout, paths_[i], lines_[i])) return false;
  return true;
}

void PatchLines::gather(const PatchLayout& layout) {
  const std::span<const PatchLayout::Quad> quads = layout.quads();
  faces_.assign(layout.vertices(), 0);
  on_line_.assign(layout.vertices(), false);
  sides_.clear(4 * quads.size());
  for (std::uint32_t q = 0; q < quads.size(); ++q) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t v = quads[q][k];
      ++faces_[v];
      sides_.insert(stamped_key(VertexId(v), VertexId(quads[q][(k + 1) % 4]))).value = 4 * q + k;
    }
  }
}

bool PatchLines::trace(const PatchLayout& layout, const Path& path, PatchLine& line) {
  const std::uint32_t rim = layout.rim();
  if (faces_[path.from] != 2 || faces_[path.to] != 2) return false;
  // The side that leaves the end of the one from a to b, in the same quad.
  const auto after = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t s = *sides_.find(stamped_key(VertexId(a), VertexId(b)));
    return s - s % 4 + (s + 1) % 4;
  };
  const auto target = [&](std::uint32_t s) { return layout.quads()[s / 4][(s + 1) % 4]; };
  line.support = path.support;
  line.trace.assign(1, path.from);
  std::uint32_t v = path.from;
  std::uint32_t w = target(after((v + rim - 1) % rim, v));
  for (;;) {
    if (on_line_[v] || on_line_[w]) return false;
    on_line_[v] = true;
    line.trace.push_back(w);
    if (w < rim) break;
    if (faces_[w] != 4) return false;
    const std::uint32_t right = target(after(v, w));
    v = w;
    w = target(after(right, w));
  }
  on_line_[w] = true;
  return w == path.to;
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
