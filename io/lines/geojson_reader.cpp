#include "io/lines/geojson_reader.hpp"

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "io/lines/coordinate_system.hpp"
#include "io/lines/line_attributes.hpp"
#include "io/lines/nested_coordinates.hpp"

namespace quarry {
namespace {

using Json = nlohmann::json;

// The end of a long text: what the parser read last is what went wrong.
std::string shortened(const std::string& text, std::size_t length) {
  return text.size() <= length ? text : "..." + text.substr(text.size() - length);
}

// Follows the objects that make up the collection and the properties of features; everything else is skipped
// by counting brackets.
class LineTokens : public nlohmann::json_sax<Json> {
 public:
  LineTokens(const LineSource& source, LineSet& lines) : source_(source), lines_(lines) {}

  bool null() override { return other_value("null"); }
  bool boolean(bool value) override { return other_value(value ? "true" : "false"); }
  bool number_integer(number_integer_t value) override { return number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) override { return number(value); }
  bool binary(binary_t&) override { return other_value("binary data"); }

  bool string(string_t& value) override {
    if (skipped_ == 0 && !coordinates_open() && !objects_.empty()) take_text(objects_.back(), value);
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
    Object object;
    object.role = top ? Role::kGeometry : role_of_value();
    object.first = LineSetMark::of(lines_);
    if (!top && objects_.back().key == Key::kFeatures) feature_ = next_feature_++;
    objects_.push_back(std::move(object));
    return true;
  }

  bool key(string_t& name) override {
    if (skipped_ > 0) return true;
    Object& object = objects_.back();
    object.key = Key::kOther;
    if (object.role == Role::kProperties || object.role == Role::kSystemProperties) {
      object.property = name;
      return true;
    }
    for (const auto& [text, key] : kKeys)
      if (text == name && (object.role == Role::kGeometry || key == Key::kProperties)) object.key = key;
    if (object.key == Key::kCoordinates) object.coordinates.clear();
    return true;
  }

  bool end_object() override {
    if (skipped_ > 0) {
      --skipped_;
      return true;
    }
    const Object& object = objects_.back();
    if (object.role == Role::kGeometry && type_has_coordinates(object.type)) {
      if (!object.coordinates.complete())
        fail_in_feature(fmt::format("a {} without coordinates", object.type));
      check(object.coordinates.append_geometry(object.type, source_.file, feature_, lines_));
    }
    if (object.type == "Feature") attributes_.assign(object.first, lines_);
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
    throw Error(ErrorKind::kInput, fmt::format("{}: broken JSON at byte {}, near '{}': {}", source_.name,
                                               position, shortened(token, 40), reason));
  }

  [[nodiscard]] bool top_is_object() const { return top_seen_; }
  // The name of the coordinate system; "" if the file names none.
  [[nodiscard]] const std::string& system() const { return system_; }
  [[nodiscard]] const AttributeCollector& attributes() const { return attributes_; }

 private:
  enum class Key { kOther, kType, kCoordinates, kFeatures, kGeometry, kGeometries, kProperties, kSystem };
  static constexpr std::array<std::pair<std::string_view, Key>, 7> kKeys = {
      {{"type", Key::kType},
       {"coordinates", Key::kCoordinates},
       {"features", Key::kFeatures},
       {"geometry", Key::kGeometry},
       {"geometries", Key::kGeometries},
       {"properties", Key::kProperties},
       {"crs", Key::kSystem}}};
  // What an object is: a geometry, feature or collection; the properties of a feature; the member "crs", and
  // the properties of that.
  enum class Role { kGeometry, kProperties, kSystem, kSystemProperties };
  struct Object {
    Role role = Role::kGeometry;
    Key key = Key::kOther;
    bool in_list = false;  // within the array of "features" or "geometries"
    LineSetMark first;
    std::string type;
    std::string property;  // the key of a property
    NestedCoordinates coordinates;
  };
  static constexpr int kNumberOverflow = 406;

  [[nodiscard]] bool coordinates_open() const {
    return skipped_ == 0 && !objects_.empty() && objects_.back().key == Key::kCoordinates &&
           objects_.back().coordinates.open();
  }
  [[nodiscard]] bool expects_object() const {
    if (objects_.empty()) return false;
    const Object& object = objects_.back();
    return object.in_list || object.key == Key::kGeometry || object.key == Key::kProperties ||
           object.key == Key::kSystem;
  }
  // Of the object that the open key of the last one begins.
  [[nodiscard]] Role role_of_value() const {
    const Object& object = objects_.back();
    if (object.key == Key::kSystem) return Role::kSystem;
    if (object.key != Key::kProperties) return Role::kGeometry;
    return object.role == Role::kSystem ? Role::kSystemProperties : Role::kProperties;
  }

  void take_text(Object& object, const std::string& value) {
    if (object.role == Role::kProperties) attributes_.set(object.property, value);
    if (object.role == Role::kSystemProperties && object.property == "name") system_ = value;
    if (object.role == Role::kGeometry && object.key == Key::kType) object.type = value;
  }

  bool number(double value) {
    if (coordinates_open())
      check(objects_.back().coordinates.number(value));
    else if (skipped_ == 0 && !objects_.empty() && objects_.back().role == Role::kProperties)
      attributes_.set(objects_.back().property, value);
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
                fmt::format("{}: feature {}: {}; correct or remove it", source_.name, feature_, problem));
  }

  const LineSource& source_;
  LineSet& lines_;
  std::vector<Object> objects_;
  AttributeCollector attributes_;
  std::string system_;
  std::size_t skipped_ = 0;  // open brackets within a value that is not followed
  std::uint32_t feature_ = 0;
  std::uint32_t next_feature_ = 0;
  bool top_seen_ = false;
};

}  // namespace

void read_geojson_lines(const LineSource& source, LineSet& lines) {
  LineTokens tokens(source, lines);
  Json::sax_parse(source.text.begin(), source.text.end(), &tokens);
  if (!tokens.top_is_object())
    throw Error(
        ErrorKind::kInput,
        fmt::format("{}: not GeoJSON: the document is no object; a bare list of coordinates needs its type: "
                    "{{\"type\":\"Polygon\",\"coordinates\":LIST}}",
                    source.name));
  // RFC 7946 knows longitude and latitude alone; files of plane coordinates without a word of it are as
  // common.
  lines.systems[source.file] = describe_system(tokens.system());
  if (tokens.system().empty() && look_like_degrees(lines, source.file))
    lines.systems[source.file] = {"OGC:CRS84", true, true};
  tokens.attributes().tell(source.name);
}

}  // namespace quarry
