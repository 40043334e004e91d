#include "io/lines/geojson_reader.hpp"

#include <cstring>
#include <string_view>
#include <vector>

#include <cerrno>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "io/lines/byte_stream.hpp"
#include "io/lines/geojson_coordinates.hpp"

namespace quarry {
namespace {

using Json = nlohmann::json;

// The end of a long text: what the parser read last is what went wrong.
std::string shortened(const std::string& text, std::size_t length) {
  return text.size() <= length ? text : "..." + text.substr(text.size() - length);
}

// Follows the objects that make up the collection; everything else, above all the properties of features, is
// skipped by counting brackets.
class LineTokens : public nlohmann::json_sax<Json> {
 public:
  LineTokens(const std::string& path, std::uint32_t file, LineSet& lines)
      : path_(path), file_(file), lines_(lines) {}

  bool null() override { return other_value("null"); }
  bool boolean(bool value) override { return other_value(value ? "true" : "false"); }
  bool number_integer(number_integer_t value) override { return number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) override { return number(value); }
  bool binary(binary_t&) override { return other_value("binary data"); }

  bool string(string_t& value) override {
    if (skipped_ == 0 && !coordinates_open() && !objects_.empty() && objects_.back().key == Key::kType)
      objects_.back().type = value;
    return other_value("a text");
  }

  bool start_object(std::size_t) override {
    if (coordinates_open()) fail_in_feature(objects_.back().coordinates.place() + ": an object");
    const bool top = objects_.empty() && !top_seen_;
    if (skipped_ > 0 || !(top || expects_object())) {
      ++skipped_;
      return true;
    }
    top_seen_ = true;
    if (!top && objects_.back().key == Key::kFeatures) feature_ = next_feature_++;
    objects_.emplace_back();
    return true;
  }

  bool key(string_t& name) override {
    if (skipped_ > 0) return true;
    Object& object = objects_.back();
    object.key = name == "type"          ? Key::kType
                 : name == "coordinates" ? Key::kCoordinates
                 : name == "features"    ? Key::kFeatures
                 : name == "geometry"    ? Key::kGeometry
                 : name == "geometries"  ? Key::kGeometries
                                         : Key::kOther;
    if (object.key == Key::kCoordinates) object.coordinates.clear();
    return true;
  }

  bool end_object() override {
    if (skipped_ > 0) {
      --skipped_;
      return true;
    }
    const Object& object = objects_.back();
    if (geojson_type_has_coordinates(object.type)) {
      if (!object.coordinates.complete())
        fail_in_feature(fmt::format("a {} without coordinates", object.type));
      check(object.coordinates.append_lines(object.type, file_, feature_, lines_));
    }
    objects_.pop_back();
    return true;
  }

  bool start_array(std::size_t) override {
    if (skipped_ > 0) {
      ++skipped_;
      return true;
    }
    if (!objects_.empty()) {
      Object& object = objects_.back();
      if (object.key == Key::kCoordinates) {
        check(object.coordinates.start_array());
        return true;
      }
      if ((object.key == Key::kFeatures || object.key == Key::kGeometries) && !object.in_list) {
        object.in_list = true;
        return true;
      }
    }
    ++skipped_;
    return true;
  }

  bool end_array() override {
    if (skipped_ > 0) {
      --skipped_;
    } else if (objects_.back().key == Key::kCoordinates) {
      check(objects_.back().coordinates.end_array());
    } else {
      objects_.back().in_list = false;
    }
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const Json::exception& error) override {
    if (coordinates_open() && error.id == kNumberOverflow)
      fail_in_feature(fmt::format("{}: a coordinate is too large", objects_.back().coordinates.place()));
    const std::string what = error.what();
    // Strip the library's prefix "[json.exception...] parse error at line 1, column 2: ".
    const std::size_t colon = what.find(": ");
    const std::string reason = shortened(colon == std::string::npos ? what : what.substr(colon + 2), 160);
    if (coordinates_open())
      fail_in_feature(fmt::format("{}: not a number, near '{}' at byte {}: {}",
                                  objects_.back().coordinates.place(), shortened(token, 40), position,
                                  reason));
    throw Error(ErrorKind::kInput, fmt::format("{}: broken JSON at byte {}, near '{}': {}", path_, position,
                                               shortened(token, 40), reason));
  }

  [[nodiscard]] bool top_is_object() const { return top_seen_; }

 private:
  enum class Key { kOther, kType, kCoordinates, kFeatures, kGeometry, kGeometries };
  struct Object {
    Key key = Key::kOther;
    bool in_list = false;  // within the array of "features" or "geometries"
    std::string type;
    GeojsonCoordinates coordinates;
  };
  static constexpr int kNumberOverflow = 406;

  [[nodiscard]] bool coordinates_open() const {
    return skipped_ == 0 && !objects_.empty() && objects_.back().key == Key::kCoordinates &&
           objects_.back().coordinates.open();
  }
  [[nodiscard]] bool expects_object() const {
    return !objects_.empty() && (objects_.back().in_list || objects_.back().key == Key::kGeometry);
  }

  bool number(double value) {
    if (coordinates_open()) check(objects_.back().coordinates.number(value));
    return true;
  }
  bool other_value(std::string_view what) {
    if (coordinates_open())
      fail_in_feature(
          fmt::format("{}: {} where a number is needed", objects_.back().coordinates.place(), what));
    return true;
  }

  void check(const std::string& problem) const {
    if (!problem.empty()) fail_in_feature(problem);
  }
  [[noreturn]] void fail_in_feature(const std::string& problem) const {
    throw Error(ErrorKind::kInput,
                fmt::format("{}: feature {}: {}; correct or remove it", path_, feature_, problem));
  }

  const std::string& path_;
  std::uint32_t file_;
  LineSet& lines_;
  std::vector<Object> objects_;
  std::size_t skipped_ = 0;  // open brackets within a value that is not followed
  std::uint32_t feature_ = 0;
  std::uint32_t next_feature_ = 0;
  bool top_seen_ = false;
};

}  // namespace

void read_geojson_lines(const std::string& path, std::uint32_t file, LineSet& lines) {
  ByteStream stream(path);
  if (stream.blank()) throw Error(ErrorKind::kInput, fmt::format("{}: the file is empty", path));
  LineTokens tokens(path, file, lines);
  Json::sax_parse(stream.begin(), stream.end(), &tokens);
  if (!tokens.top_is_object())
    throw Error(ErrorKind::kInput, fmt::format("{}: not GeoJSON: the document is no object", path));
}

}  // namespace quarry
