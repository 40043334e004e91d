#include "surface/quads/mend_faces.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "engine/parallel/parallel.hpp"
#include "kernels/smooth/local_smoother.hpp"
#include "surface/quads/face_verdict.hpp"

namespace quarry {
namespace {

// How many rings of faces around a bad one may change.
constexpr std::array kRings = {1, 2, 4};
// More than so many, and than one in so many, are no matter of single faces: smoothing around each of them
// would take longer than all else, and leave most of them.
constexpr std::size_t kManyBad = 50;
constexpr std::size_t kFacesToABad = 50;
constexpr LocalShapeOptions kEffort{.untangling_sweeps = 30, .sweeps = 10};

class FaceMender {
 public:
  FaceMender(Mesh& mesh, const ConstraintTags& tags, const SpaceModel& model, const Progress& progress)
      : mesh_(mesh), tags_(tags), smoother_(model), normals_(mesh.normals()), progress_(progress) {}

  std::size_t run() {
    const auto bad = parallel::filter_indices(
        mesh_.face_slots(), [&](std::size_t i) { return mesh_.alive(FaceId(i)) && is_bad(FaceId(i)); });
    if (bad.size() > std::max(kManyBad, mesh_.count_alive_faces() / kFacesToABad)) return bad.size();
    for (const std::uint32_t i : bad) {
      progress_.throw_if_cancelled();
      for (const int rings : kRings)
        if (is_bad(FaceId(i))) mend(FaceId(i), rings);
    }
    return static_cast<std::size_t>(
        std::count_if(bad.begin(), bad.end(), [&](std::uint32_t i) { return is_bad(FaceId(i)); }));
  }

 private:
  [[nodiscard]] bool is_bad(FaceId f) const { return !(face_verdict(mesh_, normals_, f) > 0); }

  [[nodiscard]] std::size_t count_bad() const {
    return static_cast<std::size_t>(
        std::count_if(faces_.begin(), faces_.end(), [&](FaceId f) { return is_bad(f); }));
  }

  // The vertices of the face and of the rings around it but the last, and all faces at them.
  void gather(FaceId first, int rings) {
    faces_.assign(1, first);
    vertices_.clear();
    for (int ring = 0; ring < rings; ++ring) {
      for (const FaceId f : faces_)
        for (int k = 0; k < mesh_.corner_count(f); ++k) vertices_.push_back(mesh_.corner(f, k));
      sort_unique(vertices_);
      for (const VertexId v : vertices_)
        for_each_side_around(mesh_, v, [&](SideId s) { faces_.push_back(s.face()); });
      sort_unique(faces_);
    }
    std::erase_if(vertices_, [&](VertexId v) { return !tags_.support[v].is_free() || mesh_.on_boundary(v); });
  }
  template <class Id>
  static void sort_unique(std::vector<Id>& ids) {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  }

  void mend(FaceId f, int rings) {
    gather(f, rings);
    if (vertices_.empty()) return;
    const std::size_t before = count_bad();
    places_.clear();
    for (const VertexId v : vertices_) places_.push_back({mesh_.point3(v), normals_[v]});
    MeshEditor editor(mesh_);
    smoother_.run(editor, vertices_, kEffort);
    if (count_bad() < before) return;
    for (std::size_t i = 0; i < vertices_.size(); ++i) set_place(editor, vertices_[i], places_[i]);
  }

  Mesh& mesh_;
  const ConstraintTags& tags_;
  LocalSmoother<SpaceModel> smoother_;
  Tag<VertexId, Vec3> normals_;
  const Progress& progress_;
  std::vector<FaceId> faces_;
  std::vector<VertexId> vertices_;
  std::vector<SpacePoint> places_;
};

}  // namespace

std::size_t mend_faces(Mesh& mesh, const ConstraintTags& tags, const SpaceModel& model,
                       const Progress& progress) {
  return FaceMender(mesh, tags, model, progress).run();
}

}  // namespace quarry
