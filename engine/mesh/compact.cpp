#include "engine/mesh/compact.hpp"

#include <algorithm>

#include "engine/geometry/hilbert.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"

namespace quarry {
namespace {

constexpr std::uint32_t kGone = VertexId::kNone;

// Sorts ids by key; equal keys keep their order.
void sort_ids(std::vector<std::uint32_t>& ids, const auto& key_of) {
  std::vector<std::uint64_t> keys(ids.size());
  parallel::for_each(ids.size(), [&](std::size_t i) { keys[i] = key_of(ids[i]); });
  parallel::stable_sort_by_key(keys, ids);
}

std::vector<std::uint32_t> inverse(const std::vector<std::uint32_t>& old_of, std::size_t old_size) {
  std::vector<std::uint32_t> new_of(old_size, kGone);
  parallel::for_each(old_of.size(),
                     [&](std::size_t i) { new_of[old_of[i]] = static_cast<std::uint32_t>(i); });
  return new_of;
}

template <class T>
void gather(std::vector<T>& values, const std::vector<std::uint32_t>& old_of) {
  std::vector<T> kept(old_of.size());
  parallel::for_each(old_of.size(), [&](std::size_t i) { kept[i] = values[old_of[i]]; });
  values = std::move(kept);
}

template <class IdType>
void renumber_sets(std::vector<EntitySet<IdType>>& sets, const std::vector<std::uint32_t>& new_of) {
  for (auto& set : sets) {
    for (IdType& member : set.members) member = IdType(new_of[member.value()]);
    std::erase_if(set.members, [](IdType member) { return !member.valid(); });
  }
}

}  // namespace

class MeshCompactor {
 public:
  MeshCompactor(Mesh& mesh, EntityOrder order) : mesh_(mesh) {
    result_.old_vertex =
        parallel::filter_indices(mesh.vertex_slots(), [&](std::size_t i) { return mesh.alive(VertexId(i)); });
    result_.old_face =
        parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) { return mesh.alive(FaceId(i)); });
    if (order == EntityOrder::kHilbert) {
      sort_vertices();
      new_vertex_ = inverse(result_.old_vertex, mesh.vertex_slots());
      sort_ids(result_.old_face, [&](std::uint32_t i) {
        return std::uint64_t{new_vertex_[mesh.corner(FaceId(i), 0).value()]};
      });
    } else {
      new_vertex_ = inverse(result_.old_vertex, mesh.vertex_slots());
    }
    new_face_ = inverse(result_.old_face, mesh.face_slots());
  }

  Renumbering run() {
    move_faces();
    move_vertices();
    move_edges();
    renumber_sets(mesh_.vertex_sets_, new_vertex_);
    renumber_sets(mesh_.face_sets_, new_face_);
    return std::move(result_);
  }

 private:
  void sort_vertices() {
    if (mesh_.planar()) {
      const Box2 box = mesh_.box();
      sort_ids(result_.old_vertex,
               [&](std::uint32_t i) { return hilbert_key(mesh_.point(VertexId(i)), box); });
    } else {
      const Box3 box = mesh_.box3();
      sort_ids(result_.old_vertex,
               [&](std::uint32_t i) { return hilbert_key(mesh_.point3(VertexId(i)), box); });
    }
  }

  [[nodiscard]] SideId renumbered(SideId s) const {
    if (!s.valid()) return s;
    return {FaceId(new_face_[s.face().value()]), s.index()};
  }

  // One array after the other: each is there twice while it is moved.
  void move_faces() {
    mesh_.corners_ = gathered(mesh_.corners_,
                              [&](VertexId v) { return v.valid() ? VertexId(new_vertex_[v.value()]) : v; });
    mesh_.neighbours_ = gathered(mesh_.neighbours_, [&](SideId s) { return renumbered(s); });
    mesh_.face_tags_.gather(result_.old_face);
  }

  // Four values a face, of the faces that are left; renumber: what becomes of each.
  template <class T, class Renumber>
  std::vector<T> gathered(const std::vector<T>& values, const Renumber& renumber) const {
    std::vector<T> result(result_.old_face.size() * 4);
    parallel::for_each(result_.old_face.size(), [&](std::size_t i) {
      for (std::size_t k = 0; k < 4; ++k)
        result[i * 4 + k] = renumber(values[std::size_t{result_.old_face[i]} * 4 + k]);
    });
    return result;
  }

  void move_vertices() {
    gather(mesh_.x_, result_.old_vertex);
    gather(mesh_.y_, result_.old_vertex);
    if (!mesh_.planar()) gather(mesh_.z_, result_.old_vertex);
    gather(mesh_.side_of_, result_.old_vertex);
    parallel::for_each(mesh_.side_of_.size(),
                       [&](std::size_t i) { mesh_.side_of_[i] = renumbered(mesh_.side_of_[i]); });
    mesh_.vertex_tags_.gather(result_.old_vertex);
  }

  void move_edges() {
    const std::size_t slots = mesh_.edge_slots();
    const auto kept = parallel::filter_indices(slots, [&](std::size_t i) {
      const auto [a, b] = mesh_.edge_ends(EdgeId(i));
      return new_vertex_[a.value()] != kGone && new_vertex_[b.value()] != kGone;
    });
    gather(mesh_.edge_ends_.raw(), kept);
    for (auto& [a, b] : mesh_.edge_ends_) {
      a = VertexId(new_vertex_[a.value()]);
      b = VertexId(new_vertex_[b.value()]);
    }
    renumber_sets(mesh_.edge_sets_, inverse(kept, slots));
    mesh_.edge_tags_.gather(kept);
  }

  Mesh& mesh_;
  Renumbering result_;
  std::vector<std::uint32_t> new_vertex_, new_face_;
};

Renumbering compact(Mesh& mesh, EntityOrder order) { return MeshCompactor(mesh, order).run(); }

}  // namespace quarry
