// The surface job: reads a triangulated surface, repairs it, finds its features and meshes it anew with
// triangles of a wanted size that lie on it. Nothing is written here.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/mesh/mesh.hpp"
#include "io/mesh/mesh_file.hpp"
#include "pipeline/report/stages.hpp"
#include "pipeline/section/options.hpp"
#include "surface/feature/options.hpp"
#include "surface/imprint/imprint.hpp"
#include "surface/lattice/options.hpp"
#include "surface/quads/quads.hpp"
#include "surface/remesh/options.hpp"
#include "surface/repair/repair.hpp"

namespace quarry {

// How quads are made.
enum class SurfaceQuads : std::uint8_t {
  kField,     // from triangles in rows that follow a field of crosses (surface/lattice)
  kCluster,   // from triangles that are nearly equilateral, where two make a good one; edges are halved
  kMatching,  // from triangles that are nearly equilateral, any two of which become one
};
// The word of the command line: field, cluster, matching.
[[nodiscard]] const char* name_of(SurfaceQuads method);

struct SurfaceOptions {
  std::vector<std::string> inputs;
  // Files of lines that lie on or near the surface and become chains of edges; and how near to a point or an
  // edge of the surface they go through it, by default 0.05 of the size.
  std::vector<std::string> lines;
  std::optional<double> snap;
  // Wanted edge of the final elements in input units; or about how many elements. Exactly one is given.
  std::optional<double> size;
  std::optional<double> count;
  // How far from the surface the middle of an edge may lie, in input units: elements are smaller where it is
  // curved.
  std::optional<double> curvature;
  double max_elements = 2e8;
  Elements elements = Elements::kQuad;  // or kTriangle
  // Surfaces whose sheets meet are clustered where a field is asked for: what they have in common is divided
  // before. So are those whose elements would come out inverted in another way; the result says which it was.
  SurfaceQuads method = SurfaceQuads::kField;
  // Rims keep their own vertices, none added and none moved. With kMatching, or triangles.
  bool keep_boundary = false;
  // Of kMatching: sweeps of annealing, and what they are drawn by.
  int anneal = 0;
  std::uint64_t seed = 0;
  CleanUpLevel cleanup = CleanUpLevel::kFull;
  RepairOptions repair;
  FeatureOptions features;  // its size is set by the job
};

struct FeatureCounts {
  double sharp_degrees = 0;  // as used; 180: no edge is sharp
  std::uint64_t nodes = 0, curves = 0;
  std::uint64_t sharp_edges = 0, border_edges = 0, rim_edges = 0, join_edges = 0;  // of the input
};

struct SurfaceResult {
  // Faces with the tag "region": the group of the input's triangles; edge entities on features with the tags
  // "constraint" (number of the line in reading order; of other features that of the curve, counted on from
  // the lines) and "kind". Vertices where sheets meet are there once for each sheet, marked as in
  // engine/mesh/pinch.hpp: one point in a file. Compact, in Hilbert order.
  Mesh mesh;
  GroupNames names;  // of the groups of the input
  TriangleSurface repaired;
  RepairReport repair;
  FeatureCounts features;
  ImprintReport imprint;
  LineSet lines;    // read
  double size = 0;  // as used
  RemeshReport remesh;
  SurfaceQuads method = SurfaceQuads::kCluster;  // as used
  LatticeReport lattice;                         // of kField
  SurfaceQuadReport quads;
  std::vector<std::string> notes;  // one line each: what the user should know
  std::vector<StageTime> times;
};

// Throws Error: see the kinds in engine/base/error.hpp and docs/contract.md. Into the result goes what is
// found, step by step: after an error it holds what was known by then (the repaired surface and what was
// repaired).
void mesh_surface(const SurfaceOptions& options, SurfaceResult& result, const Progress& progress);
[[nodiscard]] SurfaceResult mesh_surface(const SurfaceOptions& options, const Progress& progress);

}  // namespace quarry
