#include "io/lines/poly_reader.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "io/coordinate_limit.hpp"
#include "io/lines/companion_file.hpp"
#include "io/lines/line_attributes.hpp"
#include "io/lines/ring.hpp"
#include "io/lines/segment_chains.hpp"
#include "io/mapped_file.hpp"
#include "io/mesh/number_index.hpp"
#include "io/text_cursor.hpp"

namespace quarry {
namespace {

// Numbers of a file in which "#" starts a comment.
class PolyNumbers {
 public:
  PolyNumbers(const std::string& path, std::string_view text) : text_(text), cursor_(path, text) {}

  [[nodiscard]] bool at_end() {
    pass_comments();
    return cursor_.at_end();
  }
  template <class Number>
  Number next(const char* what) {
    pass_comments();
    return cursor_.number<Number>(what);
  }
  std::size_t count(const char* what) {
    const auto value = next<std::int64_t>(what);
    if (value < 0) cursor_.fail(fmt::format("{} is {}", what, value));
    return static_cast<std::size_t>(value);
  }
  double coordinate() {
    const auto value = next<double>("a coordinate");
    if (!is_usable_coordinate(value))
      cursor_.fail(fmt::format("coordinate {} is not a usable number; the largest is {:g}", value,
                               kLargestCoordinate));
    return value;
  }
  void pass(std::size_t count, const char* what) {
    for (; count > 0; --count) next<double>(what);
  }
  // Nothing but a comment is left on this line.
  [[nodiscard]] bool at_line_end() { return cursor_.at_line_end() || at_comment(); }
  [[noreturn]] void fail(const std::string& message) const { cursor_.fail(message); }

 private:
  [[nodiscard]] bool at_comment() const { return text_[cursor_.position()] == '#'; }
  void pass_comments() {
    while (!cursor_.at_end() && at_comment()) cursor_.line();
  }

  std::string_view text_;
  TextCursor cursor_;
};

class PolyReader {
 public:
  PolyReader(const LineSource& source, LineSet& lines)
      : source_(source), lines_(lines), numbers_(source.name, source.text) {}

  void read() {
    read_points(numbers_, true);
    read_segments();
    read_holes();
    for (const SegmentChain& chain : chain_segments(segments_, points_.size())) {
      Line line;
      for (const std::uint32_t point : chain.points) line.input.points.push_back(points_[point]);
      line.input.feature = static_cast<std::uint32_t>(found_.size());
      line.marker = chain.marker;
      if (line.input.closed()) line.area = std::abs(doubled_area(line.input.points));
      for (const Vec2 p : line.input.points) line.box.extend(p);
      found_.push_back(std::move(line));
    }
    if (!holes_.empty()) mark_rings();
    append_all();
    append_points();
  }

 private:
  struct Line {
    InputLine input;
    std::int64_t marker = 0;
    double area = 0;  // of closed ones, doubled
    Box2 box;
    bool hole = false;
    std::vector<std::size_t> holes;  // of a polygon
  };

  void read_points(PolyNumbers& numbers, bool may_be_beside) {
    const std::size_t count = numbers.count("the number of vertices");
    const std::size_t axes = numbers.count("the dimension");
    if (axes != 2) numbers.fail(fmt::format("the dimension is {}; it must be 2", axes));
    const std::size_t attributes = numbers.count("the number of attributes");
    const std::size_t markers = numbers.at_line_end() ? 0 : numbers.count("the number of markers, 0 or 1");
    if (count == 0 && may_be_beside) return read_points_beside();
    for (std::size_t i = 0; i < count; ++i) {
      const auto number = numbers.next<std::int64_t>("the number of a vertex");
      if (!point_of_.add(number, static_cast<std::uint32_t>(points_.size())))
        numbers.fail(fmt::format("vertex {} is given twice", number));
      const double x = numbers.coordinate();
      points_.push_back({x, numbers.coordinate()});
      numbers.pass(attributes, "an attribute");
      numbers.pass(markers, "a marker");
    }
  }

  void read_points_beside() {
    const std::string path = companion_file(source_.name, ".node");
    if (path.empty())
      numbers_.fail(fmt::format("no vertices, and there is no file {} with them",
                                std::filesystem::path(source_.name).replace_extension(".node").string()));
    const MappedFile file(path);
    PolyNumbers numbers(path, file.text());
    read_points(numbers, false);
  }

