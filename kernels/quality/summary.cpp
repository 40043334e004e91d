#include "kernels/quality/summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/mesh/pinch.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/quality/face.hpp"
#include "kernels/quality/face_measures.hpp"

namespace quarry {
namespace {

FaceMeasures measures(const Mesh& mesh, FaceId f, bool clockwise) {
  return measure_face(mesh, f, [&](Vec2 a, Vec2 b, Vec2 c, auto... d) {
    if constexpr (sizeof...(d) == 0)
      return clockwise ? face_measures(a, c, b) : face_measures(a, b, c);
    else
      return clockwise ? face_measures(a, d..., c, b) : face_measures(a, b, c, d...);
  });
}

// A range whose mean is still a sum. An identity of merge() until a value is added.
constexpr ValueRange kNoValues{std::numeric_limits<double>::infinity(), 0.0,
                               -std::numeric_limits<double>::infinity()};

void add(ValueRange& range, double value) {
  range = {std::min(range.min, value), range.mean + value, std::max(range.max, value)};
}

void merge(ValueRange& range, const ValueRange& other) {
  range = {std::min(range.min, other.min), range.mean + other.mean, std::max(range.max, other.max)};
}

// Counts value in the bin [k width, (k + 1) width); the last bin holds its upper end too, with room for
// rounding. Values outside all bins (of inverted faces) are not counted.
template <std::size_t kBins>
void count(std::array<std::size_t, kBins>& histogram, double value, double width) {
  const double upper = static_cast<double>(kBins) * width;
  if (!(value >= 0 && value <= upper * (1 + 1e-9))) return;
  auto bin = std::min(static_cast<std::size_t>(value / width), kBins - 1);
  // The quotient may round across a border: the products are the borders.
  if (value < static_cast<double>(bin) * width) --bin;
  if (bin + 1 < kBins && value >= static_cast<double>(bin + 1) * width) ++bin;
  ++histogram[bin];
}

ShapeSummary no_faces() {
  ShapeSummary shape;
  shape.scaled_jacobian = shape.min_angle = shape.lo_measure = shape.aspect = kNoValues;
  shape.shortest_edge = std::numeric_limits<double>::infinity();
  return shape;
}

void add(ShapeSummary& shape, const FaceMeasures& face) {
  ++shape.faces;
  add(shape.scaled_jacobian, face.scaled_jacobian);
  shape.scaled_jacobian_below_0p2 += face.scaled_jacobian < 0.2 ? 1 : 0;
  shape.scaled_jacobian_not_positive += face.scaled_jacobian > 0 ? 0 : 1;
  count(shape.scaled_jacobian_histogram, face.scaled_jacobian, 0.1);
  add(shape.min_angle, face.angles.smallest);
  count(shape.min_angle_histogram, face.angles.smallest, 10.0);
  shape.max_angle = std::max(shape.max_angle, face.angles.largest);
  shape.max_angle_over_150 += face.angles.largest > 150 ? 1 : 0;
  add(shape.lo_measure, face.lo);
  count(shape.lo_histogram, face.lo, 0.1);
  add(shape.aspect, face.edges.ratio());
  shape.shortest_edge = std::min(shape.shortest_edge, face.edges.shortest);
}

template <std::size_t kBins>
void merge(std::array<std::size_t, kBins>& histogram, const std::array<std::size_t, kBins>& other) {
  for (std::size_t i = 0; i < kBins; ++i) histogram[i] += other[i];
}

ShapeSummary merged(ShapeSummary shape, const ShapeSummary& other) {
  shape.faces += other.faces;
  merge(shape.scaled_jacobian, other.scaled_jacobian);
  shape.scaled_jacobian_below_0p2 += other.scaled_jacobian_below_0p2;
  shape.scaled_jacobian_not_positive += other.scaled_jacobian_not_positive;
  merge(shape.scaled_jacobian_histogram, other.scaled_jacobian_histogram);
  merge(shape.min_angle, other.min_angle);
  merge(shape.min_angle_histogram, other.min_angle_histogram);
  shape.max_angle = std::max(shape.max_angle, other.max_angle);
  shape.max_angle_over_150 += other.max_angle_over_150;
  merge(shape.lo_measure, other.lo_measure);
  merge(shape.lo_histogram, other.lo_histogram);
  merge(shape.aspect, other.aspect);
  shape.shortest_edge = std::min(shape.shortest_edge, other.shortest_edge);
  return shape;
}

// Turns sums into means.
ShapeSummary finished(ShapeSummary shape) {
  if (shape.faces == 0) return {};
  for (ValueRange* range : {&shape.scaled_jacobian, &shape.min_angle, &shape.lo_measure, &shape.aspect})
    range->mean /= static_cast<double>(shape.faces);
  return shape;
}

// Signed area of the faces and length of their outer boundary.
struct Extent {
  double area = 0;
  double boundary = 0;
};

Extent measure_extent(const Mesh& mesh) {
  return parallel::reduce_ordered(
      mesh.face_slots(), Extent{},
      [&](std::size_t begin, std::size_t end) {
        Extent extent;
        for (std::size_t i = begin; i < end; ++i) {
          const FaceId f(i);
          if (!mesh.alive(f)) continue;
          extent.area += measure_face(mesh, f, [](auto... corners) { return signed_area(corners...); });
          for (int k = 0; k < mesh.corner_count(f); ++k) {
            const SideId s(f, k);
            if (!mesh.neighbour(s).valid())
              extent.boundary += length(mesh.point3(mesh.target(s)) - mesh.point3(mesh.origin(s)));
          }
        }
        return extent;
      },
      [](Extent a, Extent b) {
        return Extent{a.area + b.area, a.boundary + b.boundary};
      });
}

double unsigned_area(const Mesh& mesh, FaceId f) {
  return std::abs(measure_face(mesh, f, [](auto... corners) { return signed_area(corners...); }));
}

AreaPercentiles measure_area_percentiles(const Mesh& mesh) {
  const std::vector<std::uint32_t> faces =
      parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) { return mesh.alive(FaceId(i)); });
  if (faces.empty()) return {};
  std::vector<double> areas(faces.size());
  parallel::for_each(faces.size(), [&](std::size_t i) { areas[i] = unsigned_area(mesh, FaceId(faces[i])); });
  const auto at_share = [&](double share) {
    const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(areas.size() - 1) + 0.5);
    std::nth_element(areas.begin(), areas.begin() + rank, areas.end());
    return areas[static_cast<std::size_t>(rank)];
  };
  return {at_share(0.01), at_share(0.99)};
}

