#include "io/lines/shapefile_reader.hpp"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/coordinate_limit.hpp"
#include "io/lines/companion_file.hpp"
#include "io/lines/coordinate_system.hpp"
#include "io/lines/dbf_table.hpp"
#include "io/lines/ring.hpp"
#include "io/lines/shapelib_errors.hpp"
#include "io/mapped_file.hpp"
#include "io/text_rows.hpp"

namespace quarry {
namespace {

// "Any floating point number smaller than -10^38 is considered to represent a no data value."
constexpr double kNoData = -1e38;

struct CloseShapefile {
  void operator()(SHPInfo* file) const { SHPClose(file); }
};
struct DestroyShape {
  void operator()(SHPObject* shape) const { SHPDestroyObject(shape); }
};

bool is_point(int type) { return type % 10 == SHPT_POINT || type % 10 == SHPT_MULTIPOINT; }
bool is_polygon(int type) { return type % 10 == SHPT_POLYGON; }
bool has_heights(int type) { return type / 10 == 1; }

class ShapefileReader {
 public:
  ShapefileReader(const LineSource& source, LineSet& lines)
      : source_(source), lines_(lines), table_(companion_file(source.name, ".dbf")) {}

  void read() {
    if (companion_file(source_.name, ".shx").empty())
      fail("no .shx of the same name is beside it; a Shapefile is .shp, .shx, .dbf and .prj together");
    SAHooks hooks = make_shapelib_hooks();
    const std::unique_ptr<SHPInfo, CloseShapefile> file(SHPOpenLL(source_.name.c_str(), "rb", &hooks));
    if (!file) fail(fmt::format("no Shapefile, or a broken one: {}", shapelib_message));
    int count = 0;
    SHPGetInfo(file.get(), &count, nullptr, nullptr, nullptr);
    for (int i = 0; i < count; ++i) {
      const std::unique_ptr<SHPObject, DestroyShape> shape(SHPReadObject(file.get(), i));
      feature_ = static_cast<std::uint32_t>(i);
      if (!shape) fail_in_feature(fmt::format("cannot be read: {}", shapelib_message));
      const LineSetMark first = LineSetMark::of(lines_);
      read_shape(*shape);
      table_.read(i, attributes_);
      attributes_.assign(first, lines_);
    }
    attributes_.tell(source_.name);
    read_system();
  }

 private:
  struct Ring {
    InputLine line;
    bool hole = false;
    std::vector<std::size_t> holes;  // of an outer ring
  };

  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(ErrorKind::kInput, fmt::format("{}: {}", source_.name, problem));
  }
  [[noreturn]] void fail_in_feature(const std::string& problem) const {
    fail(fmt::format("feature {}: {}", feature_, problem));
  }

  void read_system() {
    const std::string path = companion_file(source_.name, ".prj");
    if (path.empty()) return;
    const MappedFile file(path);
    TextRows rows(file.text());
    std::string definition;
    while (rows.next()) definition += trimmed(rows.row());
    lines_.systems[source_.file] = describe_system(definition);
  }

  void read_shape(const SHPObject& shape) {
    if (shape.nSHPType == SHPT_MULTIPATCH)
      fail_in_feature("a patch of a surface; only lines and polygons are read");
    if (shape.nSHPType == SHPT_NULL) return;
    if (is_point(shape.nSHPType)) return read_points(shape);
    std::vector<Ring> rings;
    for (int part = 0; part < shape.nParts; ++part) {
      const int begin = shape.panPartStart[part];
      const int end = part + 1 < shape.nParts ? shape.panPartStart[part + 1] : shape.nVertices;
      if (begin < 0 || end < begin || end > shape.nVertices) fail_in_feature("its parts overlap");
      rings.emplace_back().line = read_part(shape, begin, end);
    }
    if (is_polygon(shape.nSHPType)) sort_rings(rings);
    for (Ring& ring : rings) {
      if (ring.hole) continue;
      lines_.lines.push_back(std::move(ring.line));
      for (const std::size_t hole : ring.holes) lines_.lines.push_back(std::move(rings[hole].line));
    }
  }

  void read_points(const SHPObject& shape) const {
    for (int i = 0; i < shape.nVertices; ++i) {
      InputPoint point{read_position(shape, i)};
      if (has_height(shape, i)) point.height = shape.padfZ[i];
      point.file = source_.file;
      point.feature = feature_;
      lines_.points.push_back(point);
    }
  }

  [[nodiscard]] Vec2 read_position(const SHPObject& shape, int i) const {
    const Vec2 p{shape.padfX[i], shape.padfY[i]};
    if (!is_usable_coordinate(p.x) || !is_usable_coordinate(p.y))
      fail_in_feature(
          fmt::format("position {}: ({}, {}) is not a usable point; the largest coordinate is {:g}", i + 1,
                      p.x, p.y, kLargestCoordinate));
    return p;
  }

  static bool has_height(const SHPObject& shape, int i) {
    return has_heights(shape.nSHPType) && shape.padfZ != nullptr && is_usable_coordinate(shape.padfZ[i]) &&
           shape.padfZ[i] > kNoData;
  }

  InputLine read_part(const SHPObject& shape, int begin, int end) const {
    InputLine line;
    bool heights = true;
    for (int i = begin; i < end; ++i) {
      line.points.push_back(read_position(shape, i));
      heights = heights && has_height(shape, i);
    }
    if (heights && end > begin) line.heights.assign(shape.padfZ + begin, shape.padfZ + end);
    if (line.points.size() == 1)
      fail_in_feature(fmt::format("a line of one point at {}; a line needs two points",
                                  format_point(line.points[0].x, line.points[0].y)));
    line.file = source_.file;
    line.feature = feature_;
    return line;
  }

  // A ring is a hole if it runs counter-clockwise and most of it lies within one that runs clockwise, the
  // smallest of those.
  static void sort_rings(std::vector<Ring>& rings) {
    std::vector<double> areas;
    for (Ring& ring : rings) {
      InputLine& line = ring.line;
      line.polygon_ring = true;
      if (line.points.size() > 1 && !(line.points.front() == line.points.back())) {
        line.points.push_back(line.points.front());
        if (!line.heights.empty()) line.heights.push_back(line.heights.front());
      }
      areas.push_back(doubled_area(line.points));
    }
    for (std::size_t i = 0; i < rings.size(); ++i) {
      if (areas[i] <= 0) continue;
      std::size_t outer = rings.size();
      for (std::size_t k = 0; k < rings.size(); ++k)
        if (areas[k] < 0 && (outer == rings.size() || areas[k] > areas[outer]) &&
            lies_within(rings[i].line.points, rings[k].line.points))
          outer = k;
      if (outer == rings.size()) continue;
      rings[i].hole = rings[i].line.hole = true;
      rings[outer].holes.push_back(i);
    }
  }

  // Most of the points: holes may touch the ring around them.
  static bool lies_within(const std::vector<Vec2>& points, const std::vector<Vec2>& ring) {
    std::size_t inside = 0;
    for (const Vec2 p : points) inside += ring_holds(ring, p) ? 1U : 0U;
    return 2 * inside > points.size();
  }

  const LineSource& source_;
  LineSet& lines_;
  DbfTable table_;
  AttributeCollector attributes_;
  std::uint32_t feature_ = 0;
};

}  // namespace

void read_shapefile_lines(const LineSource& source, LineSet& lines) { ShapefileReader(source, lines).read(); }

}  // namespace quarry
