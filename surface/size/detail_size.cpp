#include "surface/size/detail_size.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

#include "engine/parallel/parallel.hpp"
#include "engine/parallel/scratch_pool.hpp"

namespace quarry {
namespace {

constexpr double kStep = 0.70710678118654752;  // from one size that is tried to the next

// The triangles around one vertex after the other; one a thread.
class BallSearch {
 public:
  BallSearch(const Mesh& mesh, const ConstraintTags& tags) : mesh_(&mesh), tags_(&tags) {}

  // The length of the sum of the doubled areas by the sum of the lengths, over the triangles that hang
  // together and lie about within the radius, those at the vertex in any case; 1 if they have no area.
  double sum_share(VertexId center, double radius) {
    if (seen_.size() != mesh_->face_slots()) seen_.assign(mesh_->face_slots(), 0);
    ++stamp_;
    list_.clear();
    const Vec3 middle = mesh_->point3(center);
    for_each_side_around(*mesh_, center, [&](SideId s) { add(s.face()); });
    const std::size_t around = list_.size();
    Vec3 sum;
    double size = 0;
    for (std::size_t i = 0; i < list_.size(); ++i) {
      const FaceId f = list_[i];
      const Vec3 a = mesh_->point3(mesh_->corner(f, 0)), b = mesh_->point3(mesh_->corner(f, 1)),
                 c = mesh_->point3(mesh_->corner(f, 2));
      if (i >= around && !(length((1.0 / 3) * (a + b + c) - middle) <= radius)) continue;
      // Of a triangle larger than the ball only a part lies in it.
      Vec3 normal = cross(b - a, c - a);
      const double area = length(normal);
      const double most = radius * radius;
      if (area > most) normal = (most / area) * normal;
      sum = sum + normal;
      size += std::min(area, most);
      for (int k = 0; k < 3; ++k) {
        const SideId s(f, k);
        const SideId t = mesh_->neighbour(s);
        if (t.valid() && !tags_->constrained(s)) add(t.face());
      }
    }
    return size > 0 ? length(sum) / size : 1;
  }

 private:
  void add(FaceId f) {
    if (seen_[f.value()] == stamp_) return;
    seen_[f.value()] = stamp_;
    list_.push_back(f);
  }

  const Mesh* mesh_;
  const ConstraintTags* tags_;
  std::vector<std::uint32_t> seen_;
  std::uint32_t stamp_ = 0;
  std::vector<FaceId> list_;
};

}  // namespace

std::vector<double> detail_sizes(const Mesh& triangles, const ConstraintTags& tags,
                                 const DetailOptions& options) {
  std::vector<double> sizes(triangles.vertex_slots(), std::numeric_limits<double>::infinity());
  ScratchPool<BallSearch> pool([&] { return std::make_unique<BallSearch>(triangles, tags); });
  parallel::for_each_chunk(sizes.size(), parallel::kChunk, [&](std::size_t begin, std::size_t end) {
    const ScratchPool<BallSearch>::Loan search(pool);
    for (std::size_t i = begin; i < end; ++i) {
      const VertexId v(i);
      // At a feature several parts of the surface meet; the vertices beside it speak for them.
      if (!triangles.alive(v) || !tags.support[v].is_free()) continue;
      for (double share = 1; share >= options.smallest; share *= kStep) {
        if (search->sum_share(v, options.reach * share * options.edge) >= options.least_sum) break;
        sizes[i] = std::max(options.smallest, kStep * share) * options.edge;
      }
    }
  });
  return sizes;
}

}  // namespace quarry
