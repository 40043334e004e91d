// Local clean-up of quads: small changes that make irregular vertices regular, until none is left that gains
// anything and keeps the faces around it good. The cheap first half of clean-up; patches do the rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/geometry/model.hpp"
#include "engine/mesh/mesh.hpp"
#include "engine/operation/pass.hpp"
#include "kernels/cleanup/irregular_price.hpp"

namespace quarry {

struct LocalCleanupOptions {
  int most_sweeps = 4;  // over all operators; ends before once a sweep changes nothing
  // A change stays if the worst scaled Jacobian around it is at least this afterwards, or no worse than
  // before.
  double floor = 0.3;
  std::uint32_t most_ways = 3;  // at one vertex and operator, one after the other fails
  // Energies of vertices are weighed with it, as it is where they lie at the start, in steps of a sixteenth
  // and from that to 64. A new vertex has the price of the one that it is split from.
  IrregularPrice price = {};
  bool reverse = false;  // of PassOptions, for tests
};

// What one operator did, all sweeps together.
struct LocalOperatorReport {
  // With the name of the operator. What is proposed and not live found no way that lowers the energy; what
  // the pass won was tried, and is one of the next three.
  PassReport pass;
  std::uint64_t won = 0;
  std::uint64_t invalid = 0;  // rejected: a face would not be valid, after smoothing
  std::uint64_t poor = 0;     // rejected: valid, but too bad
  double seconds = 0;
};

struct LocalCleanupReport {
  std::vector<LocalOperatorReport> operators;  // in the order in which they run
  int sweeps = 0;
  std::uint64_t irregular_before = 0, irregular_after = 0;  // vertices whose number of faces is not the ideal
  std::uint64_t energy_before = 0, energy_after = 0;        // valence energy of all vertices
  double seconds = 0;
};

// Cleans up a mesh that is cut open along its constraints (engine/mesh/sectors.hpp) and has ConstraintTags;
// the tag kIdealTag is made if there is none. Boundary sides and their ends stay as they are, fixed inner
// vertices too; other inner vertices move, go and come. The (weighed) valence energy falls with every change
// but those that mend faces which cannot be valid. Faces around a change are valid afterwards, exactly.
// Tombstones are left. The same result on any number of threads.
template <GeometryModel Model>
LocalCleanupReport clean_up_locally(Mesh& mesh, const Model& model, const LocalCleanupOptions& options,
                                    const Progress& progress);

extern template LocalCleanupReport clean_up_locally(Mesh&, const PlaneModel&, const LocalCleanupOptions&,
                                                    const Progress&);
extern template LocalCleanupReport clean_up_locally(Mesh&, const SpaceModel&, const LocalCleanupOptions&,
                                                    const Progress&);

}  // namespace quarry
