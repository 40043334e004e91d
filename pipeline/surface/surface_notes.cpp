#include "pipeline/surface/surface_notes.hpp"

#include <fmt/format.h>

#include "surface/repair/cracks.hpp"

namespace quarry {

std::optional<std::string> crack_note(const RepairedSurface& repaired) {
  if (repaired.report.open_edges == 0) return {};
  const Cracks cracks = find_cracks(repaired.surface);
  if (!cracks.likely()) return {};
  return fmt::format(
      "{} of {} points on rims lie within {:.3g} of another one: if these are cracks, --weld {:.3g} closes "
      "them",
      cracks.near_others, cracks.rim_points, cracks.distance, cracks.distance);
}

std::optional<std::string> limit_note(const SurfaceSizes::Limited& limited) {
  if (!(limited.share > 0)) return {};
  return fmt::format(
      "elements are smaller than wanted on {:.3g} % of the surface, down to {:.3g} at ({:.9g}, {:.9g}, "
      "{:.9g}): "
      "details, walls or gaps ask for it",
      100 * limited.share, limited.smallest, limited.place.x, limited.place.y, limited.place.z);
}

std::string kept_rim_note(double longest) {
  return fmt::format(
      "--keep-boundary keeps edges of rims up to {:.4g} long, far longer than elements; take a --size of "
      "about "
      "that, or divide the rims before",
      longest);
}

std::string invalid_note(const std::vector<TightPlace>& invalid, double kept_rim) {
  const Vec3 p = invalid.front().place;
  const std::string what =
      fmt::format("{} elements are inverted, flat or upside down, the first at ({:.9g}, {:.9g}, {:.9g}): ",
                  invalid.size(), p.x, p.y, p.z);
  if (kept_rim > 0) return what + kept_rim_note(kept_rim);
  return what +
         "the surface has details, walls or strips between features smaller than the elements there, or runs "
         "through itself; take a smaller --size";
}

}  // namespace quarry
