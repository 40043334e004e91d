#include "engine/mesh/sectors.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <span>
#include <utility>
#include <vector>

#include "engine/mesh/build.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"

namespace quarry {
namespace {

bool is_side(const Mesh& mesh, SideId s) {
  return mesh.alive(s.face()) && s.index() < mesh.corner_count(s.face());
}

template <class Visit>
void for_each_side(const Mesh& mesh, Visit&& visit) {
  parallel::for_each(4 * mesh.face_slots(), [&](std::size_t i) {
    const SideId s(static_cast<std::uint32_t>(i));
    if (is_side(mesh, s)) visit(s);
  });
}

// The sectors of all vertices on constraints or on the boundary, one after the other for each vertex. A
// sector is named by its most clockwise side: a constraint or the boundary runs along it.
struct Sectors {
  std::vector<std::uint64_t> vertices;
  std::vector<std::uint32_t> first_sides;

  Sectors(const Mesh& mesh, const ConstraintTags& tags)
      : first_sides(parallel::filter_indices(4 * mesh.face_slots(), [&](std::size_t i) {
          const SideId s(static_cast<std::uint32_t>(i));
          return is_side(mesh, s) && (tags.constrained(s) || !mesh.neighbour(s).valid());
        })) {
    vertices.resize(first_sides.size());
    parallel::for_each(vertices.size(),
                       [&](std::size_t i) { vertices[i] = mesh.origin(SideId(first_sides[i])).value(); });
    parallel::stable_sort_by_key(vertices, first_sides);
  }

