#include <array>
#include <cmath>

#include <fmt/format.h>

#include "io/mapped_file.hpp"
#include "io/mesh/avs_format.hpp"
#include "io/mesh/content_lines.hpp"
#include "io/mesh/number_index.hpp"

namespace quarry {
namespace {

class AvsReader {
 public:
  AvsReader(const std::string& path, std::string_view text) : lines_(path, text, 0, '#') {}

  ReadCells read() {
    if (lines_.count() == 0) lines_.fail_at(0, "the file ends too early: the counts are missing");
    lines_.read(0, 1, [&](TextCursor& cursor, std::size_t) {
      for (auto [count, what] : {std::pair(&points_, "the number of points"),
                                 {&cells_count_, "the number of cells"},
                                 {&point_values_, "the number of values of a point"},
                                 {&cell_values_, "the number of values of a cell"}}) {
        const auto number = cursor.number_in_line<std::int64_t>(what);
        if (number < 0) cursor.fail(fmt::format("{} is {}", what, number));
        *count = static_cast<std::size_t>(number);
      }
    });
    next_ = 1;
    claim(points_, "points");
    read_points(next_ - points_);
    claim(cells_count_, "cells");
    read_raw_cells(next_ - cells_count_);
    if (point_values_ > 0) static_cast<void>(read_labels(point_values_, points_, "values of points"));
    std::vector<Label> labels;
    if (cell_values_ > 0) labels = read_labels(cell_values_, cells_count_, "values of cells");
    if (next_ < lines_.count() && model_data_free())
      lines_.fail_at(next_, "more lines follow than are announced");
    make_cells(labels);
    return std::move(cells_);
  }

 private:
  struct RawCell {
    std::int64_t number = 0;
    std::int32_t material = 0;
    int corners = 0;  // 0: passed over
    std::array<std::int64_t, 4> points{};
  };
  struct Label {
    std::string name;
    std::size_t column = 0;  // of its values, from 0
  };

  // Takes so many of the lines that are left.
  void claim(std::size_t count, const char* what) {
    if (count > lines_.count() - next_)
      lines_.fail_at(lines_.count(),
                     fmt::format("the file ends too early: {} {} are announced, {} lines follow", count, what,
                                 lines_.count() - next_));
    next_ += count;
  }

  // Values of the model as a whole may follow, and are passed over.
  [[nodiscard]] bool model_data_free() const {
    bool none = true;
    lines_.read(0, 1, [&](TextCursor& cursor, std::size_t) {
      for (int k = 0; k < 4; ++k) static_cast<void>(cursor.word());
      if (!cursor.at_line_end()) none = cursor.number_in_line<std::int64_t>("a count") == 0;
    });
    return none;
  }

  void read_points(std::size_t first) {
    std::vector<std::int64_t> numbers(points_);
    for (auto* coordinate : {&cells_.x, &cells_.y, &cells_.z}) coordinate->resize(points_);
    lines_.read(first, points_, [&](TextCursor& cursor, std::size_t i) {
      numbers[i] = cursor.number_in_line<std::int64_t>("the number of a point");
      cells_.x[i] = cursor.coordinate();
      cells_.y[i] = cursor.coordinate();
      cells_.z[i] = cursor.coordinate();
    });
    for (std::size_t i = 0; i < points_; ++i)
      if (!index_.add(numbers[i], static_cast<std::uint32_t>(i)))
        lines_.fail_at(first + i, fmt::format("point {} is there twice", numbers[i]));
  }

  static int corners_of(TextCursor& cursor) {
    const std::string_view type = cursor.word_in_line("the type of a cell");
    if (type == "pt") return 0;
    if (type == "line") return 2;
    if (type == "tri") return 3;
    if (type == "quad") return 4;
    cursor.fail(
        fmt::format("a cell of the type \"{}\"; pt, line, tri and quad are read", type.substr(0, 40)));
  }

  void read_raw_cells(std::size_t first) {
    raw_.resize(cells_count_);
    lines_.read(first, cells_count_, [&](TextCursor& cursor, std::size_t i) {
      RawCell& cell = raw_[i];
      cell.number = cursor.number_in_line<std::int64_t>("the number of a cell");
      cell.material = cursor.number_in_line<std::int32_t>("the material of a cell");
      cell.corners = corners_of(cursor);
      for (std::size_t k = 0; k < static_cast<std::size_t>(cell.corners); ++k) {
        cell.points[k] = cursor.number_in_line<std::int64_t>("the number of a point");
        if (index_.find(cell.points[k]) == NumberIndex::kNone)
          cursor.fail(fmt::format("point {} does not exist", cell.points[k]));
      }
    });
  }

