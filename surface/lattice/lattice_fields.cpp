#include "surface/lattice/lattice_fields.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "engine/base/stopwatch.hpp"
#include "engine/mesh/sectors.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/crossfield/field_levels.hpp"
#include "kernels/crossfield/singularities.hpp"
#include "kernels/crossfield/spacing_field.hpp"
#include "surface/lattice/chain_places.hpp"
#include "surface/lattice/join_shared.hpp"

namespace quarry {
namespace {

// The coarsest level of the fields.
constexpr std::size_t kFewestVertices = 16;
// Two tangents that meet at so nearly 45 degrees leave no direction between them.
constexpr double kLeastSum = 0.1;
// Of one correction of the spacing.
constexpr double kMostCorrection = 1.15;

// The direction of what runs along a vertex of the boundary: as a cross that of its two edges there.
Vec3 direction_along(const Mesh& mesh, const FieldLevel& level, VertexId v) {
  const SideId out = mesh.side_of(v);
  SideId last = out;
  for (SideId s = mesh.turn_left(out); s.valid(); s = mesh.turn_left(s)) last = s;
  const Vec3 here = mesh.point3(v);
  const Vec2 a = cross_number(level, v.value(), mesh.point3(mesh.target(out)) - here);
  const Vec2 b = cross_number(level, v.value(), mesh.point3(mesh.origin(mesh.previous(last))) - here);
  return cross_direction(level, v.value(), length(a + b) > kLeastSum ? a + b : a);
}

class LatticeFields {
 public:
  LatticeFields(LatticeState& state, const LatticeOptions& options, LatticeReport& report)
      : state_(state), mesh_(state.base.mesh), options_(options), report_(report) {}

  void run(const Progress& progress) {
    find_crosses();
    double& scale = state_.base.scale;
    double best = scale, least = std::numeric_limits<double>::infinity();
    for (int attempt = 0; attempt < options_.attempts; ++attempt) {
      progress.throw_if_cancelled();
      find_places();
      if (!(options_.wanted_cells > 0)) break;
      const double share = cells() / options_.wanted_cells;
      const double miss = std::abs(share - 1);
      if (miss < least) best = scale;
      least = std::min(miss, least);
      if (miss <= options_.cell_tolerance) break;
      if (attempt + 1 < options_.attempts)
        scale *= std::clamp(std::sqrt(share), 1 / kMostCorrection, kMostCorrection);
    }
    // Rows come and go whole: of a handful of cells a correction may leave far fewer.
    if (options_.wanted_cells > 0 && scale != best) {
      scale = best;
      find_places();
    }
    report_.scale = scale;
  }

 private:
  void find_crosses() {
    const Stopwatch watch;
    cut_open(mesh_, state_.base.tags);
    const auto whole = mesh_.find_tag<VertexId, VertexId>(kWholeTag);
    std::vector<std::uint8_t> given(mesh_.vertex_slots());
    whole_.resize(mesh_.vertex_slots());
    for (const VertexId v : mesh_.vertices()) {
      whole_[v.value()] = whole_of(whole, v);
      given[v.value()] = !mesh_.alive(v) || mesh_.on_boundary(v) || !state_.base.tags.support[v].is_free();
    }
    FieldLevel finest = finest_level(mesh_, std::move(given));
    std::vector<Vec3> directions(finest.size());
    parallel::for_each(finest.size(), [&](std::size_t i) {
      const VertexId v(i);
      if (finest.given[i] == 0 || !mesh_.alive(v)) return;
      directions[i] = mesh_.on_boundary(v) ? direction_along(mesh_, finest, v) : finest.axes[i];
    });
    levels_ = field_levels(std::move(finest), kFewestVertices);
    crosses_ = cross_field(levels_, directions, options_.crosses);
    report_.vertices = mesh_.count_alive_vertices();
    report_.singularities = find_singularities(mesh_, levels_[0], crosses_).size();
    const std::vector<double> sources = spacing_sources(mesh_, levels_[0], crosses_);
    sew(mesh_, state_.base.tags);
    fit_spacing(sources);
    for (const VertexId v : mesh_.vertices())
      if (mesh_.alive(v) && state_.base.tags.support[v].is_free()) state_.along[v] = crosses_[v.value()];
    report_.cross_seconds += watch.seconds();
  }

  // sources: by vertex of the mesh that was cut open. Those of the sides of a feature add up.
  void fit_spacing(const std::vector<double>& sources) {
    if (!(options_.spacing.most > 0)) return;
    std::vector<double> sums(mesh_.vertex_slots());
    for (std::size_t i = 0; i < sources.size(); ++i) sums[whole_[i].value()] += sources[i];
    const std::vector<double> logarithms = spacing_field(mesh_, sums, options_.spacing);
    parallel::for_each(mesh_.vertex_slots(),
                       [&](std::size_t i) { state_.base.wanted[VertexId(i)] *= std::exp(logarithms[i]); });
  }

  void find_places() {
    const Stopwatch watch;
    place_on_chains(state_);
    std::vector<double> spacing(whole_.size());
    std::vector<Vec3> places(whole_.size());
    parallel::for_each(whole_.size(), [&](std::size_t i) {
      spacing[i] = state_.base.wanted_edge(whole_[i]);
      places[i] = state_.place[whole_[i]];
    });
    places = position_field(levels_, crosses_, spacing, places, options_.positions);
    parallel::for_each(whole_.size(), [&](std::size_t i) {
      const VertexId v(i);
      if (levels_[0].given[i] == 0 && mesh_.alive(v)) state_.place[v] = places[i];
    });
    report_.position_seconds += watch.seconds();
  }

  // Two triangles each, by Euler's formula but for what holes and handles add.
  [[nodiscard]] double cells() const {
    std::size_t rim = 0;
    for (const VertexId v : mesh_.vertices())
      if (mesh_.alive(v) && mesh_.on_boundary(v)) ++rim;
    const double kept =
        static_cast<double>(count_after_joins(state_)) / static_cast<double>(mesh_.count_alive_vertices());
    const double cells = kept * static_cast<double>(mesh_.count_alive_faces()) / 2 +
                         0.5 * (kept - std::sqrt(kept)) * static_cast<double>(rim);
    return std::max(cells, 0.0);  // of a handful of vertices it is no estimate
  }

  LatticeState& state_;
  Mesh& mesh_;
  const LatticeOptions& options_;
  LatticeReport& report_;
  std::vector<FieldLevel> levels_;
  std::vector<Vec3> crosses_;
  std::vector<VertexId> whole_;  // of each vertex of the mesh that was cut open
};

}  // namespace

void find_lattice_fields(LatticeState& state, const LatticeOptions& options, LatticeReport& report,
                         const Progress& progress) {
  LatticeFields(state, options, report).run(progress);
}

}  // namespace quarry