  [[nodiscard]] std::size_t size() const { return vertices.size(); }
  [[nodiscard]] VertexId vertex(std::size_t i) const { return VertexId(vertices[i]); }
  [[nodiscard]] SideId first_side(std::size_t i) const { return SideId(first_sides[i]); }
  // Not the first sector of its vertex.
  [[nodiscard]] bool is_extra(std::size_t i) const { return i > 0 && vertices[i - 1] == vertices[i]; }
  [[nodiscard]] bool has_next(std::size_t i) const {
    return i + 1 < vertices.size() && vertices[i] == vertices[i + 1];
  }
};

// The sides of a sector, counter-clockwise from its most clockwise one.
template <class Visit>
void for_each_side_of_sector(const Mesh& mesh, const ConstraintTags& tags, SideId first, Visit&& visit) {
  for (SideId s = first;;) {
    visit(s);
    const SideId last = mesh.previous(s);
    if (tags.constrained(last) || !mesh.neighbour(last).valid()) return;
    s = mesh.neighbour(last);
  }
}

// Gives the sides of the extra sectors their copies as origins. Sides are gathered before any is written:
// turning around a vertex reads other corners of the faces.
void place_copies(Mesh& mesh, const ConstraintTags& tags, const Sectors& sectors,
                  const std::vector<std::uint32_t>& extra, VertexId first_copy) {
  std::vector<std::uint32_t> begin(extra.size() + 1, 0);
  parallel::for_each(extra.size(), [&](std::size_t j) {
    for_each_side_of_sector(mesh, tags, sectors.first_side(extra[j]), [&](SideId) { ++begin[j]; });
  });
  std::vector<SideId> sides(parallel::exclusive_scan(std::span(begin)));
  parallel::for_each(extra.size(), [&](std::size_t j) {
    std::size_t at = begin[j];
    for_each_side_of_sector(mesh, tags, sectors.first_side(extra[j]), [&](SideId s) { sides[at++] = s; });
  });
  parallel::for_each(extra.size(), [&](std::size_t j) {
    for (std::size_t i = begin[j]; i < begin[j + 1]; ++i)
      mesh.set_corner(sides[i], VertexId(first_copy.value() + j));
  });
}

// Joins boundary sides over the same two whole vertices, of those for which wanted(SideId) holds.
template <class Wanted>
void join_cut_sides(Mesh& mesh, const ConstraintTags& tags, const Tag<VertexId, VertexId>& whole,
                    const Wanted& wanted) {
  auto sides = parallel::filter_indices(4 * mesh.face_slots(), [&](std::size_t i) {
    const SideId s(static_cast<std::uint32_t>(i));
    return is_side(mesh, s) && tags.constrained(s) && !mesh.neighbour(s).valid() && wanted(s);
  });
  std::vector<std::uint64_t> keys(sides.size());
  parallel::for_each(keys.size(), [&](std::size_t i) {
    const SideId s(sides[i]);
    const std::uint32_t a = whole_of(whole, mesh.origin(s)).value();
    const std::uint32_t b = whole_of(whole, mesh.target(s)).value();
    keys[i] = (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
  });
  parallel::stable_sort_by_key(keys, sides);
  parallel::for_each(keys.size(), [&](std::size_t i) {
    if (i == 0 || keys[i - 1] != keys[i]) return;
    assert(i < 2 || keys[i - 2] != keys[i]);
    assert(whole_of(whole, mesh.origin(SideId(sides[i]))) ==
           whole_of(whole, mesh.target(SideId(sides[i - 1]))));
    mesh.set_neighbour(SideId(sides[i - 1]), SideId(sides[i]));
    mesh.set_neighbour(SideId(sides[i]), SideId(sides[i - 1]));
  });
}

}  // namespace

void cut_open(Mesh& mesh, ConstraintTags tags) {
  const Sectors sectors(mesh, tags);
  const auto extra =
      parallel::filter_indices(sectors.size(), [&](std::size_t i) { return sectors.is_extra(i); });
  const VertexId first_copy = mesh.grow_vertices(extra.size());
  auto whole = mesh.add_tag<VertexId, VertexId>(kWholeTag);
  place_copies(mesh, tags, sectors, extra, first_copy);
  for_each_side(mesh, [&](SideId s) {
    if (tags.constrained(s)) mesh.set_neighbour(s, SideId());
  });
  parallel::for_each(extra.size(), [&](std::size_t j) {
    const VertexId copy(first_copy.value() + j);
    const VertexId v = sectors.vertex(extra[j]);
    copy_point(mesh, v, mesh, copy);
    tags.support[copy] = tags.support[v];
    whole[copy] = v;
    mesh.set_side_of(copy, sectors.first_side(extra[j]));
  });
  parallel::for_each(sectors.size(), [&](std::size_t i) {
    if (sectors.is_extra(i)) return;
    const VertexId v = sectors.vertex(i);
    mesh.set_side_of(v, sectors.first_side(i));
    if (sectors.has_next(i)) whole[v] = v;
  });
}

void sew_pieces(Mesh& mesh, ConstraintTags tags, std::span<const std::uint8_t> nodes) {
  auto whole = mesh.find_tag<VertexId, VertexId>(kWholeTag);
  assert(whole.valid());
  const auto joins = [&](VertexId v) {
    return std::as_const(tags.support)[v].slides() || nodes[whole_of(whole, v).value()] != 0;
  };
  join_cut_sides(mesh, tags, whole, [&](SideId s) { return joins(mesh.origin(s)) && joins(mesh.target(s)); });
  std::vector<std::uint8_t> joined(mesh.vertex_slots(), 0);
  for_each_side(mesh, [&](SideId s) {
    if (!tags.constrained(s) || !mesh.neighbour(s).valid()) return;
    for (const VertexId v : {mesh.origin(s), mesh.target(s)})
      std::atomic_ref(joined[whole_of(whole, v).value()]).store(1, std::memory_order_relaxed);
  });
  for_each_side(mesh, [&](SideId s) {
    const VertexId v = whole_of(whole, mesh.origin(s));
    if (joined[v.value()] != 0) mesh.set_corner(s, v);
  });
  parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (joined[whole_of(whole, v).value()] != 0) whole[v] = VertexId();
  });
  rebuild_sides_of_vertices(mesh);
}

void sew(Mesh& mesh, ConstraintTags tags) {
  const auto whole = mesh.find_tag<VertexId, VertexId>(kWholeTag);
  assert(whole.valid());
  join_cut_sides(mesh, tags, whole, [](SideId) { return true; });
  parallel::for_each(4 * mesh.face_slots(), [&](std::size_t i) {
    const SideId s(static_cast<std::uint32_t>(i));
    if (!mesh.alive(s.face()) || !mesh.origin(s).valid()) return;
    const VertexId v = std::as_const(whole)[mesh.origin(s)];
    if (v.valid()) mesh.set_corner(s, v);
  });
  mesh.remove_tag<VertexId>(kWholeTag);
  rebuild_sides_of_vertices(mesh);
}

}  // namespace quarry
