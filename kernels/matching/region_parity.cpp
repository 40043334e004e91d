#include "kernels/matching/region_parity.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/geometry/segment.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"
#include "kernels/matching/t_join.hpp"

namespace quarry {
namespace {

using Region = std::uint32_t;

double squared_length_of(const Mesh& mesh, SideId s) {
  const Vec3 edge = mesh.point3(mesh.target(s)) - mesh.point3(mesh.origin(s));
  return dot(edge, edge);
}

// The regions, numbered in the order of the faces that stand for them, with their parities.
struct Regions {
  const IdVector<FaceId, FaceId>& root;
  std::vector<std::uint32_t> face;  // of each region
  std::vector<std::uint8_t> odd;
  std::vector<std::uint32_t> number;  // of each face slot that stands for a region

  Regions(const Mesh& mesh, const IdVector<FaceId, FaceId>& root_of)
      : root(root_of), number(mesh.face_slots()) {
    face = parallel::filter_indices(
        root.size(), [&](std::size_t i) { return mesh.alive(FaceId(i)) && root[FaceId(i)].value() == i; });
    parallel::for_each(face.size(), [&](std::size_t i) { number[face[i]] = static_cast<std::uint32_t>(i); });
    odd.assign(face.size(), 0);
    count_parities(mesh);
  }

  [[nodiscard]] Region operator()(FaceId f) const { return number[root[f].value()]; }
  [[nodiscard]] std::uint64_t count_odd() const {
    return static_cast<std::uint64_t>(std::count(odd.begin(), odd.end(), 1));
  }

 private:
  // Neighbours in the list mostly share a region: whole runs are told at once.
  void count_parities(const Mesh& mesh) {
    parallel::for_each_chunk(root.size(), parallel::kChunk, [&](std::size_t begin, std::size_t end) {
      std::uint8_t parity = 0;
      for (std::size_t i = begin; i < end; ++i) {
        const FaceId f(i);
        if (!mesh.alive(f)) continue;
        parity ^= 1U;
        if (i + 1 < end && mesh.alive(FaceId(i + 1)) && root[FaceId(i + 1)] == root[f]) continue;
        std::atomic_ref(odd[(*this)(f)]).fetch_xor(parity, std::memory_order_relaxed);
        parity = 0;
      }
    });
  }
};

// The best edge between two regions, or between one and the outside.
struct Interface {
  Region a, b;
  SideId side;
};

class RegionGraph {
 public:
  RegionGraph(const Mesh& mesh, ConstraintTags tags, const Regions& regions,
              const MayHalveOuter& may_halve_outer)
      : mesh_(mesh), tags_(tags), regions_(regions), may_halve_outer_(may_halve_outer) {
    find_interfaces();
  }

  // The interfaces to halve: the fewest, and of so many the longest.
  std::vector<SideId> join() {
    std::vector<std::uint8_t> odd = regions_.odd;
    odd.push_back(0);
    const matching::TJoin found = matching::cheap_t_join({odd, edges(), outside()});
    if (found.stuck != matching::TJoin::kNone) throw_odd(found.stuck);
    std::vector<SideId> chosen;
    for (const std::uint32_t i : found.edges) chosen.push_back(interfaces_[i].side);
    std::sort(chosen.begin(), chosen.end());
    return chosen;
  }

 private:
  // What one edge to halve costs; and one that cannot be halved, in such edges: ways around it may be long.
  static constexpr std::int64_t kSplit = std::int64_t{1} << 36;
  static constexpr std::int64_t kBarrier = std::int64_t{1} << 12;

  [[nodiscard]] Region outside() const { return static_cast<Region>(regions_.face.size()); }

  [[nodiscard]] bool is_candidate(SideId s) const {
    if (!mesh_.alive(s.face()) || s.index() == 3) return false;
    const SideId t = mesh_.neighbour(s);
    if (!t.valid()) return may_halve_outer_(s);
    return tags_.constrained(s) && s < t && regions_(s.face()) != regions_(t.face());
  }

  [[nodiscard]] Interface interface_at(SideId s) const {
    const SideId t = mesh_.neighbour(s);
    const Region here = regions_(s.face());
    const Region there = t.valid() ? regions_(t.face()) : outside();
    return {std::min(here, there), std::max(here, there), s};
  }

  // Halving a side of a triangle that has another constrained side makes a triangle that can only be merged
  // into a quad with a straight corner.
  [[nodiscard]] bool leaves_a_leaf(SideId s) const {
    for (int k = 0; k < 3; ++k) {
      const SideId other(s.face(), k);
      if (other != s && !matching::joinable(mesh_, tags_, other)) return true;
    }
    return false;
  }

  // What speaks against an edge; of equals the longest is taken.
  [[nodiscard]] int reluctance(SideId s) const {
    const SideId t = mesh_.neighbour(s);
    if (mesh_.planar() && !can_split_edge(mesh_, s, middle_of(s))) return 2;
    return leaves_a_leaf(s) || (t.valid() && leaves_a_leaf(t)) ? 1 : 0;
  }

  [[nodiscard]] Vec2 middle_of(SideId s) const {
    return midpoint(mesh_.point(mesh_.origin(s)), mesh_.point(mesh_.target(s)));
  }

  [[nodiscard]] bool better(SideId s, SideId than) const {
    const int mine = reluctance(s);
    const int other = reluctance(than);
    if (mine != other) return mine < other;
    return squared_length_of(mesh_, s) > squared_length_of(mesh_, than);
  }

