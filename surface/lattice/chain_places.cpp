#include "surface/lattice/chain_places.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace quarry {
namespace {

// The edges of a curve, from both ends, by vertex.
using Links = std::vector<std::pair<VertexId, VertexId>>;

class Chain {
 public:
  Chain(LatticeState& state, PieceId curve) : state_(state), curve_(curve) {}

  // From a vertex on, until a fixed one comes or the first again.
  void walk(const Links& links, std::vector<std::uint8_t>& used, std::size_t link) {
    vertices_ = {links[link].first, links[link].second};
    mark(links, used, link);
    while (!fixed(vertices_.back()) && vertices_.back() != vertices_.front()) {
      const std::size_t next = unused(links, used, vertices_.back());
      if (next == links.size()) break;
      vertices_.push_back(links[next].second);
      mark(links, used, next);
    }
  }

  void place() {
    const RemeshState& base = state_.base;
    std::vector<double> at{0};
    for (std::size_t k = 1; k < vertices_.size(); ++k)
      at.push_back(at.back() + base.relative_length(vertices_[k - 1], vertices_[k]));
    const double whole = at.back();
    const bool round = vertices_.front() == vertices_.back();
    const double parts = std::max(round ? 3.0 : 1.0, std::round(whole));
    if (!(whole > 0)) return;
    for (std::size_t k = 0; k < vertices_.size(); ++k) {
      if (fixed(vertices_[k])) continue;
      const double wanted = std::round(at[k] / whole * parts) / parts * whole;
      state_.place[vertices_[k]] = point(at, wanted);
    }
  }

 private:
  [[nodiscard]] bool fixed(VertexId v) const { return state_.base.tags.support[v].is_fixed(); }

  static std::size_t find(const Links& links, VertexId from) {
    return static_cast<std::size_t>(
        std::lower_bound(links.begin(), links.end(), std::pair{from, VertexId(0U)}) - links.begin());
  }
  static std::size_t unused(const Links& links, const std::vector<std::uint8_t>& used, VertexId from) {
    for (std::size_t k = find(links, from); k < links.size() && links[k].first == from; ++k)
      if (used[k] == 0) return k;
    return links.size();
  }
  static void mark(const Links& links, std::vector<std::uint8_t>& used, std::size_t link) {
    used[link] = 1;
    const std::pair back{links[link].second, links[link].first};
    used[static_cast<std::size_t>(std::lower_bound(links.begin(), links.end(), back) - links.begin())] = 1;
  }

  [[nodiscard]] Vec3 point(const std::vector<double>& at, double wanted) const {
    std::size_t k = 1;
    while (k + 1 < at.size() && at[k] < wanted) ++k;
    const Vec3 a = state_.base.point(vertices_[k - 1]);
    const Vec3 b = state_.base.point(vertices_[k]);
    if (wanted <= at[k - 1]) return a;
    if (wanted >= at[k]) return b;
    return state_.base.network.project(curve_, a + (wanted - at[k - 1]) / (at[k] - at[k - 1]) * (b - a));
  }

  LatticeState& state_;
  PieceId curve_;
  std::vector<VertexId> vertices_;
};

}  // namespace

void place_on_chains(LatticeState& state) {
  const RemeshState& base = state.base;
  const Mesh& mesh = base.mesh;
  for (const VertexId v : mesh.vertices())
    if (mesh.alive(v) && !base.tags.support[v].is_free()) state.place[v] = mesh.point3(v);
  IdVector<PieceId, Links> curves(base.network.curves.size());
  for (const FaceId f : mesh.faces())
    for (int k = 0; mesh.alive(f) && k < 3; ++k) {
      const SideId s(f, k);
      const SideId t = mesh.neighbour(s);
      if (!base.tags.constrained(s) || (t.valid() && t < s)) continue;
      const VertexId a = mesh.origin(s), b = mesh.target(s);
      const PieceId curve = base.network.under_edge(base.tags.support[a], base.tags.support[b],
                                                    0.5 * (mesh.point3(a) + mesh.point3(b)));
      if (!curve.valid()) continue;
      curves[curve].emplace_back(a, b);
      curves[curve].emplace_back(b, a);
    }
  for (std::size_t c = 0; c < curves.size(); ++c) {
    Links& links = curves[PieceId(c)];
    std::sort(links.begin(), links.end());
    std::vector<std::uint8_t> used(links.size(), 0);
    // First those that begin at a fixed vertex; what is left is closed.
    for (const bool closed : {false, true})
      for (std::size_t k = 0; k < links.size(); ++k) {
        if (used[k] != 0 || (!closed && !base.tags.support[links[k].first].is_fixed())) continue;
        Chain chain(state, PieceId(c));
        chain.walk(links, used, k);
        chain.place();
      }
  }
}

}  // namespace quarry
