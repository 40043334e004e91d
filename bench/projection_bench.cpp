// Closest points a second on triangulated surfaces beside CGAL's AABB tree, on one thread: near the surface,
// as a mesher asks, one vertex after its neighbour; and anywhere about it. Prints a table; for
// docs/results.md.
//
//   projection_bench [FOLDER OF SURFACES]
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <ctime>
#include <fmt/format.h>

#include "bench/cgal_tree.hpp"
#include "engine/base/random.hpp"
#include "engine/geometry/box.hpp"
#include "engine/geometry/hilbert.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"
#include "io/mesh/obj_format.hpp"
#include "surface/project/triangle_tree.hpp"

namespace quarry::bench {
namespace {

constexpr int kRepeats = 5;
constexpr std::size_t kNearQueries = 200'000;
constexpr std::size_t kFarQueries = 50'000;
constexpr double kAnywhere = 0;  // in place of a part of an edge

struct Surface {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

Surface read_surface(const std::string& path) {
  const ReadCells cells = read_obj(path);
  Surface surface;
  for (std::size_t i = 0; i < cells.x.size(); ++i)
    surface.points.push_back({cells.x[i], cells.y[i], cells.z[i]});
  for (const FaceCorners& face : cells.faces)
    surface.triangles.push_back({face[0].value(), face[1].value(), face[2].value()});
  return surface;
}

// A torus with bumps, of 2 * side * side triangles.
Surface bumpy_torus(std::uint32_t side) {
  Surface surface;
  const double step = 2 * std::numbers::pi / side;
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      const double u = step * i, v = step * j;
      const double tube = 1 + 0.1 * std::sin(9 * u) * std::sin(7 * v);
      const double across = 3 + tube * std::cos(v);
      surface.points.push_back({across * std::cos(u), across * std::sin(u), tube * std::sin(v)});
      const std::uint32_t up = (i + 1) % side, right = (j + 1) % side;
      surface.triangles.push_back({i * side + j, up * side + j, up * side + right});
      surface.triangles.push_back({i * side + j, up * side + right, i * side + right});
    }
  }
  return surface;
}

Box3 box_of(const std::vector<Vec3>& points) {
  Box3 box;
  for (const Vec3 p : points) box.extend(p);
  return box;
}

double draw(std::uint64_t seed, std::size_t i) { return 2 * uniform01(seed, i) - 1; }

// Points of the surface, moved by up to a part of an edge in each direction, in the order of a mesh.
std::vector<Vec3> near_queries(const Surface& surface, double part) {
  std::vector<Vec3> points(kNearQueries);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto at = static_cast<std::size_t>(uniform01(1, i) * static_cast<double>(surface.triangles.size()));
    const auto& [a, b, c] = surface.triangles[at];
    double v = uniform01(2, i), w = uniform01(3, i);
    if (v + w > 1) v = 1 - v, w = 1 - w;
    const Vec3 ab = surface.points[b] - surface.points[a];
    const double most = part * length(ab);
    points[i] = surface.points[a] + v * ab + w * (surface.points[c] - surface.points[a]) +
                most * Vec3{draw(4, i), draw(5, i), draw(6, i)};
  }
  const Box3 box = box_of(points);
  std::vector<std::uint64_t> keys;
  for (const Vec3 p : points) keys.push_back(hilbert_key(p, box));
  std::vector<Vec3> ordered;
  for (const std::uint32_t i : parallel::sorted_order(keys)) ordered.push_back(points[i]);
  return ordered;
}

// In a cube twice as large as the surface's, in no order.
std::vector<Vec3> far_queries(const Surface& surface) {
  const Box3 box = box_of(surface.points);
  const Vec3 middle = box.low + 0.5 * (box.high - box.low);
  std::vector<Vec3> points(kFarQueries);
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = middle + box.longest_side() * Vec3{draw(7, i), draw(8, i), draw(9, i)};
  return points;
}

