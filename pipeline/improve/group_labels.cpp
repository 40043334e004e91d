#include "pipeline/improve/group_labels.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace quarry {
namespace {

constexpr double kNoAperture = std::numeric_limits<double>::quiet_NaN();

// Puts labels in the place of numbers: places in the list of all different keys, ascending, which it returns.
// fill(i, key) makes the key of the entry i.
template <class Key, class Fill>
std::vector<Key> replace_by_labels(std::vector<std::int32_t>& numbers, Fill&& fill) {
  std::map<Key, std::int32_t> found;
  Key key;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    key.clear();
    fill(i, key);
    numbers[i] = found.try_emplace(key, static_cast<std::int32_t>(found.size())).first->second;
  }
  std::vector<Key> keys;
  std::vector<std::int32_t> label_of(found.size());
  for (const auto& [each, order] : found) {
    label_of[static_cast<std::size_t>(order)] = static_cast<std::int32_t>(keys.size());
    keys.push_back(each);
  }
  for (std::int32_t& number : numbers) number = label_of[static_cast<std::size_t>(number)];
  return keys;
}

}  // namespace

GroupLabels::GroupLabels(ReadCells& cells) : groups_(groupings_of(cells)) {
  const std::vector<ReadGrouping> groups = std::exchange(cells.groups, {});
  const std::vector<double> apertures = std::exchange(cells.apertures, {});
  with_aperture_ = !apertures.empty();
  if (none()) return;
  for (const ReadGrouping& group : groups) {
    of_faces_.push_back(!group.of_faces.empty());
    of_edges_.push_back(!group.of_edges.empty());
  }
  const auto add_groups = [&](std::size_t i, std::vector<std::int32_t> ReadGrouping::*of, Key& key) {
    for (const ReadGrouping& group : groups) key.push_back((group.*of).empty() ? -1 : (group.*of)[i]);
  };
  face_keys_ = replace_by_labels<Key>(cells.regions, [&](std::size_t i, Key& key) {
    key.push_back(cells.regions[i]);
    add_groups(i, &ReadGrouping::of_faces, key);
  });
  edge_keys_ = replace_by_labels<Key>(cells.constraints, [&](std::size_t i, Key& key) {
    key.push_back(cells.constraints[i]);
    add_groups(i, &ReadGrouping::of_edges, key);
    const bool has_aperture = with_aperture_ && !std::isnan(apertures[i]);
    key.push_back(std::bit_cast<std::int64_t>(has_aperture ? apertures[i] : kNoAperture));
  });
  Key plain(groups.size() + 1, -1);
  plain.push_back(std::bit_cast<std::int64_t>(kNoAperture));
  for (std::int32_t& label : cells.constraints)
    if (edge_keys_[static_cast<std::size_t>(label)] == plain) label = -1;
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
