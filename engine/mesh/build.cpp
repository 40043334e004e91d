#include "engine/mesh/build.hpp"

#include <algorithm>
#include <atomic>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/mesh/pinch.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"

namespace quarry {

class MeshBuilder {
 public:
  // What becomes of edges whose faces do not go on into one another.
  enum class BadEdges { kRefused, kOpen };

  static Mesh make(std::vector<double> x, std::vector<double> y, std::vector<double> z,
                   std::span<const FaceCorners> faces, BadEdges bad) {
    Mesh mesh;
    mesh.x_ = std::move(x);
    mesh.y_ = std::move(y);
    mesh.z_ = std::move(z);
    mesh.spatial_ = !mesh.z_.empty();
    mesh.side_of_.assign(mesh.x_.size(), Mesh::kDeadVertex);
    mesh.corners_.resize(faces.size() * 4);
    mesh.neighbours_.resize(faces.size() * 4);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      check_corners(mesh, faces[f], f);
      std::copy(faces[f].begin(), faces[f].end(), mesh.corners_.begin() + static_cast<std::ptrdiff_t>(4 * f));
    }
    const std::size_t opened = join_sides(mesh, bad);
    rebuild_sides_of_vertices(mesh);
    if (opened > 0) separate_sheets(mesh);
    return mesh;
  }

 private:
  static void check_corners(const Mesh& mesh, const FaceCorners& corners, std::size_t face) {
    const int count = corners[3].valid() ? 4 : 3;
    for (int i = 0; i < count; ++i) {
      const VertexId v = corners[static_cast<std::size_t>(i)];
      if (!v.valid() || v.value() >= mesh.vertex_slots())
        throw Error(ErrorKind::kInput, fmt::format("face {} names a point that does not exist", face));
      for (int j = 0; j < i; ++j)
        if (corners[static_cast<std::size_t>(j)] == v)
          throw Error(ErrorKind::kInput, fmt::format("face {} has point {} twice", face, v.value()));
    }
  }

  // Sorts sides by their two vertices; equal keys are the faces of one edge. Returns how many were left open.
  static std::size_t join_sides(Mesh& mesh, BadEdges bad) {
    std::size_t opened = 0;
    std::vector<std::uint64_t> keys;
    std::vector<std::uint32_t> sides;
    keys.reserve(mesh.corners_.size());
    sides.reserve(mesh.corners_.size());
    for (std::uint32_t i = 0; i < mesh.corners_.size(); ++i) {
      if (!mesh.corners_[i].valid()) continue;
      const std::uint32_t a = mesh.origin(SideId(i)).value();
      const std::uint32_t b = mesh.target(SideId(i)).value();
      keys.push_back((std::uint64_t{std::min(a, b)} << 32) | std::max(a, b));
      sides.push_back(i);
    }
    parallel::stable_sort_by_key(keys, sides);
    for (std::size_t i = 0; i < keys.size();) {
      std::size_t end = i + 1;
      while (end < keys.size() && keys[end] == keys[i]) ++end;
      const SideId a(sides[i]), b(sides[end - 1]);
      const bool same_way = end - i == 2 && mesh.origin(a) == mesh.origin(b);
      if (bad == BadEdges::kRefused && end - i > 2) throw_edge(mesh, a, "has three faces or more");
      if (bad == BadEdges::kRefused && same_way)
        throw_edge(mesh, a, "is turned the same way by both its faces");
      if (end - i > 2 || same_way) {
        ++opened;
      } else if (a != b) {
        mesh.set_neighbour(a, b);
        mesh.set_neighbour(b, a);
      }
      i = end;
    }
    return opened;
  }

  static void separate_sheets(Mesh& mesh) {
    auto pinch = mesh.add_tag<VertexId, std::uint8_t>(kPinchTag, 0);
    for (const auto& [v, twin] : split_fans(mesh)) pinch[v] = pinch[twin] = 1;
  }

  [[noreturn]] static void throw_edge(const Mesh& mesh, SideId s, const char* what) {
    const Vec2 a = mesh.point(mesh.origin(s));
    const Vec2 b = mesh.point(mesh.target(s));
    throw Error(ErrorKind::kInput,
                fmt::format("the edge {} - {} {}", format_point(a.x, a.y), format_point(b.x, b.y), what));
  }
};

Mesh build_mesh(std::vector<double> x, std::vector<double> y, std::span<const FaceCorners> faces) {
  return MeshBuilder::make(std::move(x), std::move(y), {}, faces, MeshBuilder::BadEdges::kRefused);
}

Mesh build_mesh(std::vector<double> x, std::vector<double> y, std::vector<double> z,
                std::span<const FaceCorners> faces) {
  return MeshBuilder::make(std::move(x), std::move(y), std::move(z), faces, MeshBuilder::BadEdges::kRefused);
}

Mesh build_sheets(std::vector<double> x, std::vector<double> y, std::vector<double> z,
                  std::span<const FaceCorners> faces) {
  return MeshBuilder::make(std::move(x), std::move(y), std::move(z), faces, MeshBuilder::BadEdges::kOpen);
}

void rebuild_sides_of_vertices(Mesh& mesh) {
  // A boundary side starts at a vertex from which nothing lies clockwise: that one is wanted. Ranks make "the
  // wanted side" a minimum, so that faces may be visited in any order.
  std::vector<std::uint32_t> best(mesh.vertex_slots(), SideId::kNone);
  parallel::for_each(mesh.face_slots(), [&](std::size_t i) {
    const FaceId f(i);
    if (!mesh.alive(f)) return;
    for (int k = 0; k < mesh.corner_count(f); ++k) {
      const SideId s(f, k);
      const std::uint32_t rank = mesh.neighbour(s).valid() ? s.value() | 0x80000000U : s.value();
      std::atomic_ref<std::uint32_t> word(best[mesh.origin(s).value()]);
      std::uint32_t seen = word.load(std::memory_order_relaxed);
      while (rank < seen && !word.compare_exchange_weak(seen, rank, std::memory_order_relaxed)) {
      }
    }
  });
  parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (best[i] == SideId::kNone)
      mesh.delete_vertex(v);
    else
      mesh.set_side_of(v, SideId(best[i] & 0x7fffffffU));
  });
}

}  // namespace quarry
