#include "pipeline/surface/elements.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "surface/lattice/lattice.hpp"
#include "surface/remesh/remesh.hpp"

namespace quarry {
namespace {

// Triangles of this edge are to make quads of edge 1: two that are paired make four, one that is not makes
// three, as about one in eight does.
const double kTrianglesForQuads = std::sqrt(2.12 * 4 / std::sqrt(3.0));
// Of this edge, two that are matched make one.
const double kTrianglesForMatching = std::sqrt(2 / std::sqrt(3.0));
// A cell of the lattice makes four quads.
constexpr double kSpacingForQuads = 2;
// A lattice ends with a spacing so much larger than it begins with, by 1.01 to 1.11 where sheets meet, as it
// makes fewer cells than are wanted. Joins, which are divided before, so have as many parts as rims beside
// them: extruded networks of fractures have 0.2 to 0.7 % irregular vertices in place of 1.1 to 2.4.
constexpr double kJoinsForLattice = 1.03;
// The edge of the triangles that the fields are found on, in spacings: with 0.55 there are as many irregular
// vertices in the end, and it takes a third longer.
constexpr double kTrianglesForLattice = 0.8;
constexpr int kRoundsForLattice = 4;
// How many of the wanted quads the lattice is to make: the rest is for the clean-up, which removes more
// irregular vertices where it may add faces.
constexpr double kShareOfLattice = 0.96;

// Up to so many times as many cells as are wanted the lattice is taken. With more (boot_scan of
// odedstein/meshes with 10,000 quads: 1.31) there are more irregular vertices in the end than without one,
// with less (from 1.065 to 1.1: boot_scan with 50,000, demosthenes_low with 10,000) fewer.
constexpr double kMostCells = 1.1;

// Quads of a lattice begin nearly square: with the sweeps that others need the mean scaled Jacobian is 0.001
// to 0.002 higher with 50,000 quads, in 1.3 to 1.5 times the time.
constexpr int kFirstSweepsOfLattice = 3, kSweepsBetweenOfLattice = 1, kLastSweepsOfLattice = 10;

// Rounds of stars from which a quad takes its area where the wanted sizes differ from place to place.
constexpr int kAreaAverages = 8;

// What is farther from the triangles than this share of their square's edge counts as lost.
constexpr double kLostFrom = 0.6;

class ElementMaker {
 public:
  ElementMaker(const SurfaceToMesh& surface, const SurfaceOptions& options, SurfaceResult& result,
               std::vector<TightPlace>* lost, StageClock& clock, const Progress& progress)
      : surface_(surface),
        options_(options),
        result_(result),
        lost_(lost),
        clock_(clock),
        progress_(progress) {}

  ElementsMade run() {
    // With a wanted edge and details as many as there are: the details need more.
    if (options_.count || surface_.sizes.uniform())
      wanted_quads_ = surface_.area / (result_.size * result_.size);
    const bool by_field = result_.method == SurfaceQuads::kField;
    remesh(by_field ? kTrianglesForLattice : 1, by_field ? kRoundsForLattice : RemeshOptions().rounds);
    if (loses_surface()) return ElementsMade::kSurfaceLost;
    if (by_field && !make_lattice_triangles()) return ElementsMade::kTooManyCells;
    if (options_.elements != Elements::kTriangle) make_quads();
    return ElementsMade::kAll;
  }

 private:
  // share: of the edge that the method begins with.
  void remesh(double share, int rounds) {
    clock_.start("remeshing");
    RemeshOptions remesh;
    remesh.rounds = rounds;
    remesh.keep_rims = options_.keep_boundary;
    if (lost_ != nullptr) remesh.lost_from = kLostFrom;
    const double edge = share * first_edge(options_.elements, result_.method) * result_.size;
    if (options_.count)
      remesh.wanted_faces = surface_.area / (element_area(Elements::kTriangle) * edge * edge);
    result_.remesh = remesh_surface(result_.mesh, surface_.model, surface_.network,
                                    surface_.sizes.times(share), remesh, progress_);
  }

  // Tips that are cut off are reached by single vertices later, with edges as long as the tips.
  [[nodiscard]] bool loses_surface() {
    for (const Vec3 p : result_.remesh.lost)
      lost_->push_back({p, 0.5 * surface_.sizes.at(surface_.model.nearest({p, Vec3()}))});
    return !result_.remesh.lost.empty();
  }

  // False if it has too many cells.
  bool make_lattice_triangles() {
    clock_.start("finding a lattice");
    LatticeOptions lattice;
    lattice.wanted_cells = kShareOfLattice * wanted_quads_ / (kSpacingForQuads * kSpacingForQuads);
    result_.lattice =
        make_lattice(result_.mesh, surface_.model, surface_.network, surface_.sizes, lattice, progress_);
    const double wanted = wanted_quads_ > 0 ? lattice.wanted_cells : surface_.sizes.squares();
    return static_cast<double>(result_.mesh.count_alive_faces()) <= 2 * kMostCells * wanted;
  }

  void make_quads() {
    clock_.start("making quads");
    SurfaceQuadOptions quads;
    quads.cleanup = options_.cleanup;
    if (!surface_.sizes.uniform()) quads.area_averages = kAreaAverages;
    if (result_.method == SurfaceQuads::kMatching) quads.matching = matching();
    if (result_.method == SurfaceQuads::kField) {
      quads.first_sweeps = kFirstSweepsOfLattice;
      quads.sweeps_between = kSweepsBetweenOfLattice;
      quads.last_sweeps = kLastSweepsOfLattice;
    }
    quads.wanted_faces = static_cast<std::size_t>(wanted_quads_);
    result_.quads.matching = {};
    result_.mesh = make_surface_quads(std::move(result_.mesh), surface_.model, surface_.network, quads,
                                      result_.quads, progress_);
  }

  [[nodiscard]] MatchingOptions matching() const {
    MatchingOptions matching;
    matching.keep_boundary = options_.keep_boundary;
    matching.searching.annealing_sweeps = options_.anneal;
    matching.searching.seed = options_.seed;
    return matching;
  }

  const SurfaceToMesh& surface_;
  const SurfaceOptions& options_;
  SurfaceResult& result_;
  std::vector<TightPlace>* lost_;
  StageClock& clock_;
  const Progress& progress_;
  double wanted_quads_ = 0;  // 0: as many as the sizes make
};

}  // namespace

double element_area(Elements elements) { return elements == Elements::kTriangle ? 0.25 * std::sqrt(3.0) : 1; }

double first_edge(Elements elements, SurfaceQuads method) {
  if (elements == Elements::kTriangle) return 1;
  if (method == SurfaceQuads::kMatching) return kTrianglesForMatching;
  return method == SurfaceQuads::kField ? kSpacingForQuads : kTrianglesForQuads;
}

double join_edge(Elements elements, SurfaceQuads method) {
  const double edge = first_edge(elements, method);
  if (method == SurfaceQuads::kField) return kJoinsForLattice * edge;
  return method == SurfaceQuads::kMatching ? 2 * edge : edge;
}

ElementsMade make_elements(const SurfaceToMesh& surface, const SurfaceOptions& options, SurfaceResult& result,
                           std::vector<TightPlace>* lost, StageClock& clock, const Progress& progress) {
  return ElementMaker(surface, options, result, lost, clock, progress).run();
}

}  // namespace quarry