  // A block of values: how many components of which sizes, a line with the name of each, then a line for each
  // of `items`.
  std::vector<Label> read_labels(std::size_t values, std::size_t items, const char* what) {
    claim(1, what);
    std::vector<std::size_t> sizes;
    std::size_t sum = 0;
    lines_.read(next_ - 1, 1, [&](TextCursor& cursor, std::size_t) {
      const auto count = cursor.number_in_line<std::int64_t>("the number of components");
      for (std::int64_t k = 0; k < count; ++k) {
        const auto size = cursor.number_in_line<std::int64_t>("the size of a component");
        if (size < 1 || static_cast<std::size_t>(size) > values - sum)
          cursor.fail(fmt::format("components of more or fewer than {} values in all", values));
        sum += static_cast<std::size_t>(size);
        sizes.push_back(static_cast<std::size_t>(size));
      }
      if (sum != values) cursor.fail(fmt::format("components of {} values in all, not {}", sum, values));
    });
    std::vector<Label> labels;
    std::size_t column = 0;
    for (const std::size_t size : sizes) {
      claim(1, what);
      lines_.read(next_ - 1, 1, [&](TextCursor& cursor, std::size_t) {
        const std::string_view line = cursor.line();
        const std::string_view name = line.substr(0, line.find(','));
        labels.push_back({std::string(name.substr(0, name.find_last_not_of(" \t\r") + 1)), column});
      });
      column += size;
    }
    claim(items, what);
    return labels;
  }

  // Whole numbers of one component, by the place of the cell in the file; empty if there is none of that
  // name.
  std::vector<std::int32_t> read_column(const std::vector<Label>& labels, std::string_view name,
                                        const NumberIndex& cell_index) const {
    const auto label =
        std::find_if(labels.begin(), labels.end(), [&](const Label& each) { return each.name == name; });
    if (label == labels.end()) return {};
    std::vector<std::int32_t> column(cells_count_, 0);
    std::vector<std::uint32_t> at(cells_count_);
    std::vector<std::int32_t> values(cells_count_);
    lines_.read(next_ - cells_count_, cells_count_, [&](TextCursor& cursor, std::size_t i) {
      const auto number = cursor.number_in_line<std::int64_t>("the number of a cell");
      at[i] = cell_index.find(number);
      if (at[i] == NumberIndex::kNone) cursor.fail(fmt::format("cell {} does not exist", number));
      for (std::size_t k = 0; k < label->column; ++k) static_cast<void>(cursor.word_in_line("a value"));
      const auto value = cursor.number_in_line<double>("a value");
      if (!(std::abs(value) < 2e9) || std::trunc(value) != value)
        cursor.fail(fmt::format("{} is {}, no whole number", name, value));
      values[i] = static_cast<std::int32_t>(value);
    });
    for (std::size_t i = 0; i < at.size(); ++i) column[at[i]] = values[i];
    return column;
  }

  void make_cells(const std::vector<Label>& labels) {
    NumberIndex cell_index;
    if (!labels.empty())
      for (std::size_t i = 0; i < raw_.size(); ++i)
        if (!cell_index.add(raw_[i].number, static_cast<std::uint32_t>(i)))
          lines_.fail_at(1 + points_ + i, fmt::format("cell {} is there twice", raw_[i].number));
    const std::vector<std::int32_t> regions = read_column(labels, "region", cell_index);
    const std::vector<std::int32_t> constraints = read_column(labels, "constraint", cell_index);
    const std::vector<std::int32_t> kinds = read_column(labels, "kind", cell_index);
    for (std::size_t i = 0; i < raw_.size(); ++i) {
      const RawCell& cell = raw_[i];
      const auto point = [&](std::size_t k) { return VertexId(std::size_t{index_.find(cell.points[k])}); };
      if (cell.corners == 2) {
        cells_.edges.emplace_back(point(0), point(1));
        cells_.constraints.push_back(constraints.empty() ? cell.material : constraints[i]);
        if (!kinds.empty()) cells_.kinds.push_back(kinds[i]);
      } else if (cell.corners > 2) {
        cells_.faces.push_back({point(0), point(1), point(2), cell.corners == 4 ? point(3) : VertexId()});
        cells_.regions.push_back(regions.empty() ? cell.material : regions[i]);
      }
    }
  }

  ContentLines lines_;
  NumberIndex index_;  // of points
  ReadCells cells_;
  std::vector<RawCell> raw_;
  std::size_t points_ = 0, cells_count_ = 0, point_values_ = 0, cell_values_ = 0;
  std::size_t next_ = 0;  // line
};

}  // namespace

ReadCells read_avs(const std::string& path) {
  const MappedFile file(path);
  return AvsReader(path, file.text()).read();
}

}  // namespace quarry
