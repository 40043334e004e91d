#include "io/lines/pline_reader.hpp"

#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/coordinate_limit.hpp"
#include "io/gocad_text.hpp"
#include "io/lines/line_attributes.hpp"
#include "io/mesh/number_index.hpp"

namespace quarry {
namespace {

class PlineReader {
 public:
  PlineReader(const LineSource& source, LineSet& lines)
      : source_(source), lines_(lines), text_(source.name, source.text), cursor_(text_.cursor()) {}

  void read() {
    while (text_.next_object()) {
      if (text_.sort() == "PLine")
        read_object();
      else
        text_.pass_object();
    }
  }

 private:
  void read_object() {
    const LineSetMark first = LineSetMark::of(lines_);
    points_.clear();
    point_of_ = {};
    begin_part();
    while (text_.next_line()) read_line();
    end_part();
    ++feature_;
    // Subtracting from 0 makes no negative zero.
    if (text_.depth())
      for (std::size_t i = first.lines; i < lines_.lines.size(); ++i)
        for (double& z : lines_.lines[LineId(i)].heights) z = 0 - z;
    attributes_.set("name", text_.name());
    attributes_.assign(first, lines_);
  }

  void read_line() {
    const std::string_view key = text_.key();
    if (key == "VRTX" || key == "PVRTX")
      read_point();
    else if (key == "ATOM" || key == "PATOM")
      read_atom();
    else if (key == "SEG")
      read_segment();
    else if (key == "ILINE")
      end_part();
    else
      return text_.read_attributes();
    cursor_.line();
  }

  std::int64_t number() { return cursor_.number_in_line<std::int64_t>("the number of a point"); }

  double coordinate() {
    const double value = cursor_.coordinate();
    if (!is_usable_coordinate(value))
      cursor_.fail(fmt::format("coordinate {} is not a usable number; the largest is {:g}", value,
                               kLargestCoordinate));
    return value;
  }

  void add_point(std::int64_t number, Vec3 point) {
    if (!point_of_.add(number, static_cast<std::uint32_t>(points_.size())))
      cursor_.fail(fmt::format("point {} is given twice", number));
    points_.push_back(point);
  }

  std::uint32_t find_point() {
    const std::int64_t wanted = number();
    const std::uint32_t index = point_of_.find(wanted);
    if (index == NumberIndex::kNone)
      cursor_.fail(fmt::format("point {} does not exist in this object before this line", wanted));
    return index;
  }

  void read_point() {
    const std::int64_t name = number();
    const double x = coordinate();
    const double y = coordinate();
    add_point(name, {x, y, coordinate()});
  }

  // Another number for a point.
  void read_atom() {
    const std::int64_t name = number();
    add_point(name, points_[find_point()]);
  }

  void read_segment() {
    const std::uint32_t from = find_point();
    const std::uint32_t to = find_point();
    if (segments_ == 0 || from != last_) {
      end_line();
      add(from);
    }
    add(to);
    last_ = to;
    ++segments_;
  }

  void add(std::uint32_t point) {
    const Vec3 p = points_[point];
    line_.points.push_back({p.x, p.y});
    line_.heights.push_back(p.z);
  }

  void end_line() {
    if (line_.points.empty()) return;
    line_.feature = feature_;
    append_line(source_, 1, std::exchange(line_, {}), lines_);
  }

  void begin_part() {
    segments_ = 0;
    first_point_ = points_.size();
  }

  void end_part() {
    if (segments_ == 0 && points_.size() - first_point_ > 1)
      for (std::size_t i = first_point_; i < points_.size(); ++i) add(static_cast<std::uint32_t>(i));
    end_line();
    begin_part();
  }

  const LineSource& source_;
  LineSet& lines_;
  GocadText text_;
  TextCursor& cursor_;
  AttributeCollector attributes_;
  std::uint32_t feature_ = 0;
  // Of the object that is read.
  std::vector<Vec3> points_;
  NumberIndex point_of_;
  // Of the part that is read.
  std::size_t first_point_ = 0;
  std::size_t segments_ = 0;
  std::uint32_t last_ = 0;
  InputLine line_;
};

}  // namespace

void read_pline_lines(const LineSource& source, LineSet& lines) { PlineReader(source, lines).read(); }

}  // namespace quarry