// Of the processor, so that other work on the machine counts little.
double seconds_of(auto&& work) {
  const std::clock_t began = std::clock();
  work();
  return static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

// Seconds of each way, run in turn.
struct Times {
  std::vector<double> peer, single, started, all;
};

Times time_ways(const TriangleTree& tree, const CgalTree& peer, const std::vector<Vec3>& points) {
  Times times;
  double sum = 0;  // read at the end, so that nothing is optimised away
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    times.peer.push_back(seconds_of([&] {
      for (const Vec3 p : points) sum += peer.closest(p).position.x;
    }));
    times.single.push_back(seconds_of([&] {
      for (const Vec3 p : points) sum += tree.closest(p).position.x;
    }));
    times.started.push_back(seconds_of([&] {
      ClosestQuery query;
      for (const Vec3 p : points) {
        query.start = tree.closest(p, query).triangle;
        sum += query.start.value();
      }
    }));
    times.all.push_back(seconds_of([&] { sum += tree.closest_all(points).back().position.x; }));
  }
  if (std::isnan(sum)) std::abort();
  return times;
}

// Both must agree on the distances, or the times mean nothing.
double largest_disagreement(const TriangleTree& tree, const CgalTree& peer, const std::vector<Vec3>& points) {
  double largest = 0;
  for (const Vec3 p : points) {
    const double ours = length(tree.closest(p).position - p);
    const double theirs = length(peer.closest(p).position - p);
    largest = std::max(largest, std::abs(ours - theirs));
  }
  return largest;
}

void print_rows(const char* name, const Surface& surface) {
  std::unique_ptr<TriangleTree> tree;
  std::unique_ptr<CgalTree> peer;
  const double build =
      seconds_of([&] { tree = std::make_unique<TriangleTree>(surface.points, surface.triangles); });
  const double peer_build =
      seconds_of([&] { peer = std::make_unique<CgalTree>(surface.points, surface.triangles); });
  for (const double part : {0.1, 0.5, kAnywhere}) {
    const std::vector<Vec3> points = part == kAnywhere ? far_queries(surface) : near_queries(surface, part);
    const std::string where = part == kAnywhere ? "anywhere" : fmt::format("{} edge", part);
    const Times times = time_ways(*tree, *peer, points);
    const auto rate = [&](const std::vector<double>& seconds) {
      return static_cast<double>(points.size()) / median(seconds) / 1e3;
    };
    const double theirs = rate(times.peer);
    std::printf("| %s | %zu | %s | %.0f | %.0f (%.1f) | %.0f (%.1f) | %.0f (%.1f) | %.2f / %.2f | %.0e |\n",
                name, surface.triangles.size(), where.c_str(), theirs, rate(times.single),
                rate(times.single) / theirs, rate(times.started), rate(times.started) / theirs,
                rate(times.all), rate(times.all) / theirs, build, peer_build,
                largest_disagreement(*tree, *peer, points));
    std::fflush(stdout);
  }
}

void print_table(const std::string& folder) {
  std::printf(
      "| surface | triangles | queries | CGAL | one by one | from the last answer | all at once | build s, "
      "here / "
      "CGAL | differ by |\n"
      "|---|---|---|---|---|---|---|---|---|\n");
  for (const char* name : {"koala_low", "hammer_scan"}) {
    const std::string path = folder + "/" + name + ".obj";
    if (std::filesystem::exists(path))
      print_rows(name, read_surface(path));
    else
      std::printf("| %s | absent: %s | | | | | | | |\n", name, path.c_str());
  }
  print_rows("bumpy torus", bumpy_torus(500));
}

}  // namespace
}  // namespace quarry::bench

int main(int count, char** values) {
  const std::string folder = count > 1 ? values[1] : "../shared/data/surface";
  quarry::parallel::with_threads(1, [&] { quarry::bench::print_table(folder); });
}