  void find_interfaces() {
    const auto sides = parallel::filter_indices(4 * mesh_.face_slots(), [&](std::size_t i) {
      return is_candidate(SideId(static_cast<std::uint32_t>(i)));
    });
    std::vector<std::uint64_t> keys(sides.size());
    parallel::for_each(sides.size(), [&](std::size_t i) {
      const Interface found = interface_at(SideId(sides[i]));
      keys[i] = (std::uint64_t{found.a} << 32) | found.b;
    });
    const std::vector<std::uint32_t> order = parallel::sorted_order(keys);
    for (const std::uint32_t i : order) {
      const Interface found = interface_at(SideId(sides[i]));
      if (interfaces_.empty() || interfaces_.back().a != found.a || interfaces_.back().b != found.b)
        interfaces_.push_back(found);
      else if (better(found.side, interfaces_.back().side))
        interfaces_.back().side = found.side;
    }
  }

  // Among as few edges the longest, and none that leaves a leaf: what speaks against all of them together is
  // less than one more edge.
  [[nodiscard]] std::vector<matching::JoinEdge> edges() const {
    double longest = 0;
    for (const Interface& way : interfaces_) longest = std::max(longest, squared_length_of(mesh_, way.side));
    const double share = static_cast<double>(kSplit) / (2.0 * static_cast<double>(interfaces_.size() + 1));
    std::vector<matching::JoinEdge> edges;
    for (const Interface& way : interfaces_) {
      const int against = reluctance(way.side);
      const double shortness = 1 - std::sqrt(squared_length_of(mesh_, way.side) / longest);
      const auto tie = static_cast<std::int64_t>(share * (shortness + (against > 0 ? 1 : 0)));
      edges.push_back({way.a, way.b, (against == 2 ? kBarrier : 1) * kSplit + tie});
    }
    return edges;
  }

  // Everything that hangs together with the region, whatever lies between.
  [[noreturn]] void throw_odd(Region r) const {
    std::vector<std::uint8_t> seen(mesh_.face_slots(), 0);
    std::vector<FaceId> todo{FaceId(regions_.face[r])};
    seen[todo.back().value()] = 1;
    std::uint64_t sides = 0;
    SideId place;
    while (!todo.empty()) {
      const FaceId f = todo.back();
      todo.pop_back();
      for (int k = 0; k < 3; ++k) {
        const SideId t = mesh_.neighbour(SideId(f, k));
        if (!t.valid()) {
          ++sides;
          place = std::min(place, SideId(f, k));
        } else if (std::exchange(seen[t.face().value()], std::uint8_t{1}) == 0) {
          todo.push_back(t.face());
        }
      }
    }
    const Vec3 p = mesh_.point3(mesh_.origin(place));
    throw Error(
        ErrorKind::kGeometry,
        fmt::format(
            "the boundary of the part at {} has {} sides, an odd number, which no mesh of "
            "quads alone can have: add or remove one vertex of it, or let its edges be halved "
            "(no --keep-boundary)",
            mesh_.planar() ? format_point(p.x, p.y) : fmt::format("({:.9g}, {:.9g}, {:.9g})", p.x, p.y, p.z),
            sides));
  }

  const Mesh& mesh_;
  ConstraintTags tags_;
  const Regions& regions_;
  const MayHalveOuter& may_halve_outer_;
  std::vector<Interface> interfaces_;  // by regions
};

Support support_of_middle(const Mesh& mesh, ConstraintTags tags, const PieceFinder& finder, SideId s) {
  if (tags.constrained(s)) {
    const PieceId piece = finder.under_edge(tags.support[mesh.origin(s)], tags.support[mesh.target(s)]);
    if (piece.valid()) return Support::on(piece);
  }
  return mesh.neighbour(s).valid() ? Support::free() : Support::fixed();
}

}  // namespace

std::uint64_t count_odd_regions(const Mesh& mesh, const IdVector<FaceId, FaceId>& root) {
  return Regions(mesh, root).count_odd();
}

std::vector<SideId> edges_to_halve(const Mesh& mesh, ConstraintTags tags,
                                   const IdVector<FaceId, FaceId>& root, const MayHalveOuter& may_halve_outer,
                                   ParityReport& report) {
  const Regions regions(mesh, root);
  report.regions = regions.face.size();
  report.odd_regions = regions.count_odd();
  if (report.odd_regions == 0) return {};
  std::vector<SideId> sides = RegionGraph(mesh, tags, regions, may_halve_outer).join();
  report.halved_edges = sides.size();
  return sides;
}

void halve_edges(Mesh& mesh, ConstraintTags tags, const NodedLines& lines, std::span<const SideId> sides) {
  if (sides.empty()) return;
  const PieceFinder finder(lines);
  halve_edges_at(mesh, tags, sides, [&](SideId s) {
    const Support support = support_of_middle(mesh, tags, finder, s);
    Vec2 middle = midpoint(mesh.point(mesh.origin(s)), mesh.point(mesh.target(s)));
    if (support.slides()) {
      const Piece& piece = lines.pieces[support.piece()];
      middle = closest_point(middle, lines.nodes[piece.from], lines.nodes[piece.to]);
    }
    if (!can_split_edge(mesh, s, middle))
      throw Error(
          ErrorKind::kGeometry,
          fmt::format("the edge at {} is too flat to be halved, which its region needs to become quads: "
                      "clean the lines there with a larger --snap, or use --quads cluster",
                      format_point(middle.x, middle.y)));
    return std::pair(middle, support);
  });
}

}  // namespace quarry
