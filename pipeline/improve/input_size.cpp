#include "pipeline/improve/input_size.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geometry/hilbert.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"
#include "kernels/quality/face.hpp"

namespace quarry {
namespace {

// Faces whose mean is taken.
constexpr std::ptrdiff_t kEnough = 12;

Vec2 middle_of(const Mesh& mesh, FaceId f) {
  Vec2 sum{0, 0};
  const int count = mesh.corner_count(f);
  for (int k = 0; k < count; ++k) sum = sum + mesh.point(mesh.corner(f, k));
  return (1.0 / count) * sum;
}

double quad_area_of(const Mesh& mesh, FaceId f) {
  const double area = measure_face(mesh, f, [](auto... corners) { return signed_area(corners...); });
  return std::abs(area) * (mesh.corner_count(f) == 3 ? 2 : 1);
}

}  // namespace

InputSize::InputSize(const Mesh& mesh) : box_(mesh.box()) {
  const std::vector<std::uint32_t> faces =
      parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) { return mesh.alive(FaceId(i)); });
  keys_.resize(faces.size());
  std::vector<double> areas(faces.size());
  parallel::for_each(faces.size(), [&](std::size_t i) {
    keys_[i] = hilbert_key(middle_of(mesh, FaceId(faces[i])), box_);
    areas[i] = quad_area_of(mesh, FaceId(faces[i]));
  });
  std::vector<std::uint32_t> order(faces.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
  parallel::stable_sort_by_key(keys_, order);
  area_before_.reserve(faces.size() + 1);
  area_before_.push_back(0);
  for (const std::uint32_t i : order) area_before_.push_back(area_before_.back() + areas[i]);
}

double InputSize::at(Vec2 p) const {
  const std::uint64_t key = hilbert_key(p, box_);
  auto begin = keys_.begin();
  auto end = keys_.end();
  for (unsigned depth = 1; depth <= kHilbertOrder2; ++depth) {
    const unsigned shift = 2 * (kHilbertOrder2 - depth);
    const std::uint64_t first = (key >> shift) << shift;
    const auto cell_begin = std::lower_bound(begin, end, first);
    const auto cell_end = std::lower_bound(cell_begin, end, first + (std::uint64_t{1} << shift));
    if (cell_end - cell_begin < kEnough) break;
    begin = cell_begin;
    end = cell_end;
  }
  const double area = area_before_[static_cast<std::size_t>(end - keys_.begin())] -
                      area_before_[static_cast<std::size_t>(begin - keys_.begin())];
  const double mean = area / static_cast<double>(end - begin);
  // Cells of faces without area, of a mesh that is invalid, want the smallest size that there is.
  return std::sqrt(std::max(mean, std::numeric_limits<double>::min()));
}

}  // namespace quarry
