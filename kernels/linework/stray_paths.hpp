// Paths that bending has led away from their raw lines, brought back.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/linework/clean_lines.hpp"
#include "kernels/linework/conflicts.hpp"
#include "kernels/linework/node_buckets.hpp"
#include "kernels/linework/node_places.hpp"
#include "kernels/linework/path_network.hpp"

namespace quarry::linework {

class StrayPaths {
 public:
  // budget: how far a line may be from its raw course in the end.
  StrayPaths(PathNetwork& network, NodePlaces& places, double snap, double budget, CleanCounts& counts);

  // Lays paths anew around edges that are too far from the stretches they stand for, and around these stuck
  // edges of the last build_edges(); whether that changed any path.
  bool lay_anew(std::span<const Hit> stuck);

  // A long edge that is bent through one node after another of a line that slowly leaves it would be drawn
  // along with that line (the drift of iterated snap rounding: Packer 2008). Where an edge is too far from
  // the stretch that it stands for, the path is brought back to the raw line by a node on it.
  void anchor();

 private:
  // Most paths stay as they are from one round to the next, and need not be measured again.
  void check();
  // Marks the edges of a path that are to be laid anew; whether there are any.
  bool mark_far_edges(std::size_t p, const std::vector<std::uint8_t>& stuck_edges,
                      std::vector<std::uint8_t>& marked) const;
  bool lay_path_anew(Path& path, const std::vector<std::uint8_t>& marked);
  void anchor_path(Path& path);
  // The parameter at which a path should return to its raw line between two steps; that of the first if it
  // need not.
  [[nodiscard]] double anchor_parameter(const Path& path, std::size_t i) const;
  [[nodiscard]] double deviation_of(const Path& path, std::size_t i) const;
  // The paths of which holds(path number, scratch) is true, ascending.
  template <class Holds>
  std::vector<std::uint32_t> paths_where(Holds&& holds) const;

  PathNetwork& network_;
  NodePlaces& places_;
  double snap_;
  double too_far_;
  CleanCounts& counts_;
  NodeBuckets anchors_;  // the places of all that were put
};

}  // namespace quarry::linework