  std::uint32_t find_point() {
    const auto number = numbers_.next<std::int64_t>("the number of a vertex");
    const std::uint32_t index = point_of_.find(number);
    if (index == NumberIndex::kNone) numbers_.fail(fmt::format("vertex {} does not exist", number));
    return index;
  }

  void read_segments() {
    const std::size_t count = numbers_.count("the number of segments");
    const std::size_t markers = numbers_.at_line_end() ? 0 : numbers_.count("the number of markers, 0 or 1");
    for (std::size_t i = 0; i < count; ++i) {
      numbers_.next<std::int64_t>("the number of a segment");
      MarkedSegment segment;
      segment.from = find_point();
      segment.to = find_point();
      for (std::size_t k = 0; k < markers; ++k) segment.marker = numbers_.next<std::int64_t>("a marker");
      segments_.push_back(segment);
    }
  }

  void read_holes() {
    if (numbers_.at_end()) return;
    const std::size_t count = numbers_.count("the number of holes");
    for (std::size_t i = 0; i < count; ++i) {
      numbers_.next<std::int64_t>("the number of a hole");
      const double x = numbers_.coordinate();
      holes_.push_back({x, numbers_.coordinate()});
    }
  }

  // The smallest closed line around a point of which take(line) is true.
  template <class Take>
  std::optional<std::size_t> smallest_around(Vec2 p, Take&& take) const {
    std::optional<std::size_t> smallest;
    for (std::size_t i = 0; i < found_.size(); ++i)
      if (found_[i].area > 0 && take(i) && (!smallest || found_[i].area < found_[*smallest].area) &&
          found_[i].box.contains(p) && ring_holds(found_[i].input.points, p))
        smallest = i;
    return smallest;
  }

  void mark_rings() {
    std::vector<bool> outermost(found_.size(), false);
    for (std::size_t i = 0; i < found_.size(); ++i)
      outermost[i] = found_[i].area > 0 && !smallest_around(found_[i].input.points[0], [&](std::size_t k) {
                       return k != i && found_[k].area > found_[i].area;
                     });
    for (const Vec2 p : holes_) {
      const auto hole = smallest_around(p, [&](std::size_t i) { return !outermost[i]; });
      const auto polygon = smallest_around(p, [&](std::size_t i) { return outermost[i]; });
      if (!hole || !polygon) {
        log::warn("{}: the hole at {} lies within no closed line of one marker: it is meshed", source_.name,
                  format_point(p.x, p.y));
        continue;
      }
      if (found_[*hole].hole) continue;
      found_[*hole].hole = true;
      found_[*polygon].holes.push_back(*hole);
    }
    for (std::size_t i = 0; i < found_.size(); ++i) found_[i].input.polygon_ring = outermost[i];
  }

  void append(Line& line) {
    const LineSetMark first = LineSetMark::of(lines_);
    append_line(source_, 1, std::move(line.input), lines_);
    if (line.marker == 0) return;
    attributes_.set("set", static_cast<double>(line.marker));
    attributes_.assign(first, lines_);
  }

  // Holes follow their polygon.
  void append_all() {
    for (Line& line : found_) {
      if (line.hole) continue;
      append(line);
      for (const std::size_t hole : line.holes) {
        found_[hole].input.polygon_ring = found_[hole].input.hole = true;
        append(found_[hole]);
      }
    }
  }

  // Vertices of no segment are to become vertices of the mesh all the same.
  void append_points() {
    std::vector<bool> used(points_.size(), false);
    for (const MarkedSegment& segment : segments_) used[segment.from] = used[segment.to] = true;
    std::size_t feature = found_.size();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (used[i]) continue;
      InputPoint point{points_[i]};
      point.file = source_.file;
      point.feature = static_cast<std::uint32_t>(feature++);
      lines_.points.push_back(point);
    }
  }

  const LineSource& source_;
  LineSet& lines_;
  PolyNumbers numbers_;
  NumberIndex point_of_;
  std::vector<Vec2> points_;
  std::vector<MarkedSegment> segments_;
  std::vector<Vec2> holes_;
  std::vector<Line> found_;
  AttributeCollector attributes_;
};

}  // namespace

void read_poly_lines(const LineSource& source, LineSet& lines) { PolyReader(source, lines).read(); }

}  // namespace quarry
