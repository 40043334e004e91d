#include "surface/size/detail_size.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

#include "engine/parallel/parallel.hpp"
#include "engine/parallel/scratch_pool.hpp"
#include "kernels/local/star.hpp"

namespace quarry {
namespace {

constexpr double kStep = 0.70710678118654752;  // from one size that is tried to the next
// How far apart places are looked at, in radii of the balls that are looked at.
constexpr double kSampleShare = 0.25;
constexpr std::size_t kSampleChunk = 256;

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

// One sample for each place of a given width: balls that are much wider tell the same of all vertices there,
// and one by one they would be looked at for ever where triangles are small.
class Cover {
 public:
  Cover(const Mesh& mesh, const ConstraintTags& tags)
      : mesh_(mesh), tags_(tags), sample_of_(mesh.vertex_slots()), seen_(mesh.vertex_slots(), 0) {}

  // The vertices in their order, each with its own place unless an earlier one is near, along free vertices
  // and by straight distance.
  const std::vector<VertexId>& build(const std::vector<VertexId>& vertices, double width) {
    samples_.clear();
    for (const VertexId v : vertices) sample_of_[v.value()] = kNone;
    for (const VertexId v : vertices)
      if (sample_of_[v.value()] == kNone) spread(v, width);
    return samples_;
  }
  [[nodiscard]] std::size_t sample_of(VertexId v) const { return sample_of_[v.value()]; }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  void spread(VertexId center, double width) {
    const auto number = static_cast<std::uint32_t>(samples_.size());
    samples_.push_back(center);
    ++stamp_;
    list_.assign(1, center);
    seen_[center.value()] = stamp_;
    const Vec3 middle = mesh_.point3(center);
    for (std::size_t i = 0; i < list_.size(); ++i) {
      std::uint32_t& sample = sample_of_[list_[i].value()];
      sample = std::min(sample, number);
      for_each_link_vertex(mesh_, list_[i], [&](VertexId w) {
        if (seen_[w.value()] == stamp_ || !tags_.support[w].is_free()) return;
        if (!(length(mesh_.point3(w) - middle) < width)) return;
        seen_[w.value()] = stamp_;
        list_.push_back(w);
      });
    }
  }

  const Mesh& mesh_;
  const ConstraintTags& tags_;
  std::vector<VertexId> samples_;
  std::vector<std::uint32_t> sample_of_;  // by vertex; kNone of those that have none yet
  std::vector<std::uint32_t> seen_;
  std::uint32_t stamp_ = 0;
  std::vector<VertexId> list_;
};

}  // namespace

std::vector<double> detail_sizes(const Mesh& triangles, const ConstraintTags& tags,
                                 const DetailOptions& options, const Progress& progress) {
  std::vector<double> sizes(triangles.vertex_slots(), std::numeric_limits<double>::infinity());
  // At a feature several parts of the surface meet; the vertices beside it speak for them.
  std::vector<VertexId> pending;
  for (const VertexId v : triangles.vertices())
    if (triangles.alive(v) && tags.support[v].is_free()) pending.push_back(v);
  ScratchPool<BallSearch> pool([&] { return std::make_unique<BallSearch>(triangles, tags); });
  Cover cover(triangles, tags);
  for (double share = 1; share >= options.smallest && !pending.empty(); share *= kStep) {
    progress.throw_if_cancelled();
    const double radius = options.reach * share * options.edge;
    const std::vector<VertexId>& samples = cover.build(pending, kSampleShare * radius);
    std::vector<std::uint8_t> has_details(samples.size());
    parallel::for_each_chunk(samples.size(), kSampleChunk, [&](std::size_t begin, std::size_t end) {
      const ScratchPool<BallSearch>::Loan search(pool);
      for (std::size_t i = begin; i < end; ++i)
        has_details[i] = search->sum_share(samples[i], radius) < options.least_sum ? 1 : 0;
    });
    std::erase_if(pending, [&](VertexId v) { return has_details[cover.sample_of(v)] == 0; });
    for (const VertexId v : pending)
      sizes[v.value()] = std::max(options.smallest, kStep * share) * options.edge;
  }
  return sizes;
}

}  // namespace quarry
