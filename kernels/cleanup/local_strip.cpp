#include "kernels/cleanup/local_strip.hpp"

namespace quarry {

bool Strip::begin(const LocalView& view, SideId rung) {
  count_ = 0;
  if (!view.quad(rung.face())) return false;
  const Mesh& mesh = view.mesh;
  a_[1] = mesh.origin(rung);
  b_[1] = mesh.target(rung);
  b_[0] = mesh.target(mesh.next(rung));
  a_[0] = mesh.origin(mesh.previous(rung));
  faces_[0] = rung.face();
  last_ = rung;
  count_ = 1;
  return true;
}

bool Strip::meets(VertexId v) const {
  for (int i = 0; i <= count_; ++i)
    if (a(i) == v || b(i) == v) return true;
  return false;
}

bool Strip::extend(const LocalView& view) {
  if (count_ == kMostQuads) return false;
  const Mesh& mesh = view.mesh;
  const SideId across = mesh.neighbour(last_);
  if (!across.valid() || !view.quad(across.face())) return false;
  const SideId far = mesh.next(mesh.next(across));
  if (meets(mesh.origin(far)) || meets(mesh.target(far))) return false;
  const auto next = static_cast<std::size_t>(count_);
  faces_[next] = across.face();
  a_[next + 1] = mesh.origin(far);
  b_[next + 1] = mesh.target(far);
  last_ = far;
  ++count_;
  return true;
}

int Strip::gain_at_start(const LocalView& view, bool mirrored) const {
  return mirrored ? view.gain(a(0), 1) + view.gain(b(1), -1) : view.gain(b(0), 1) + view.gain(a(1), -1);
}

int Strip::gain_at_end(const LocalView& view, bool mirrored) const {
  return mirrored ? view.gain(b(count_), 1) + view.gain(a(count_ - 1), -1)
                  : view.gain(a(count_), 1) + view.gain(b(count_ - 1), -1);
}

bool Strip::can_shear(const LocalView& view, bool mirrored) const {
  if (!view.can_lose(mirrored ? b(1) : a(1)) || !view.can_lose(mirrored ? a(count_ - 1) : b(count_ - 1)))
    return false;
  for (int i = 1; i < count_; ++i)
    if (mirrored ? view.joined(b(i + 1), a(i - 1)) : view.joined(a(i + 1), b(i - 1))) return false;
  return true;
}

void Strip::shear(bool mirrored, LocalChange& change) const {
  change.old.assign(faces_.begin(), faces_.begin() + count_);
  const int last = count_;
  if (mirrored) {
    change.fresh.push_back({b(2), b(1), b(0), a(0)});
    for (int i = 1; i < last - 1; ++i) change.fresh.push_back({b(i + 2), b(i + 1), a(i - 1), a(i)});
    change.fresh.push_back({a(last - 2), a(last - 1), a(last), b(last)});
  } else {
    change.fresh.push_back({b(0), a(0), a(1), a(2)});
    for (int i = 1; i < last - 1; ++i) change.fresh.push_back({b(i), b(i - 1), a(i + 1), a(i + 2)});
    change.fresh.push_back({a(last), b(last), b(last - 1), b(last - 2)});
  }
}

void Strip::build(const LocalView& view, const Plan& plan, LocalChange& change) {
  Strip strip;
  strip.begin(view, plan.rung);
  while (strip.quads() < plan.quads) strip.extend(view);
  strip.shear(plan.mirrored, change);
}

}  // namespace quarry
