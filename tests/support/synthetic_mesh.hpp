// Triangle meshes with constraints, made without any mesher: a 4-8 lattice whose free vertices are shaken,
// whose edges are flipped, and some of whose edges are constraints. Every triangle turns left.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/base/random.hpp"
#include "engine/geometry/predicates.hpp"
#include "engine/mesh/build.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/validate.hpp"

namespace quarry::test {

struct SyntheticOptions {
  int columns = 20, rows = 16;  // lattice cells of side 2
  std::uint64_t seed = 1;
  double jitter = 0.4;      // largest displacement of a free vertex, in cells
  double flip_share = 0.3;  // share of the edges that are tried
  int straight_lines = 4;   // runs along lattice lines: nodes at ends and crossings, sliding vertices between
  int crooked_lines = 4;    // walks along any edges: every vertex a node
  double slivers = 0.0;     // share of the free vertices pushed to within 1e-6 cells of an edge of their star
  Vec2 origin{6700000.0, 500000.0};
};

struct SyntheticMesh {
  Mesh mesh;
  ConstraintTags tags;
  NodedLines lines;
};

class SyntheticMaker {
 public:
  explicit SyntheticMaker(const SyntheticOptions& options) : options_(options) {}

  SyntheticMesh make() {
    make_lattice();
    mark_straight_lines();
    mark_crooked_lines();
    collect_nodes_and_pieces();
    shake();
    flip();
    shake();
    flatten();
    return std::move(result_);
  }

 private:
  [[nodiscard]] double random() { return uniform01(options_.seed, counter_++); }
  [[nodiscard]] int random_below(int end) {
    return std::min(end - 1, static_cast<int>(random() * static_cast<double>(end)));
  }
  [[nodiscard]] VertexId at(int column, int row) const {
    return VertexId(static_cast<std::uint32_t>(row * (options_.columns + 1) + column));
  }

  void make_lattice() {
    std::vector<double> x, y;
    for (int row = 0; row <= options_.rows; ++row) {
      for (int column = 0; column <= options_.columns; ++column) {
        x.push_back(options_.origin.x + 2.0 * column);
        y.push_back(options_.origin.y + 2.0 * row);
      }
    }
    std::vector<FaceCorners> faces;
    for (int row = 0; row < options_.rows; ++row) {
      for (int column = 0; column < options_.columns; ++column) {
        const std::array<VertexId, 4> cell = {at(column, row), at(column + 1, row), at(column + 1, row + 1),
                                              at(column, row + 1)};
        const std::size_t first = (row + column) % 2 == 0 ? 0 : 1;
        faces.push_back({cell[first], cell[first + 1], cell[(first + 2) % 4], VertexId()});
        faces.push_back({cell[(first + 2) % 4], cell[(first + 3) % 4], cell[first], VertexId()});
      }
    }
    result_.mesh = build_mesh(std::move(x), std::move(y), faces);
    result_.tags = ConstraintTags::add_to(result_.mesh);
    for (const VertexId v : result_.mesh.vertices())
      if (result_.mesh.on_boundary(v)) result_.tags.support[v] = Support::fixed();
  }

  void constrain(VertexId a, VertexId b) {
    const SideId s = result_.mesh.find_side(a, b);
    if (!s.valid()) return;
    result_.tags.set_constrained(s, true);
    result_.tags.set_constrained(result_.mesh.neighbour(s), true);
  }

  void mark_straight_lines() {
    for (int i = 0; i < options_.straight_lines; ++i) {
      const bool upright = random() < 0.5;
      const int length = 2 + random_below(std::min(options_.columns, options_.rows) - 4);
      const int column = 1 + random_below(options_.columns - 1 - (upright ? 0 : length));
      const int row = 1 + random_below(options_.rows - 1 - (upright ? length : 0));
      for (int k = 0; k < length; ++k)
        constrain(at(column + (upright ? 0 : k), row + (upright ? k : 0)),
                  at(column + (upright ? 0 : k + 1), row + (upright ? k + 1 : 0)));
    }
  }

  void mark_crooked_lines() {
    for (int i = 0; i < options_.crooked_lines; ++i) {
      VertexId here = at(1 + random_below(options_.columns - 1), 1 + random_below(options_.rows - 1));
      for (int k = 0; k < 6; ++k) {
        std::vector<VertexId> choices;
        for_each_side_around(result_.mesh, here, [&](SideId s) {
          if (!result_.mesh.on_boundary(result_.mesh.target(s))) choices.push_back(result_.mesh.target(s));
        });
        if (choices.empty()) break;
        const VertexId there =
            choices[static_cast<std::size_t>(random_below(static_cast<int>(choices.size())))];
        constrain(here, there);
        crooked_.push_back(here);
        crooked_.push_back(there);
        here = there;
      }
    }
  }

  // The ends of constrained edges at v.
  [[nodiscard]] std::vector<VertexId> joined(VertexId v) const {
    std::vector<VertexId> ends;
    for_each_side_around(result_.mesh, v, [&](SideId s) {
      if (result_.tags.constrained(s)) ends.push_back(result_.mesh.target(s));
    });
    return ends;
  }

