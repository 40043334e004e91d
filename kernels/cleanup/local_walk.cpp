#include "kernels/cleanup/local_operators.hpp"

namespace quarry {

bool PairWalk::wants(const LocalView& view, VertexId v) { return view.excess(v) != 0; }

bool PairWalk::find(const LocalView& view, VertexId v, std::uint32_t skip, Plan& plan) {
  BestOf<Plan> best(skip);
  // A strip is looked along only from an end that gains by itself: one end must, and each end is the
  // beginning for a vertex there. The first length that gains ends the search: a longer one moves more faces
  // for no more.
  const auto offer = [&](SideId rung, bool mirrored) {
    Strip strip;
    if (!strip.begin(view, rung) || !strip.extend(view)) return;
    const int start = strip.gain_at_start(view, mirrored);
    if (start <= 0) return;
    while (strip.extend(view)) {
      const int gain = start + strip.gain_at_end(view, mirrored);
      if (gain <= 0 || !strip.can_shear(view, mirrored)) continue;
      best.offer(gain, {rung, static_cast<std::uint8_t>(strip.quads()), mirrored});
      return;
    }
  };
  if (view.excess(v) > 0)
    for_each_strip_that_takes(view, v, offer);
  else
    for_each_strip_that_gives(view, v, offer);
  return best.take(plan);
}

void PairWalk::build(const LocalView& view, const Plan& plan, VertexId /*fresh_vertex*/,
                     LocalChange& change) {
  Strip::build(view, plan, change);
}

}  // namespace quarry
