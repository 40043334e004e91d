#include "kernels/smooth/wanted_areas.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/parallel/parallel.hpp"
#include "kernels/quality/element.hpp"
#include "kernels/quality/face.hpp"

namespace quarry {
namespace {

// The mean of a face and its neighbours, over and over: what is large among small ones stands back.
IdVector<FaceId, double> mean_areas(const Mesh& mesh) {
  constexpr int kRounds = 14;
  IdVector<FaceId, double> areas(mesh.face_slots(), 0.0);
  parallel::for_each(mesh.face_slots(), [&](std::size_t i) {
    if (mesh.alive(FaceId(i))) areas[FaceId(i)] = std::abs(corner_area(mesh, FaceId(i)));
  });
  IdVector<FaceId, double> before(mesh.face_slots(), 0.0);
  for (int round = 0; round < kRounds; ++round) {
    std::swap(before, areas);
    parallel::for_each(mesh.face_slots(), [&](std::size_t i) {
      const FaceId f(i);
      if (!mesh.alive(f)) return;
      double sum = before[f];
      double count = 1;
      for (int k = 0; k < mesh.corner_count(f); ++k) {
        const SideId across = mesh.neighbour(SideId(f, k));
        if (!across.valid()) continue;
        sum += before[across.face()];
        count += 1;
      }
      areas[f] = sum / count;
    });
  }
  return areas;
}

struct Areas {
  double present = 0, wanted = 0;
};

// The squares of the wanted edges at the middles of the faces, scaled so that their sum is the present area.
IdVector<FaceId, double> areas_by_size(const Mesh& mesh, const SizeField& size) {
  IdVector<FaceId, double> areas(mesh.face_slots(), 0.0);
  const Areas sums = parallel::reduce_ordered(
      mesh.face_slots(), Areas(),
      [&](std::size_t begin, std::size_t end) {
        Areas part;
        for (std::size_t i = begin; i < end; ++i) {
          const FaceId f(i);
          if (!mesh.alive(f)) continue;
          const Vec2 middle = midpoint(mesh.point(mesh.corner(f, 0)), mesh.point(mesh.corner(f, 2)));
          const double edge = size.at(middle);
          areas[f] = edge * edge;
          part.present += corner_area(mesh, f);
          part.wanted += areas[f];
        }
        return part;
      },
      [](Areas a, Areas b) {
        return Areas{a.present + b.present, a.wanted + b.wanted};
      });
  const double factor = sums.present / sums.wanted;
  parallel::for_each(areas.size(), [&](std::size_t i) { areas[FaceId(i)] *= factor; });
  return areas;
}

}  // namespace

double corner_area(const Mesh& mesh, FaceId f) {
  const double area = measure_face(mesh, f, [](auto... corners) { return signed_area(corners...); });
  return mesh.corner_count(f) == 4 ? area : 2 * area;
}

IdVector<FaceId, double> wanted_areas(const Mesh& mesh, const SizeField* size) {
  return size != nullptr ? areas_by_size(mesh, *size) : mean_areas(mesh);
}

IdVector<FaceId, AreaDemand> area_demands(const Mesh& mesh, double evenness, const SizeField* size) {
  // Where the faces around are by more than this factor smaller or larger than wanted there is no room: the
  // demand fades with the square of what is beyond.
  constexpr double kWithinReach = 2;
  IdVector<FaceId, AreaDemand> demands;
  if (!(evenness > 0)) return demands;
  const IdVector<FaceId, double> around = wanted_areas(mesh, nullptr);
  const IdVector<FaceId, double> wanted = size != nullptr ? wanted_areas(mesh, size) : around;
  demands.resize(mesh.face_slots());
  parallel::for_each(mesh.face_slots(), [&](std::size_t i) {
    const FaceId f(i);
    if (!mesh.alive(f)) return;
    const double reach = kWithinReach * std::min(around[f], wanted[f]) / std::max(around[f], wanted[f]);
    demands[f] = {wanted[f], evenness * std::min(1.0, reach * reach)};
  });
  return demands;
}

}  // namespace quarry