  void collect_nodes_and_pieces() {
    Mesh& mesh = result_.mesh;
    const auto is_node = [&](VertexId v) {
      const std::vector<VertexId> ends = joined(v);
      if (ends.empty()) return false;
      if (ends.size() != 2 || std::find(crooked_.begin(), crooked_.end(), v) != crooked_.end()) return true;
      return orient2d(mesh.point(ends[0]), mesh.point(v), mesh.point(ends[1])) != 0;
    };
    for (const VertexId v : mesh.vertices())
      if (is_node(v)) result_.tags.support[v] = Support::at(result_.lines.nodes.push_back(mesh.point(v)));
    for (const VertexId v : mesh.vertices())
      if (result_.tags.support[v].is_node())
        for (const VertexId first : joined(v)) trace_piece(v, first);
    result_.lines.line_begin.assign(result_.lines.pieces.size() + 1, 0);
  }

  void trace_piece(VertexId from, VertexId first) {
    std::vector<VertexId> inner;
    VertexId before = from;
    VertexId here = first;
    while (!result_.tags.support[here].is_node()) {
      inner.push_back(here);
      const std::vector<VertexId> ends = joined(here);
      before = std::exchange(here, ends[0] == before ? ends[1] : ends[0]);
    }
    const NodeId a = result_.tags.support[from].node();
    const NodeId b = result_.tags.support[here].node();
    if (!(a < b)) return;  // the other end traces it
    const PieceId piece = result_.lines.pieces.push_back({a, b, PieceKindOf::kInterior});
    for (const VertexId v : inner) result_.tags.support[v] = Support::on(piece);
  }

  [[nodiscard]] bool star_turns_left(VertexId v) const {
    bool valid = true;
    for_each_side_around(result_.mesh, v,
                         [&](SideId s) { valid = valid && all_corners_turn_left(result_.mesh, s.face()); });
    return valid;
  }

  void move_if_valid(VertexId v, Vec2 p) {
    const Vec2 before = result_.mesh.point(v);
    result_.mesh.set_point(v, p);
    if (!star_turns_left(v)) result_.mesh.set_point(v, before);
  }

  void shake() {
    for (const VertexId v : result_.mesh.vertices()) {
      if (!result_.tags.support[v].is_free()) continue;
      const double reach = 4 * options_.jitter;
      move_if_valid(v, result_.mesh.point(v) + Vec2{(random() - 0.5) * reach, (random() - 0.5) * reach});
    }
  }

  void flip() {
    Mesh& mesh = result_.mesh;
    for (const FaceId f : mesh.faces()) {
      for (int k = 0; k < 3; ++k)
        if (random() < options_.flip_share) flip_side(SideId(f, k));
    }
    rebuild_sides_of_vertices(mesh);
  }

  void flip_side(SideId s) {
    Mesh& mesh = result_.mesh;
    const SideId t = mesh.neighbour(s);
    if (!t.valid() || result_.tags.constrained(s)) return;
    const VertexId a = mesh.origin(s), b = mesh.target(s);
    const SideId sn = mesh.next(s), sp = mesh.previous(s), tn = mesh.next(t), tp = mesh.previous(t);
    const VertexId c = mesh.origin(sp), d = mesh.origin(tp);
    if (!(orient2d(mesh.point(c), mesh.point(a), mesh.point(d)) > 0 &&
          orient2d(mesh.point(d), mesh.point(b), mesh.point(c)) > 0))
      return;
    const std::array<SideId, 4> rim = {mesh.neighbour(sn), mesh.neighbour(sp), mesh.neighbour(tn),
                                       mesh.neighbour(tp)};
    const std::array<bool, 4> bits = {result_.tags.constrained(sn), result_.tags.constrained(sp),
                                      result_.tags.constrained(tn), result_.tags.constrained(tp)};
    // Face of s: c, a, d; face of t: d, b, c.
    const FaceId f = s.face(), g = t.face();
    const std::array<VertexId, 6> corners = {c, a, d, d, b, c};
    for (int k = 0; k < 3; ++k) {
      mesh.set_corner(SideId(f, k), corners[static_cast<std::size_t>(k)]);
      mesh.set_corner(SideId(g, k), corners[static_cast<std::size_t>(k + 3)]);
    }
    result_.tags.sides[f] = result_.tags.sides[g] = 0;
    const std::array<SideId, 4> place = {SideId(g, 1), SideId(f, 0), SideId(f, 1), SideId(g, 0)};
    for (std::size_t i = 0; i < 4; ++i) {
      mesh.set_neighbour(place[i], rim[i]);
      if (rim[i].valid()) mesh.set_neighbour(rim[i], place[i]);
      result_.tags.set_constrained(place[i], bits[i]);
    }
    mesh.set_neighbour(SideId(f, 2), SideId(g, 2));
    mesh.set_neighbour(SideId(g, 2), SideId(f, 2));
  }

  void flatten() {
    Mesh& mesh = result_.mesh;
    for (const VertexId v : mesh.vertices()) {
      if (!result_.tags.support[v].is_free() || random() >= options_.slivers) continue;
      const SideId opposite = mesh.next(mesh.side_of(v));
      const Vec2 middle = midpoint(mesh.point(mesh.origin(opposite)), mesh.point(mesh.target(opposite)));
      move_if_valid(v, middle + 1e-6 * (mesh.point(v) - middle));
    }
  }

  SyntheticOptions options_;
  std::uint64_t counter_ = 0;
  SyntheticMesh result_;
  std::vector<VertexId> crooked_;
};

inline SyntheticMesh make_synthetic(const SyntheticOptions& options = {}) {
  return SyntheticMaker(options).make();
}

}  // namespace quarry::test
