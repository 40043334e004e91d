// One-defect patches (Bunin 2006): around irregular vertices, regions are found that can be meshed anew with
// fewer of them. One call treats one size class; sweeps over the whole mesh belong between the classes.
#pragma once

#include <vector>

#include "engine/base/progress.hpp"
#include "engine/geometry/model.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/cleanup/patch_memory.hpp"
#include "kernels/cleanup/patch_options.hpp"
#include "kernels/cleanup/patch_report.hpp"

namespace quarry {

// Searches around all irregular vertices, a part of them at a time, then around those that commits have
// changed, until nothing is found. Each commit lowers the valence energy; boundary vertices and sides stay as
// they are, pinned vertices too. The mesh: cut open along constraints, or sewn again along its pieces, with
// ConstraintTags and the vertex tag "ideal_faces". Lines that are not cut open stay where they are, sides
// stay tagged, and their vertices too; their number may change. Triangles are left alone: no patch contains
// one. Tombstones stay. The result does not depend on the number of threads.
//
// memory: new, or that of the size classes before; the mesh keeps the tag kSignatureTag, which belongs to it.
template <GeometryModel Model>
PatchReport remesh_patches(Mesh& cut_open, const Model& model, const PatchOptions& options,
                           PatchMemory& memory, const Progress& progress);

extern template PatchReport remesh_patches<PlaneModel>(Mesh&, const PlaneModel&, const PatchOptions&,
                                                       PatchMemory&, const Progress&);
extern template PatchReport remesh_patches<SpaceModel>(Mesh&, const SpaceModel&, const PatchOptions&,
                                                       PatchMemory&, const Progress&);

// The size classes to run one after the other: 32, 128, ... and `largest`. With fewest, as few irregular
// vertices as possible at the price of bent rows, they go on doubling until they hold all faces.
[[nodiscard]] std::vector<std::size_t> patch_classes(std::size_t largest, bool fewest, std::size_t faces);

}  // namespace quarry
