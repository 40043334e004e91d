#include "io/lines/wkt_geometry.hpp"

#include <algorithm>
#include <array>

#include <cctype>
#include <fmt/format.h>

#include "io/lines/nested_coordinates.hpp"
#include "io/lower_case.hpp"
#include "io/number_text.hpp"

namespace quarry {
namespace {

struct WktType {
  std::string_view keyword;  // lower case
  std::string_view type;     // as GeoJSON calls it
  int depth;                 // of brackets around positions
};

// Longer words first: one may start with another.
constexpr std::array kTypes{WktType{"multilinestring", "MultiLineString", 2},
                            WktType{"multipolygon", "MultiPolygon", 3},
                            WktType{"multipoint", "MultiPoint", 1},
                            WktType{"linestring", "LineString", 1},
                            WktType{"polygon", "Polygon", 2},
                            WktType{"point", "Point", 1},
                            WktType{"linearring", "LineString", 1}};
constexpr std::string_view kCollection = "geometrycollection";
constexpr std::string_view kSystem = "srid=";

class WktParser {
 public:
  WktParser(std::string_view text, std::uint32_t file, std::uint32_t feature, LineSet& lines)
      : text_(text), file_(file), feature_(feature), lines_(lines) {}

  WktGeometry read() {
    read_system();
    if (result_.problem.empty()) read_geometry(0);
    result_.end = at_;
    return std::move(result_);
  }

 private:
  // Collections within collections; no map has them deeper.
  static constexpr int kDeepest = 64;

  bool fail(std::string problem) {
    if (result_.problem.empty()) result_.problem = std::move(problem);
    return false;
  }
  bool check(const std::string& problem) { return problem.empty() || fail(problem); }

  void pass_space() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  bool take(char wanted) {
    pass_space();
    if (at_ == text_.size() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }
  std::string word() {
    pass_space();
    const std::size_t begin = at_;
    while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return lower_case(text_.substr(begin, at_ - begin));
  }

  void read_system() {
    pass_space();
    if (lower_case(text_.substr(at_, kSystem.size())) != kSystem) return;
    at_ += kSystem.size();
    const std::size_t begin = at_;
    while (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    if (at_ > begin && at_ - begin < 10 &&
        text_.substr(begin, at_ - begin).find_first_not_of('0') != std::string_view::npos)
      result_.system = fmt::format("EPSG:{}", text_.substr(begin, at_ - begin));
    if (!take(';')) fail("; is missing after SRID");
  }

  bool read_geometry(int depth) {
    std::string keyword = word();
    // "POINTZ" and "POINT Z" are the same.
    std::string axes;
    if (const auto known = std::ranges::find(kTypes, keyword, &WktType::keyword);
        known == kTypes.end() && keyword != kCollection) {
      while (!keyword.empty() && (keyword.back() == 'z' || keyword.back() == 'm') && axes.size() < 2) {
        axes.insert(axes.begin(), keyword.back());
        keyword.pop_back();
      }
    }
    const auto type = std::ranges::find(kTypes, keyword, &WktType::keyword);
    if (type == kTypes.end() && keyword != kCollection)
      return fail(keyword.empty() ? "a geometry such as LINESTRING (0 0, 1 1) is expected"
                                  : fmt::format("{}{} is no geometry of straight lines", keyword, axes));
    std::string next = axes.empty() ? word() : axes;
    if (next == "z" || next == "m" || next == "zm") {
      axes = next;
      next = word();
    } else if (!axes.empty()) {
      next = word();
    }
    measured_ = axes == "m";
    const bool empty = next == "empty";
    if (!next.empty() && !empty) return fail(fmt::format("( is expected, not {}", next));
    if (keyword == kCollection) return empty || read_collection(depth);
    coordinates_.clear();
    const bool read =
        empty ? check(coordinates_.start_array()) && check(coordinates_.end_array()) : read_list(type->depth);
    return read && check(coordinates_.append_geometry(type->type, file_, feature_, lines_));
  }

  bool read_collection(int depth) {
    if (depth == kDeepest) return fail("collections within collections, too deep");
    if (!take('(')) return fail("( is expected");
    do {
      if (!read_geometry(depth + 1)) return false;
    } while (take(','));
    return take(')') || fail(") is expected");
  }

  // Positions, or lists of them, in brackets.
  bool read_list(int depth) {
    if (word() == "empty") return check(coordinates_.start_array()) && check(coordinates_.end_array());
    if (!take('(')) return fail(fmt::format("{}: ( is expected", coordinates_.place()));
    if (!check(coordinates_.start_array())) return false;
    do {
      pass_space();
      // The points of a MULTIPOINT may have brackets of their own.
      const bool bracket = depth == 1 && take('(');
      if (!(depth > 1 ? read_list(depth - 1) : read_position())) return false;
      if (bracket && !take(')')) return fail(") is expected");
    } while (take(','));
    if (!take(')')) return fail(fmt::format("{}: , or ) is expected", coordinates_.place()));
    return check(coordinates_.end_array());
  }

  bool read_position() {
    if (!check(coordinates_.start_array())) return false;
    for (int axis = 0;; ++axis) {
      pass_space();
      if (at_ == text_.size() || text_[at_] == ',' || text_[at_] == ')') break;
      const char* const begin = text_.data() + at_ + (text_[at_] == '+' ? 1 : 0);
      double value = 0;
      const auto [stop, failure] = read_number(begin, text_.data() + text_.size(), value);
      if (failure == std::errc::invalid_argument)
        return fail(fmt::format("{}: a number is expected", coordinates_.place()));
      if (failure != std::errc())
        return fail(fmt::format("{}: a coordinate is too large", coordinates_.place()));
      at_ = static_cast<std::size_t>(stop - text_.data());
      if (axis == 2 && measured_) continue;
      if (!check(coordinates_.number(value))) return false;
    }
    return check(coordinates_.end_array());
  }

  std::string_view text_;
  std::uint32_t file_;
  std::uint32_t feature_;
  LineSet& lines_;
  WktGeometry result_;
  NestedCoordinates coordinates_;
  std::size_t at_ = 0;
  bool measured_ = false;
};

}  // namespace

bool starts_as_wkt(std::string_view text) {
  const std::string start = lower_case(text.substr(0, kCollection.size()));
  return start.starts_with(kSystem) || start.starts_with(kCollection) ||
         std::ranges::any_of(kTypes, [&](const WktType& type) { return start.starts_with(type.keyword); });
}

WktGeometry read_wkt_geometry(std::string_view text, std::uint32_t file, std::uint32_t feature,
                              LineSet& lines) {
  return WktParser(text, file, feature, lines).read();
}

}  // namespace quarry
