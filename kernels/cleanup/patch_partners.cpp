#include "kernels/cleanup/patch_partners.hpp"

#include <algorithm>

namespace quarry {

void PatchPartners::begin(const Mesh& mesh, const PatchStars& stars, VertexId seed, std::size_t reach) {
  mesh_ = &mesh;
  stars_ = &stars;
  reach_ = reach;
  from_.clear(mesh.vertex_slots());
  queue_.clear();
  visit(seed, seed);
  looked_ = 1;
  expanded_ = 0;
}

void PatchPartners::visit(VertexId v, VertexId from) {
  VertexId& mark = from_.at(v);
  if (mark.valid()) return;
  mark = from;
  queue_.push_back(v);
}

void PatchPartners::visit_joined(VertexId v) {
  SideId last;
  for_each_side_around(*mesh_, v, [&](SideId s) {
    visit(mesh_->target(s), v);
    last = s;
  });
  // At the boundary one neighbour more than there are sides that start at v.
  visit(mesh_->origin(mesh_->previous(last)), v);
}

VertexId PatchPartners::next() {
  for (;;) {
    while (looked_ < queue_.size()) {
      const VertexId v = queue_[looked_++];
      if (stars_->irregular(v)) return v;
    }
    if (expanded_ == queue_.size() || queue_.size() >= reach_) return {};
    visit_joined(queue_[expanded_++]);
  }
}

void PatchPartners::path_from(VertexId partner, std::vector<VertexId>& path) const {
  path.assign(1, partner);
  while (from_.get(path.back()) != path.back()) path.push_back(from_.get(path.back()));
}

}  // namespace quarry
