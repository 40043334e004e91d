#include "bench/domains.hpp"

#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/geometry/box.hpp"
#include "engine/mesh/build.hpp"
#include "engine/mesh/compact.hpp"
#include "engine/mesh/constraint.hpp"
#include "kernels/cluster/subdivide.hpp"
#include "kernels/initial/delaunay.hpp"
#include "kernels/initial/triangulation.hpp"

namespace quarry::bench {
namespace {

// Inner points keep this from the boundary, in units of its spacing: less would take boundary edges away.
constexpr double kMargin = 0.6;
constexpr double kInnerRadius = 1, kOuterRadius = 1.5;

using Ring = std::vector<Vec2>;

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const double t = std::clamp(dot(p - a, b - a) / squared_length(b - a), 0.0, 1.0);
  return length(p - (a + t * (b - a)));
}

// By the crossings of a ray, all rings together.
bool inside(std::span<const Ring> rings, Vec2 p) {
  bool result = false;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y)) result = !result;
    }
  }
  return result;
}

Ring circle(double radius, std::size_t count) {
  Ring ring;
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    ring.push_back({radius * std::cos(turn), radius * std::sin(turn)});
  }
  return ring;
}

// The sides of a polygon with whole coordinates, `count` edges a unit of length.
Ring polygon(std::span<const Vec2> corners, std::size_t count) {
  Ring ring;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
    const auto edges = count * static_cast<std::size_t>(std::lround(length(b - a)));
    for (std::size_t k = 0; k < edges; ++k)
      ring.push_back(a + (static_cast<double>(k) / static_cast<double>(edges)) * (b - a));
  }
  return ring;
}

std::vector<Ring> rings_of(Domain domain, double spacing) {
  const auto edges = [&](double whole) { return static_cast<std::size_t>(std::lround(whole / spacing)); };
  switch (domain) {
    case Domain::kDisk:
      return {circle(1, edges(2 * std::numbers::pi))};
    case Domain::kSquare:
      return {polygon(std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, edges(1))};
    case Domain::kAnnulus: {
      const std::size_t count = edges(std::numbers::pi * (kInnerRadius + kOuterRadius));
      return {circle(kInnerRadius, count), circle(kOuterRadius, count)};
    }
    case Domain::kLShape:
      break;
  }
  return {polygon(std::vector<Vec2>{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, edges(1))};
}

double area_of(Domain domain) {
  switch (domain) {
    case Domain::kDisk:
      return std::numbers::pi;
    case Domain::kSquare:
      return 1;
    case Domain::kAnnulus:
      return std::numbers::pi * (kOuterRadius * kOuterRadius - kInnerRadius * kInnerRadius);
    case Domain::kLShape:
      break;
  }
  return 3;
}

// The boundary and shaken points of a lattice inside.
std::vector<Vec2> spread_points(std::span<const Ring> rings, double spacing, const DomainPoints& options) {
  std::vector<Vec2> points;
  Box2 box;
  for (const Ring& ring : rings) {
    for (const Vec2 p : ring) box.extend(p);
    points.insert(points.end(), ring.begin(), ring.end());
  }
  const double margin = kMargin * options.boundary_spacing * spacing;
  for (const Vec2 p :
       make_spaced_points(box, {.spacing = spacing, .jitter = options.jitter, .seed = options.seed})) {
    if (!inside(rings, p)) continue;
    bool near = false;
    for (const Ring& ring : rings)
      for (std::size_t i = 0; i < ring.size() && !near; ++i)
        near = distance_to_segment(p, ring[i], ring[(i + 1) % ring.size()]) < margin;
    if (!near) points.push_back(p);
  }
  return points;
}

// The triangulation covers the convex hull.
Mesh without_outside(const Mesh& hull, std::span<const Ring> rings) {
  std::vector<FaceCorners> faces;
  for (const FaceId f : hull.faces()) {
    const FaceCorners corners{hull.corner(f, 0), hull.corner(f, 1), hull.corner(f, 2), VertexId()};
    const Vec2 sum = hull.point(corners[0]) + hull.point(corners[1]) + hull.point(corners[2]);
    if (inside(rings, (1.0 / 3) * sum)) faces.push_back(corners);
  }
  return build_mesh(hull.xs(), hull.ys(), faces);
}

}  // namespace

std::optional<Domain> domain_of(std::string_view name) {
  if (name == "disk") return Domain::kDisk;
  if (name == "square") return Domain::kSquare;
  if (name == "annulus") return Domain::kAnnulus;
  if (name == "l-shape") return Domain::kLShape;
  return std::nullopt;
}

Mesh triangulate(Domain domain, double triangles, const DomainPoints& options) {
  // The area of a triangle is sqrt(3) / 4 of the squared spacing.
  const double spacing = std::sqrt(area_of(domain) / triangles * 4 / std::numbers::sqrt3);
  const std::vector<Ring> rings = rings_of(domain, options.boundary_spacing * spacing);
  return without_outside(delaunay_triangulation(spread_points(rings, spacing, options)), rings);
}

Mesh split_quads(Domain domain, double quads, const DomainPoints& options) {
  Mesh triangles = triangulate(domain, quads / 3, options);
  ConstraintTags tags = ConstraintTags::add_to(triangles);
  for (const VertexId v : triangles.vertices())
    if (triangles.on_boundary(v)) tags.support[v] = Support::fixed();
  SubdivideReport report;
  Mesh mesh = subdivide(std::move(triangles), NodedLines(), report, Progress());
  compact(mesh, EntityOrder::kHilbert);
  return mesh;
}

}  // namespace quarry::bench
