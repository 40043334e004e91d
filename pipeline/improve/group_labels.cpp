#include "pipeline/improve/group_labels.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace quarry {
namespace {

constexpr double kNoAperture = std::numeric_limits<double>::quiet_NaN();

}  // namespace

GroupLabels::GroupLabels(ReadCells& cells) {
  const std::vector<ReadGrouping> groups = std::exchange(cells.groups, {});
  const std::vector<double> apertures = std::exchange(cells.apertures, {});
  with_aperture_ = !apertures.empty();
  for (const ReadGrouping& group : groups) {
    groups_.push_back(group.grouping);
    of_faces_.push_back(!group.of_faces.empty());
    of_edges_.push_back(!group.of_edges.empty());
  }
  if (none()) return;
  const auto keys_of = [&](const std::vector<std::int32_t>& numbers,
                           std::vector<std::int32_t> ReadGrouping::*of) {
    std::vector<Key> keys(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      keys[i].push_back(numbers[i]);
      for (const ReadGrouping& group : groups) keys[i].push_back((group.*of).empty() ? -1 : (group.*of)[i]);
    }
    return keys;
  };
  face_keys_ = replace(cells.regions, keys_of(cells.regions, &ReadGrouping::of_faces));
  std::vector<Key> edges = keys_of(cells.constraints, &ReadGrouping::of_edges);
  for (std::size_t i = 0; i < edges.size(); ++i)
    edges[i].push_back(std::bit_cast<std::int64_t>(
        with_aperture_ && !std::isnan(apertures[i]) ? apertures[i] : kNoAperture));
  Key plain(groups.size() + 1, -1);
  plain.push_back(std::bit_cast<std::int64_t>(kNoAperture));
  std::vector<bool> is_plain(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) is_plain[i] = edges[i] == plain;
  edge_keys_ = replace(cells.constraints, edges);
  for (std::size_t i = 0; i < is_plain.size(); ++i)
    if (is_plain[i]) cells.constraints[i] = -1;
}

std::vector<GroupLabels::Key> GroupLabels::replace(std::vector<std::int32_t>& numbers,
                                                   const std::vector<Key>& keys) {
  std::vector<Key> labels = keys;
  std::ranges::sort(labels);
  labels.erase(std::ranges::unique(labels).begin(), labels.end());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = static_cast<std::int32_t>(std::ranges::lower_bound(labels, keys[i]) - labels.begin());
  return labels;
}

std::int32_t GroupLabels::constraint(std::int32_t label) const {
  return none() || label < 0 ? label
                             : static_cast<std::int32_t>(edge_keys_[static_cast<std::size_t>(label)][0]);
}

void GroupLabels::restore(Mesh& mesh) const {
  if (none()) return;
  const auto region = mesh.find_tag<FaceId, std::int32_t>("region");
  const auto constraint = mesh.find_tag<EdgeId, std::int32_t>("constraint");
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (of_faces_[g]) {
      auto tag = mesh.add_tag<FaceId, std::int32_t>(groups_[g].tag, -1);
      for (const FaceId f : mesh.faces())
        tag[f] = static_cast<std::int32_t>(face_keys_[static_cast<std::size_t>(region[f])][g + 1]);
    }
    if (!of_edges_[g]) continue;
    auto tag = mesh.add_tag<EdgeId, std::int32_t>(groups_[g].tag, -1);
    for (const EdgeId e : mesh.edges())
      if (constraint[e] >= 0)
        tag[e] = static_cast<std::int32_t>(edge_keys_[static_cast<std::size_t>(constraint[e])][g + 1]);
  }
  if (with_aperture_) {
    auto tag = mesh.add_tag<EdgeId, double>(kApertureTag, kNoAperture);
    for (const EdgeId e : mesh.edges())
      if (constraint[e] >= 0)
        tag[e] = std::bit_cast<double>(edge_keys_[static_cast<std::size_t>(constraint[e])].back());
  }
  auto numbers = region;
  auto lines = constraint;
  for (const FaceId f : mesh.faces())
    numbers[f] = static_cast<std::int32_t>(face_keys_[static_cast<std::size_t>(numbers[f])][0]);
  for (const EdgeId e : mesh.edges()) lines[e] = this->constraint(lines[e]);
}

}  // namespace quarry
