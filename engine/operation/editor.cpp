#include "engine/operation/editor.hpp"

#include <algorithm>
#include <mutex>

#include <fmt/format.h>

namespace quarry {
namespace {

struct Violations {
  std::mutex mutex;
  ClaimViolations seen;
};

Violations& violations() {
  static Violations instance;
  return instance;
}

}  // namespace

void MeshEditor::require_claimed(VertexId v, const char* what) const {
  if (v >= first_.vertex && v < end_.vertex) return;
  if (std::find(claims_.begin(), claims_.end(), v) != claims_.end()) return;
  const std::scoped_lock lock(violations().mutex);
  if (violations().seen.count++ == 0)
    violations().seen.first =
        fmt::format("an operation {} vertex {}, which it did not claim", what, v.value());
}

void MeshEditor::require_face_claimed(FaceId f, const char* what) const {
  if (f >= first_.face && f < end_.face) return;
  if (!mesh_->alive(f)) return;
  for (int i = 0; i < mesh_->corner_count(f); ++i) require_claimed(mesh_->corner(f, i), what);
}

ClaimViolations claim_violations() {
  const std::scoped_lock lock(violations().mutex);
  return violations().seen;
}

void reset_claim_violations() {
  const std::scoped_lock lock(violations().mutex);
  violations().seen = {};
}

}  // namespace quarry
