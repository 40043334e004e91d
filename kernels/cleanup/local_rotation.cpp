#include "kernels/cleanup/local_operators.hpp"

namespace quarry {

bool EdgeRotation::wants(const LocalView& view, VertexId v) { return view.excess(v) != 0; }

bool EdgeRotation::find(const LocalView& view, VertexId v, std::uint32_t skip, Plan& plan) {
  BestOf<Plan> best(skip);
  const auto offer = [&](SideId rung, bool mirrored) {
    Strip strip;
    if (!strip.begin(view, rung) || !strip.extend(view)) return;
    const int gain = strip.gain_at_start(view, mirrored) + strip.gain_at_end(view, mirrored);
    if (gain > 0 && strip.can_shear(view, mirrored)) best.offer(gain, {rung, 2, mirrored});
  };
  if (view.excess(v) > 0)
    for_each_strip_that_takes(view, v, offer);
  else
    for_each_strip_that_gives(view, v, offer);
  return best.take(plan);
}

void EdgeRotation::build(const LocalView& view, const Plan& plan, VertexId /*fresh_vertex*/,
                         LocalChange& change) {
  Strip::build(view, plan, change);
}

}  // namespace quarry
