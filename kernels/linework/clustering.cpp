#include "kernels/linework/clustering.hpp"

#include <numbers>
#include <utility>

#include "kernels/linework/lonely_points.hpp"
#include "kernels/linework/node_buckets.hpp"
#include "kernels/linework/place_order.hpp"

namespace quarry::linework {
namespace {

// Points become nodes one after the other, unless a node is near. That takes one thread, but most points have
// no other near them: those are found first, by all, and need not be looked up.
class Clustering {
 public:
  Clustering(std::vector<RawLine> raw, double apart) : apart_(apart), buckets_(origin_of(raw), apart) {
    network_.raw = std::move(raw);
    for (const RawLine& line : network_.raw) {
      begin_.push_back(points_.size());
      points_.insert(points_.end(), line.points.begin(), line.points.end());
    }
    begin_.push_back(points_.size());
    node_of_.resize(points_.size());
  }

  PathNetwork run() {
    lonely_ = lonely_points(points_, apart_);
    for (std::size_t r = 0; r < network_.raw.size(); ++r)
      if (network_.raw[r].outline)
        for (std::size_t i = begin_[r]; i < begin_[r + 1]; ++i) (void)node_at(i);
    // Rather a line to a point of the input than that to the line.
    for (std::size_t r = 0; r < network_.raw.size(); ++r)
      if (network_.raw[r].point.valid()) (void)node_at(begin_[r]);
    for (std::size_t r = 0; r < network_.raw.size(); ++r)
      if (begin_[r] != begin_[r + 1])
        for (const std::size_t i : {begin_[r], begin_[r + 1] - 1}) (void)node_at(i);
    network_.paths.resize(network_.raw.size());
    for (std::size_t r = 0; r < network_.raw.size(); ++r) {
      Path& path = network_.paths[r];
      path.raw = static_cast<std::uint32_t>(r);
      path.outline = network_.raw[r].outline;
      path.steps.reserve(begin_[r + 1] - begin_[r]);
      for (std::size_t i = begin_[r]; i < begin_[r + 1]; ++i)
        path.steps.push_back({node_at(i), static_cast<double>(i - begin_[r])});
    }
    network_.drop_repeated_steps();
    order_by_place(network_);
    return std::move(network_);
  }

 private:
  NodeId node_at(std::size_t i) {
    NodeId& node = node_of_[i];
    if (lonely_[i] != 0) {
      if (!node.valid()) node = network_.nodes.push_back(points_[i]);
      return node;
    }
    // Asked anew each time: a nearer node may have come since.
    node = buckets_.nearest(points_[i]);
    if (!node.valid()) {
      node = network_.nodes.push_back(points_[i]);
      buckets_.insert(node, points_[i]);
    }
    return node;
  }

  double apart_;
  PathNetwork network_;
  NodeBuckets buckets_;
  std::vector<Vec2> points_;        // of all raw lines
  std::vector<std::size_t> begin_;  // of each raw line in them
  std::vector<std::uint8_t> lonely_;
  std::vector<NodeId> node_of_;
};

}  // namespace

PathNetwork cluster_points(std::vector<RawLine> raw, double snap) {
  return Clustering(std::move(raw), std::numbers::sqrt2 * snap).run();
}

}  // namespace quarry::linework
