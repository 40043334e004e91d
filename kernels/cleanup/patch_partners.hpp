// Irregular vertices near a seed in the order of their distance over edges, found one after the other as they
// are asked for, each with a shortest path.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.hpp"
#include "kernels/cleanup/patch_stars.hpp"
#include "kernels/local/paged_array.hpp"

namespace quarry {

class PatchPartners {
 public:
  // Looks at no more than `reach` vertices. Keeps its memory.
  void begin(const Mesh& mesh, const PatchStars& stars, VertexId seed, std::size_t reach);

  // The next irregular vertex other than the seed, or none within reach. Ties go to whom the turn around the
  // vertices before meets first.
  VertexId next();
  // From a vertex that next() returned back to the seed, both included.
  void path_from(VertexId partner, std::vector<VertexId>& path) const;

 private:
  void visit(VertexId v, VertexId from);
  void visit_joined(VertexId v);

  const Mesh* mesh_ = nullptr;
  const PatchStars* stars_ = nullptr;
  std::size_t reach_ = 0;
  std::size_t looked_ = 0;               // of queue_: asked whether they are irregular
  std::size_t expanded_ = 0;             // of queue_: their neighbours have been visited
  PagedArray<VertexId, VertexId> from_;  // whence each was visited; none: not yet
  std::vector<VertexId> queue_;
};

}  // namespace quarry
