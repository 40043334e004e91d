// The quality of a whole mesh in figures: what reports print and what quality demands are held
// against. Each measure of a face is defined in kernels/quality/element.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry {

struct ValueRange {
  double min = 0;
  double mean = 0;
  double max = 0;
};

// Figures of a set of faces; all are 0 where there is none.
struct ShapeSummary {
  static constexpr std::size_t kAngleBins = 9;  // of 10 degrees, from 0 to 90
  static constexpr std::size_t kUnitBins = 10;  // of 0.1, from 0 to 1; values outside are in none

  std::size_t faces = 0;
  ValueRange scaled_jacobian;
  std::size_t scaled_jacobian_below_0p2 = 0;
  std::size_t scaled_jacobian_not_positive = 0;
  std::array<std::size_t, kUnitBins> scaled_jacobian_histogram{};
  ValueRange min_angle;  // of the smallest inner angle of each face, degrees
  std::array<std::size_t, kAngleBins> min_angle_histogram{};
  double max_angle = 0;  // of all faces, degrees
  std::size_t max_angle_over_150 = 0;
  ValueRange lo_measure;  // of triangles alpha [Lo], of quads phi [LeeLo]
  std::array<std::size_t, kUnitBins> lo_histogram{};
  ValueRange aspect;  // longest by shortest edge
  double shortest_edge = 0;

  // Share of the faces, in [0, 1].
  [[nodiscard]] double share(std::size_t count) const {
    return faces == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(faces);
  }
};

// How many edges meet at the vertices that are not on the outer boundary.
struct ValenceSummary {
  int regular = 4;  // 4, or 6 where most faces are triangles
  std::size_t interior = 0;
  std::size_t irregular = 0;  // interior vertices of another valence
  std::size_t free = 0;       // interior vertices on no edge entity (constraint or boundary)
  std::size_t free_irregular = 0;
  std::vector<std::size_t> histogram;  // of interior vertices, by valence
  std::vector<std::size_t> free_histogram;

  [[nodiscard]] double irregular_share() const { return share(irregular, interior); }
  [[nodiscard]] double free_irregular_share() const { return share(free_irregular, free); }

 private:
  static double share(std::size_t count, std::size_t of) {
    return of == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(of);
  }
};

// How even the sizes are: a face is smaller than `first` in one of a hundred, larger than `last` in one of a
// hundred (nearest rank). In square input units; 0 without faces.
struct AreaPercentiles {
  double first = 0;
  double last = 0;

  [[nodiscard]] double ratio() const { return first > 0 ? last / first : 0.0; }
};

struct QualitySummary {
  std::size_t vertices = 0;
  std::size_t edges = 0;  // entities: constraint and boundary edges
  double area = 0;        // never negative: faces count by the orientation that most of the area has
  double boundary_length = 0;
  AreaPercentiles face_area;
  ShapeSummary triangles;
  ShapeSummary quads;
  ShapeSummary all;  // both
  ValenceSummary valence;
};

// Runs in parallel; every figure is the same on any number of threads.
[[nodiscard]] QualitySummary summarize_quality(const Mesh& mesh);

}  // namespace quarry
