// Longitude and latitude to the plane, by PROJ.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/coordinate_limit.hpp"
#include "io/lines/coordinate_system.hpp"
#include "io/lines/proj_context.hpp"

namespace quarry {
namespace {

constexpr double kSouthernmost = -80, kNorthernmost = 84, kZoneWidth = 6;
constexpr int kZones = 60;
// From the central meridian of a zone, in degrees: farther away its plane is no map any more.
constexpr double kFarthestLongitude = 20;
constexpr double kFullTurn = 360;

const std::string& definition_of(const LineSet& lines, std::uint32_t file) {
  return lines.systems[file].definition;
}

// Of the files in degrees; turn: what is added to negative longitudes.
Box2 box_in_degrees(const LineSet& lines, double turn) {
  Box2 box;
  const auto extend = [&](Vec2 p) { box.extend({p.x < 0 ? p.x + turn : p.x, p.y}); };
  for (const InputLine& line : lines.lines)
    if (lines.systems[line.file].geographic)
      for (const Vec2 p : line.points) extend(p);
  for (const InputPoint& point : lines.points)
    if (lines.systems[point.file].geographic) extend(point.place);
  return box;
}

// The middle of the lines. Those that seem to go around more than half of the earth are taken to lie across
// the antimeridian.
Vec2 middle_in_degrees(const LineSet& lines) {
  const Box2 box = box_in_degrees(lines, 0);
  if (!(box.low.x < 0 && box.width() > kFullTurn / 2)) return box.center();
  const Vec2 middle = box_in_degrees(lines, kFullTurn).center();
  return {middle.x > kFullTurn / 2 ? middle.x - kFullTurn : middle.x, middle.y};
}

struct Zone {
  int number;
  bool north;

  [[nodiscard]] double central_meridian() const { return kZoneWidth * (number - 0.5) - kFullTurn / 2; }
};

Zone zone_of(const LineSet& lines) {
  const auto [longitude, latitude] = middle_in_degrees(lines);
  if (!(latitude >= kSouthernmost && latitude <= kNorthernmost && longitude >= -180 && longitude <= 180))
    throw Error(ErrorKind::kInput,
                fmt::format("{}: the middle of the lines, {}, lies in no UTM zone; project them yourself",
                            lines.files.front(), format_point(longitude, latitude)));
  const int number = static_cast<int>(std::floor((longitude + 180) / kZoneWidth)) + 1;
  return {std::min(number, kZones), latitude >= 0};
}

void require_near(const Zone& zone, Vec2 p, std::uint32_t feature, const std::string& file) {
  const double away = std::abs(std::remainder(p.x - zone.central_meridian(), kFullTurn));
  if (away > kFarthestLongitude)
    throw Error(
        ErrorKind::kInput,
        fmt::format("{}: feature {}: {} is {:.6g} degrees of longitude away from the middle of UTM zone "
                    "{}, and {} are the most: the lines fit no zone; project them yourself",
                    file, feature, format_point(p.x, p.y), away, zone.number, kFarthestLongitude));
}

// Of the files in degrees.
void require_near(const Zone& zone, const LineSet& lines) {
  for (const InputLine& line : lines.lines)
    if (lines.systems[line.file].geographic)
      for (const Vec2 p : line.points) require_near(zone, p, line.feature, lines.files[line.file]);
  for (const InputPoint& point : lines.points)
    if (lines.systems[point.file].geographic)
      require_near(zone, point.place, point.feature, lines.files[point.file]);
}

class Projector {
 public:
  explicit Projector(std::string target) : target_(std::move(target)), context_(make_proj_context()) {}

  void project(LineSet& lines) {
    for (std::uint32_t file = 0; file < lines.files.size(); ++file) {
      const std::string& definition = definition_of(lines, file);
      if (definition.empty())
        throw Error(ErrorKind::kInput,
                    fmt::format("{}: does not say what its coordinates are (no crs, no .prj), so "
                                "that they cannot be projected with those of the other files",
                                lines.files[file]));
      const ProjObject raw(
          proj_create_crs_to_crs(context_.get(), definition.c_str(), target_.c_str(), nullptr));
      const ProjObject transform(raw ? proj_normalize_for_visualization(context_.get(), raw.get()) : nullptr);
      if (!transform)
        throw Error(ErrorKind::kInput, fmt::format("{}: PROJ does not know its coordinate system: {}",
                                                   lines.files[file], definition.substr(0, 200)));
      for (InputLine& line : lines.lines)
        if (line.file == file)
          for (Vec2& p : line.points) p = projected(p, line.feature, lines.files[file], transform.get());
      for (InputPoint& point : lines.points)
        if (point.file == file)
          point.place = projected(point.place, point.feature, lines.files[file], transform.get());
    }
  }

 private:
  static Vec2 projected(Vec2 p, std::uint32_t feature, const std::string& file, PJ* transform) {
    const PJ_COORD result = proj_trans(transform, PJ_FWD, proj_coord(p.x, p.y, 0, HUGE_VAL));
    if (!is_usable_coordinate(result.xy.x) || !is_usable_coordinate(result.xy.y))
      throw Error(ErrorKind::kInput, fmt::format("{}: feature {}: {} has no place in the plane; correct or "
                                                 "remove it",
                                                 file, feature, format_point(p.x, p.y)));
    return {result.xy.x, result.xy.y};
  }

  std::string target_;
  ProjContext context_;
};

}  // namespace

std::string project_to_utm(LineSet& lines, LineSet* extra) {
  const Zone zone = zone_of(lines);
  require_near(zone, lines);
  if (extra != nullptr) require_near(zone, *extra);
  const int code = (zone.north ? 32600 : 32700) + zone.number;
  Projector projector(fmt::format("EPSG:{}", code));
  projector.project(lines);
  if (extra != nullptr) projector.project(*extra);
  return fmt::format("EPSG:{} (WGS 84 / UTM zone {}{})", code, zone.number, zone.north ? 'N' : 'S');
}

}  // namespace quarry
