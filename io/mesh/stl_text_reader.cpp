#include <algorithm>

#include <cctype>
#include <fmt/format.h>

#include "io/mesh/group_name.hpp"
#include "io/mesh/stl_format.hpp"
#include "io/mesh/weld_points.hpp"
#include "io/text_cursor.hpp"

namespace quarry {
namespace {

// Where a solid begins or ends.
struct StlBorder {
  std::size_t corner;  // of those in its part: the first after it
  bool begins;
  std::string_view name;  // of a solid that begins
};

struct StlPart {
  std::vector<Vec3> corners;
  std::vector<StlBorder> borders;
};

std::string_view trimmed_name(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
}

class StlPartReader {
 public:
  StlPartReader(const std::string& path, std::string_view text, TextPart part) : cursor_(path, text, part) {}

  StlPart read() {
    while (!cursor_.at_end()) {
      const std::string_view key = cursor_.word();
      if (same_stl_word(key, "facet"))
        read_facet();
      else if (same_stl_word(key, "solid"))
        part_.borders.push_back({part_.corners.size(), true, trimmed_name(cursor_.line())});
      else if (same_stl_word(key, "endsolid"))
        end_solid();
      else
        fail_key("facet, solid or endsolid", key);
    }
    return std::move(part_);
  }

 private:
  [[noreturn]] void fail_key(const char* expected, std::string_view found) const {
    cursor_.fail(fmt::format("{} is expected, not \"{}\"", expected, found.substr(0, 40)));
  }
  void expect(const char* expected) {
    if (cursor_.at_end()) cursor_.fail(fmt::format("the file ends too early: {} is missing", expected));
    const std::string_view found = cursor_.word();
    if (!same_stl_word(found, expected)) fail_key(expected, found);
  }

  void end_solid() {
    part_.borders.push_back({part_.corners.size(), false, {}});
    cursor_.line();
  }

  // The normal is passed over: it follows from the points, and is often 0 or no number at all.
  void read_facet() {
    cursor_.line();
    expect("outer");
    expect("loop");
    for (int k = 0; k < 3; ++k) {
      expect("vertex");
      const double x = cursor_.coordinate();
      const double y = cursor_.coordinate();
      const double z = cursor_.coordinate();
      // Adding 0 makes a positive zero of a negative one.
      part_.corners.push_back({x + 0.0, y + 0.0, z + 0.0});
    }
    expect("endloop");
    expect("endfacet");
  }

  TextCursor cursor_;
  StlPart part_;
};

// Joins the parts of a text in their order.
class StlJoiner {
 public:
  StlJoiner(const std::string& path, std::string_view text, std::vector<StlPart> parts)
      : path_(path), text_(text), parts_(std::move(parts)) {}

  ReadCells join() {
    std::vector<std::size_t> first(parts_.size() + 1, 0);
    for (std::size_t k = 0; k < parts_.size(); ++k) first[k + 1] = first[k] + parts_[k].corners.size();
    const std::vector<std::int32_t> regions = read_borders(first);
    std::vector<Vec3> corners(first.back());
    read_parts(parts_.size(), [&](std::size_t k) {
      std::copy(parts_[k].corners.begin(), parts_[k].corners.end(),
                corners.begin() + static_cast<std::ptrdiff_t>(first[k]));
      parts_[k].corners = {};
    });
    ReadCells cells = weld_triangles(corners.size(), [&](std::size_t i) { return corners[i]; });
    cells.regions = regions;
    groups_.settle(cells.regions, cells.names.regions);
    return cells;
  }

 private:
  // The region of each facet.
  std::vector<std::int32_t> read_borders(const std::vector<std::size_t>& first) {
    std::vector<std::int32_t> regions;
    regions.reserve(first.back() / 3);
    bool open = false;
    for (std::size_t k = 0; k < parts_.size(); ++k)
      for (const StlBorder& border : parts_[k].borders) {
        regions.resize((first[k] + border.corner) / 3, region_);
        open = border.begins;
        if (open) region_ = number_of(border.name);
      }
    if (open) {
      TextCursor cursor(path_, text_, {text_.size(), text_.size()});
      cursor.fail("the file ends too early: endsolid is missing");
    }
    regions.resize(first.back() / 3, region_);
    return regions;
  }

  std::int32_t number_of(std::string_view name) {
    ++solids_;
    return name.empty() ? groups_.number_of_nameless(fmt::format("\n{}", solids_)) : groups_.number(name);
  }

  const std::string& path_;
  std::string_view text_;
  std::vector<StlPart> parts_;
  GroupNumbers groups_ = region_numbers();
  std::int32_t region_ = 0;
  std::size_t solids_ = 0;
};

}  // namespace

bool same_stl_word(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(), [](char a, char b) {
    return a == b || std::tolower(static_cast<unsigned char>(a)) == b;
  });
}

ReadCells read_stl_text(const std::string& path, std::string_view text) {
  const std::vector<TextPart> cuts = split_lines(text, 0, "fF");
  std::vector<StlPart> parts(cuts.size());
  read_parts(cuts.size(), [&](std::size_t k) { parts[k] = StlPartReader(path, text, cuts[k]).read(); });
  return StlJoiner(path, text, std::move(parts)).join();
}

}  // namespace quarry
