#include "kernels/cluster/low_quads.hpp"

#include <algorithm>

#include "engine/mesh/balance.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cluster/cut_quad.hpp"
#include "kernels/quality/face.hpp"

namespace quarry {
namespace {

bool is_low_quad(const Mesh& mesh, FaceId f, double quality) {
  return mesh.alive(f) && mesh.corner_count(f) == 4 && scaled_jacobian(mesh, f) < quality;
}

}  // namespace

bool cut_would_help(const Mesh& mesh, FaceId f, const LowQuadOptions& options) {
  if (!is_low_quad(mesh, f, options.quality)) return false;
  const QuadCut cut = best_cut(mesh, f);
  return cut.valid() &&
         cut.quality >= std::min(options.quality, options.least_gain * scaled_jacobian(mesh, f));
}

LowQuadReport cut_low_quads(Mesh& mesh, const LowQuadOptions& options) {
  const std::vector<std::uint32_t> low = parallel::filter_indices(
      mesh.face_slots(), [&](std::size_t i) { return is_low_quad(mesh, FaceId(i), options.quality); });
  const BalanceGuard balance(mesh);
  LowQuadReport report;
  report.low = low.size();
  // Few, and each takes no longer than a look. No cut changes what another one sees.
  for (const std::uint32_t i : low) {
    const FaceId f(i);
    if (!cut_would_help(mesh, f, options)) continue;
    cut_quad(mesh, f, best_cut(mesh, f).from);
    ++report.cut;
  }
  balance.check("cutting low quads", mesh, GeometryCheck::kNone);
  return report;
}

}  // namespace quarry
