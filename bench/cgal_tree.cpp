#include "bench/cgal_tree.hpp"

#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

namespace quarry::bench {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 to_cgal(Vec3 p) { return {p.x, p.y, p.z}; }

}  // namespace

struct CgalTree::Parts {
  Triangles triangles;
  Tree tree;
};

CgalTree::CgalTree(std::span<const Vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles)
    : parts_(std::make_unique<Parts>()) {
  parts_->triangles.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles)
    parts_->triangles.emplace_back(to_cgal(points[a]), to_cgal(points[b]), to_cgal(points[c]));
  parts_->tree.insert(parts_->triangles.cbegin(), parts_->triangles.cend());
  parts_->tree.build();
  parts_->tree.accelerate_distance_queries();
}

CgalTree::~CgalTree() = default;

CgalTree::Closest CgalTree::closest(Vec3 p) const {
  const auto [position, primitive] = parts_->tree.closest_point_and_primitive(to_cgal(p));
  return {{position.x(), position.y(), position.z()},
          static_cast<std::uint32_t>(primitive - parts_->triangles.cbegin())};
}

}  // namespace quarry::bench