struct Shapes {
  ShapeSummary triangles = no_faces();
  ShapeSummary quads = no_faces();
};

Shapes measure_shapes(const Mesh& mesh, bool clockwise) {
  return parallel::reduce_ordered(
      mesh.face_slots(), Shapes{},
      [&](std::size_t begin, std::size_t end) {
        Shapes shapes;
        for (std::size_t i = begin; i < end; ++i) {
          const FaceId f(i);
          if (!mesh.alive(f)) continue;
          add(mesh.corner_count(f) == 4 ? shapes.quads : shapes.triangles, measures(mesh, f, clockwise));
        }
        return shapes;
      },
      [](const Shapes& a, const Shapes& b) {
        return Shapes{merged(a.triangles, b.triangles), merged(a.quads, b.quads)};
      });
}

std::vector<std::uint8_t> vertices_on_edges(const Mesh& mesh) {
  std::vector<std::uint8_t> on(mesh.vertex_slots(), 0);
  for (const EdgeId e : mesh.edges()) {
    const auto [a, b] = mesh.edge_ends(e);
    on[a.value()] = on[b.value()] = 1;
  }
  return on;
}

void count_valence(std::vector<std::size_t>& histogram, std::size_t valence, std::size_t vertices = 1) {
  if (histogram.size() <= valence) histogram.resize(valence + 1, 0);
  histogram[valence] += vertices;
}

void add_vertex(ValenceSummary& summary, std::size_t valence, bool free) {
  count_valence(summary.histogram, valence);
  if (free) count_valence(summary.free_histogram, valence);
  const bool irregular = valence != static_cast<std::size_t>(summary.regular);
  ++summary.interior;
  summary.irregular += irregular ? 1 : 0;
  summary.free += free ? 1 : 0;
  summary.free_irregular += free && irregular ? 1 : 0;
}

ValenceSummary merged(ValenceSummary summary, const ValenceSummary& other) {
  summary.interior += other.interior;
  summary.irregular += other.irregular;
  summary.free += other.free;
  summary.free_irregular += other.free_irregular;
  for (std::size_t i = 0; i < other.histogram.size(); ++i)
    count_valence(summary.histogram, i, other.histogram[i]);
  for (std::size_t i = 0; i < other.free_histogram.size(); ++i)
    count_valence(summary.free_histogram, i, other.free_histogram[i]);
  return summary;
}

ValenceSummary measure_valence(const Mesh& mesh, int regular) {
  const std::vector<std::uint8_t> held = vertices_on_edges(mesh);
  ValenceSummary none;
  none.regular = regular;
  return parallel::reduce_ordered(
      mesh.vertex_slots(), none,
      [&](std::size_t begin, std::size_t end) {
        ValenceSummary summary = none;
        for (std::size_t i = begin; i < end; ++i) {
          const VertexId v(i);
          if (!mesh.alive(v) || mesh.on_boundary(v)) continue;
          std::size_t valence = 0;
          for_each_side_around(mesh, v, [&](SideId) { ++valence; });
          add_vertex(summary, valence, held[i] == 0);
        }
        return summary;
      },
      [](ValenceSummary a, const ValenceSummary& b) { return merged(std::move(a), b); });
}

}  // namespace

QualitySummary summarize_quality(const Mesh& mesh) {
  QualitySummary summary;
  summary.vertices = mesh.count_alive_vertices() - pinch_twins(mesh).size();
  summary.edges = mesh.edge_slots();
  const Extent extent = measure_extent(mesh);
  summary.area = std::abs(extent.area);
  summary.boundary_length = extent.boundary;
  summary.face_area = measure_area_percentiles(mesh);
  const Shapes shapes = measure_shapes(mesh, extent.area < 0);
  summary.triangles = finished(shapes.triangles);
  summary.quads = finished(shapes.quads);
  summary.all = finished(merged(shapes.triangles, shapes.quads));
  summary.valence = measure_valence(mesh, shapes.quads.faces >= shapes.triangles.faces ? 4 : 6);
  return summary;
}

}  // namespace quarry
