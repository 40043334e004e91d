// Groups of faces and edges beside regions and lines (zones, names, materials, apertures) while a mesh is
// improved: faces and edges that agree in their number and in all groups bear one label in the place of the
// number, and get all of it back afterwards.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/mesh/mesh.hpp"
#include "io/mesh/read_cells.hpp"

namespace quarry {

class GroupLabels {
 public:
  GroupLabels() = default;
  // Takes the groups and apertures out of the cells and puts labels in the place of their regions and
  // constraints: from 0, in the order of the numbers; -1 for edges without number and groups. Cells without
  // groups keep their numbers.
  explicit GroupLabels(ReadCells& cells);

  // Puts numbers and groups in the place of the labels "region" (of faces) and "constraint" (of edges).
  void restore(Mesh& mesh) const;

  // The number of a line that a label of edges stands for.
  [[nodiscard]] std::int32_t constraint(std::int32_t label) const;
  [[nodiscard]] const std::vector<Grouping>& groups() const { return groups_; }

 private:
  // A number, the place in each grouping, and for edges the bits of the aperture.
  using Key = std::vector<std::int64_t>;
  [[nodiscard]] bool none() const { return groups_.empty() && !with_aperture_; }

  std::vector<Grouping> groups_;
  std::vector<bool> of_faces_, of_edges_;  // whether faces, or edges, are in a grouping
  bool with_aperture_ = false;
  std::vector<Key> face_keys_, edge_keys_;  // by label
};

}  // namespace quarry
