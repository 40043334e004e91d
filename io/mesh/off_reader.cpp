#include <fmt/format.h>

#include "io/mapped_file.hpp"
#include "io/mesh/content_lines.hpp"
#include "io/mesh/counted_face.hpp"
#include "io/mesh/off_format.hpp"

namespace quarry {
namespace {

class OffReader {
 public:
  OffReader(const std::string& path, std::string_view text) : path_(path), text_(text), cursor_(path, text) {}

  ReadCells read() {
    read_keyword(content_word());
    points_ = read_count("the number of points");
    faces_ = read_count("the number of faces");
    pass_edges();
    const ContentLines lines(path_, text_, cursor_.position(), '#');
    check_counts(lines);
    read_points(lines);
    cells_.faces.resize(faces_);
    cells_.regions.assign(faces_, 0);
    lines.read(points_, faces_, [&](TextCursor& cursor, std::size_t i) {
      cells_.faces[i] = read_counted_face(cursor, points_);
    });
    return std::move(cells_);
  }

 private:
  // The next word that is not in a comment.
  std::string_view content_word() {
    for (;;) {
      const std::string_view word = cursor_.word();
      if (!word.starts_with('#')) return word;
      cursor_.line();
    }
  }

  // [ST][C][N][4][n]OFF
  void read_keyword(std::string_view word) {
    const std::string_view whole = word;
    const auto take = [&](std::string_view prefix) {
      const bool taken = word.starts_with(prefix);
      if (taken) word.remove_prefix(prefix.size());
      return taken;
    };
    take("ST");
    take("C");
    take("N");
    const bool more_coordinates = take("4") || take("n");
    if (word != "OFF")
      cursor_.fail(fmt::format("OFF, COFF, NOFF or STOFF is expected, not \"{}\"", whole.substr(0, 40)));
    if (more_coordinates) cursor_.fail(fmt::format("{}: only points of three coordinates are read", whole));
  }

  std::size_t read_count(const char* what) {
    const std::string_view word = content_word();
    if (word == "BINARY") cursor_.fail("binary OFF is not read; save it as text");
    const auto count = cursor_.parse<std::int64_t>(word, what);
    if (count < 0) cursor_.fail(fmt::format("{} is {}", what, count));
    return static_cast<std::size_t>(count);
  }

  // The number of edges, which many files leave out and none means.
  void pass_edges() {
    if (!cursor_.at_line_end() && text_[cursor_.position()] != '#') {
      cursor_.number_in_line<std::int64_t>("the number of edges");
      if (!cursor_.at_line_end() && text_[cursor_.position()] != '#')
        cursor_.fail(
            "three counts stand on a line of their own, each point and face after them on one of its");
    }
    cursor_.line();
  }

  // Before anything that has the size of a count is asked of memory.
  void check_counts(const ContentLines& lines) const {
    const std::size_t found = lines.count();
    if (points_ > found || faces_ > found - points_)
      lines.fail_at(found, fmt::format("the file ends too early: {} points and {} faces are announced, {} "
                                       "lines follow",
                                       points_, faces_, found));
    if (points_ + faces_ < found)
      lines.fail_at(points_ + faces_,
                    fmt::format("more lines follow than the {} points and {} faces that are "
                                "announced",
                                points_, faces_));
  }

  void read_points(const ContentLines& lines) {
    for (auto* coordinate : {&cells_.x, &cells_.y, &cells_.z}) coordinate->resize(points_);
    lines.read(0, points_, [&](TextCursor& cursor, std::size_t i) {
      cells_.x[i] = cursor.coordinate();
      cells_.y[i] = cursor.coordinate();
      cells_.z[i] = cursor.coordinate();
    });
  }

  const std::string& path_;
  std::string_view text_;
  TextCursor cursor_;
  ReadCells cells_;
  std::size_t points_ = 0;
  std::size_t faces_ = 0;
};

}  // namespace

ReadCells read_off(const std::string& path) {
  const MappedFile file(path);
  return OffReader(path, file.text()).read();
}

}  // namespace quarry
