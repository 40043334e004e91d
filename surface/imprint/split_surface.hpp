// A triangulated surface whose triangles are cut at points, one after the other.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "surface/repair/repair.hpp"

namespace quarry {

class SplitSurface {
 public:
  explicit SplitSurface(RepairedSurface& repaired);

  [[nodiscard]] const TriangleSurface& surface() const { return surface_; }
  [[nodiscard]] Vec3 point(std::uint32_t p) const { return surface_.points[p]; }
  // The triangles at a point.
  [[nodiscard]] const std::vector<std::uint32_t>& around(std::uint32_t p) const { return around_[p]; }
  [[nodiscard]] bool has_edge(std::uint32_t a, std::uint32_t b) const;

  // The point of the surface at a place that lies on a triangle of the surface as it was at first: one that
  // is there within the snapping distance, or a new one on an edge or in a triangle.
  std::uint32_t point_at(std::uint32_t first_triangle, Vec3 place, double snap);
  // Halves the edge, in all triangles that have it. Returns the new point.
  std::uint32_t split_edge(std::uint32_t a, std::uint32_t b, Vec3 place);

  // Marks an edge with a number, unless it has one. Returns its number.
  std::int32_t mark(std::uint32_t a, std::uint32_t b, std::int32_t number) {
    return marks_.try_emplace(join_of(a, b), number).first->second;
  }
  [[nodiscard]] const std::map<SheetJoin, std::int32_t>& marks() const { return marks_; }

  // Hands joins back, as they are now.
  void finish();

 private:
  std::uint32_t add_point(Vec3 place);
  void add_part(std::uint32_t of, SurfaceTriangle corners);
  void replace(std::uint32_t triangle, SurfaceTriangle corners);
  std::uint32_t split_face(std::uint32_t triangle, Vec3 place);
  [[nodiscard]] std::uint32_t part_at(std::uint32_t first_triangle, Vec3 place) const;

  RepairedSurface& repaired_;
  TriangleSurface& surface_;
  std::vector<std::vector<std::uint32_t>> around_;             // by point
  std::vector<std::uint32_t> first_;                           // of a triangle: what it was part of at first
  std::map<std::uint32_t, std::vector<std::uint32_t>> parts_;  // of those that were cut
  std::set<SheetJoin> joins_;
  std::map<SheetJoin, std::int32_t> marks_;
};

}  // namespace quarry
