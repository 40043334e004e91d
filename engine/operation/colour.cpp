#include "engine/operation/colour.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>

#include <bitset>

#include "engine/base/random.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

constexpr std::size_t kStarChunk = 512;

// Calls visit(VertexId) for each vertex that shares a face with v, some of them twice.
template <class Visit>
void for_each_face_mate(const Mesh& mesh, VertexId v, Visit&& visit) {
  for_each_side_around(mesh, v, [&](SideId side) {
    for (SideId s = mesh.next(side); s != side; s = mesh.next(s)) visit(mesh.origin(s));
  });
}

}  // namespace

// Relaxed: a vertex that sees a neighbour's final colour early colours itself a round earlier, with the same
// colour.
std::uint8_t VertexColouring::load(VertexId v) const {
  return std::atomic_ref<std::uint8_t>(const_cast<std::uint8_t&>(colours_[v]))
      .load(std::memory_order_relaxed);
}
void VertexColouring::store(VertexId v, std::uint8_t colour) {
  std::atomic_ref<std::uint8_t>(colours_[v]).store(colour, std::memory_order_relaxed);
}

bool VertexColouring::try_colour(VertexId v) {
  std::bitset<kPending> used;
  bool ready = true;
  const std::uint32_t rank = mix32(v.value());
  for_each_face_mate(*mesh_, v, [&](VertexId other) {
    const std::uint8_t seen = load(other);
    if (seen == kPending)
      ready = ready && mix32(other.value()) > rank;
    else if (seen != kNone)
      used.set(seen);
  });
  if (!ready) return false;
  std::uint8_t colour = 0;
  while (used.test(colour)) ++colour;
  store(v, colour);
  return true;
}

void VertexColouring::extend(std::span<const std::uint32_t> vertices) {
  const auto keep = parallel::filter_indices(
      vertices.size(), [&](std::size_t i) { return colours_[VertexId(vertices[i])] == kNone; });
  std::vector<std::uint32_t> open(keep.size());
  parallel::for_each(open.size(), [&](std::size_t i) {
    open[i] = vertices[keep[i]];
    colours_[VertexId(open[i])] = kPending;
  });
  while (!open.empty()) {
    parallel::for_each(
        open.size(), [&](std::size_t i) { try_colour(VertexId(open[i])); }, kStarChunk);
    const auto left = parallel::filter_indices(
        open.size(), [&](std::size_t i) { return colours_[VertexId(open[i])] == kPending; });
    std::vector<std::uint32_t> rest(left.size());
    parallel::for_each(rest.size(), [&](std::size_t i) { rest[i] = open[left[i]]; });
    open = std::move(rest);
  }
}

std::vector<std::vector<std::uint32_t>> VertexColouring::classes(
    std::span<const std::uint32_t> vertices) const {
  std::vector<std::vector<std::uint32_t>> result;
  for (const std::uint32_t v : vertices) {
    assert(coloured(VertexId(v)));
    const auto colour = static_cast<std::size_t>(colours_[VertexId(v)]);
    if (result.size() <= colour) result.resize(colour + 1);
    result[colour].push_back(v);
  }
  return result;
}

}  // namespace quarry
