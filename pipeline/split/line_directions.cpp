#include "pipeline/split/line_directions.hpp"

#include <algorithm>
#include <tuple>

#include "io/mesh/mesh_file.hpp"

namespace quarry {
namespace {

class Lines {
 public:
  explicit Lines(const Mesh& mesh)
      : mesh_(mesh), tags_(mesh), seen_(mesh.edge_slots(), false), backward_(mesh.edge_slots(), false) {
    for (const EdgeId e : mesh.edges())
      for (const VertexId end : {mesh.edge_ends(e).first, mesh.edge_ends(e).second})
        ends_.push_back({tags_.constraint(e), end, e});
    std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) {
      return std::tie(a.line, a.vertex, a.edge) < std::tie(b.line, b.vertex, b.edge);
    });
  }

  std::vector<bool> find() {
    // What is left after the lines with ends is closed.
    for (const bool only_from_ends : {true, false})
      for (const EdgeId e : mesh_.edges()) {
        const auto [a, b] = mesh_.edge_ends(e);
        if (seen_[e.value()]) continue;
        if (!only_from_ends || !follower(e, a).valid())
          walk(e, a);
        else if (!follower(e, b).valid())
          walk(e, b);
      }
    return std::move(backward_);
  }

 private:
  struct End {
    std::int32_t line;
    VertexId vertex;
    EdgeId edge;
  };

  // The one other edge of the same line at an end of an edge; none where there is no other or more than one.
  [[nodiscard]] EdgeId follower(EdgeId e, VertexId at) const {
    const std::int32_t line = tags_.constraint(e);
    const auto first = std::lower_bound(
        ends_.begin(), ends_.end(), std::pair(line, at), [](const End& end, const auto& key) {
          return std::tie(end.line, end.vertex) < std::tie(key.first, key.second);
        });
    const auto here = [&](std::ptrdiff_t i) {
      return ends_.end() - first > i && first[i].line == line && first[i].vertex == at;
    };
    if (!here(1) || here(2)) return {};
    return first[0].edge == e ? first[1].edge : first[0].edge;
  }

  void walk(EdgeId e, VertexId from) {
    while (e.valid() && !seen_[e.value()]) {
      seen_[e.value()] = true;
      const auto [a, b] = mesh_.edge_ends(e);
      backward_[e.value()] = from != a;
      from = from == a ? b : a;
      e = follower(e, from);
    }
  }

  const Mesh& mesh_;
  MeshFileTags tags_;
  std::vector<End> ends_;
  std::vector<bool> seen_, backward_;
};

}  // namespace

std::vector<bool> find_backward_edges(const Mesh& mesh) { return Lines(mesh).find(); }

}  // namespace quarry
