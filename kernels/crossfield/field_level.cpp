#include "kernels/crossfield/field_level.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include <bitset>

#include "engine/base/random.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/local/star.hpp"
#include "kernels/smooth/tangent_frame.hpp"

namespace quarry {
namespace {

Vec3 normal_of(const Mesh& mesh, VertexId v) {
  if (mesh.planar()) return {0, 0, 1};
  const Tag<VertexId, Vec3> normals = mesh.normals();
  if (normals.valid() && !(normals[v] == Vec3())) return normals[v];
  Vec3 sum;
  for_each_side_around(mesh, v, [&](SideId s) {
    const Vec3 here = mesh.point3(v);
    sum = sum + cross(mesh.point3(mesh.target(s)) - here, mesh.point3(mesh.origin(mesh.previous(s))) - here);
  });
  return unit_or(sum, {0, 0, 1});
}

// The number that a field at b is multiplied by when it is carried to a: of the axis of b, turned by the
// shortest rotation that takes the normal there to the one here, four times the angle from the axis of a.
Vec2 transport(const FieldLevel& level, std::uint32_t a, std::uint32_t b) {
  const Vec3 n = level.normals[a];
  const Vec3 m = level.normals[b];
  const Vec3 x = level.axes[b];
  const double cosine = dot(m, n);
  const Vec3 axis = cross(m, n);
  // Rodrigues, with (1 - cosine) / sine^2 = 1 / (1 + cosine); opposite normals have no shortest rotation.
  const double share = 1 / std::max(1 + cosine, 1e-12);
  const Vec3 turned = cosine * x + cross(axis, x) + (share * dot(axis, x)) * axis;
  const Vec3 e = level.axes[a];
  const Vec2 once{dot(turned, e), dot(turned, cross(n, e))};
  const double size = length(once);
  if (!(size > 0)) return {1, 0};
  const Vec2 z = (1 / size) * once;
  const Vec2 twice = complex_product(z, z);
  return complex_product(twice, twice);
}

}  // namespace

std::size_t FieldLevel::free_size() const {
  std::size_t count = 0;
  for (const auto& members : classes) count += members.size();
  return count;
}

void FieldLevel::resize(std::size_t size) {
  points.resize(size);
  normals.resize(size);
  axes.resize(size);
  mass.resize(size, 1);
  given.resize(size);
  diagonal.resize(size);
}

// Greedy colours in the order of a hash (Jones & Plassmann 1993).
void find_classes(FieldLevel& level) {
  constexpr std::uint8_t kOpen = 255;
  std::vector<std::uint8_t> colour(level.size(), kOpen);
  std::vector<std::uint32_t> open =
      parallel::filter_indices(level.size(), [&](std::size_t i) { return level.given[i] == 0; });
  const std::vector<std::uint32_t> all = open;
  const auto load = [&](std::uint32_t i) {
    return std::atomic_ref<std::uint8_t>(colour[i]).load(std::memory_order_relaxed);
  };
  while (!open.empty()) {
    parallel::for_each(
        open.size(),
        [&](std::size_t k) {
          const std::uint32_t i = open[k];
          std::bitset<256> used;
          for (std::uint32_t e = level.first[i]; e < level.first[i + 1]; ++e) {
            const std::uint32_t j = level.other[e];
            if (level.given[j] != 0) continue;
            const std::uint8_t seen = load(j);
            if (seen == kOpen && mix32(j) < mix32(i)) return;
            used.set(seen);
          }
          std::uint8_t mine = 0;
          while (mine + 1 < kOpen && used.test(mine)) ++mine;
          std::atomic_ref<std::uint8_t>(colour[i]).store(mine, std::memory_order_relaxed);
        },
        kFieldChunk);
    const auto left =
        parallel::filter_indices(open.size(), [&](std::size_t k) { return colour[open[k]] == kOpen; });
    std::vector<std::uint32_t> rest(left.size());
    parallel::for_each(rest.size(), [&](std::size_t k) { rest[k] = open[left[k]]; });
    open = std::move(rest);
  }
  level.classes.clear();
  for (const std::uint32_t i : all) {
    if (level.classes.size() <= colour[i]) level.classes.resize(std::size_t{colour[i]} + 1);
    level.classes[colour[i]].push_back(i);
  }
}

FieldLevel finest_level(const Mesh& mesh, std::vector<std::uint8_t> given, std::span<const Vec3> axes) {
  FieldLevel level;
  const std::size_t size = mesh.vertex_slots();
  level.given = std::move(given);
  level.resize(size);
  level.first.assign(size + 1, 0);
  parallel::for_each(size, [&](std::size_t i) {
    const VertexId v(i);
    level.points[i] = mesh.point3(v);
    level.normals[i] = mesh.alive(v) ? normal_of(mesh, v) : Vec3{0, 0, 1};
    const Vec3 n = level.normals[i];
    level.axes[i] = axes.empty() ? any_tangent(n) : unit_or(axes[i] - dot(axes[i], n) * n, any_tangent(n));
    std::uint32_t count = 0;
    if (mesh.alive(v)) for_each_link_vertex(mesh, v, [&](VertexId) { ++count; });
    level.first[i] = count;
    level.diagonal[i] = count;
  });
  parallel::exclusive_scan(std::span(level.first));
  level.other.resize(level.first[size]);
  level.weight.assign(level.first[size], 1);
  level.turn.resize(level.first[size]);
  parallel::for_each(size, [&](std::size_t i) {
    const VertexId v(i);
    std::uint32_t e = level.first[i];
    if (mesh.alive(v)) for_each_link_vertex(mesh, v, [&](VertexId w) { level.other[e++] = w.value(); });
  });
  parallel::for_each(size, [&](std::size_t i) {
    for (std::uint32_t e = level.first[i]; e < level.first[i + 1]; ++e)
      level.turn[e] = transport(level, static_cast<std::uint32_t>(i), level.other[e]);
  });
  find_classes(level);
  return level;
}

}  // namespace quarry
