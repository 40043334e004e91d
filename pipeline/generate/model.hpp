// A model that was drawn by lot: its lines, and what each of them is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/geometry/box.hpp"
#include "engine/geometry/line_set.hpp"

namespace quarry {

struct LineLabel {
  enum class Kind : std::uint8_t { kOutline, kFracture, kHorizon, kFault };

  Kind kind = Kind::kFracture;
  std::uint32_t number =
      0;  // of the fracture, horizon or fault; a line that the box cuts in parts has it on each
  std::uint32_t set = 0;  // of fractures: which orientation set
};

struct GeneratedModel {
  LineSet lines{.files = {"lines drawn by lot"}, .systems = {}, .attributes = {}, .lines = {}, .points = {}};
  std::vector<LineLabel> labels;  // one a line
  double total_length = 0;        // of all lines but the outline
  std::size_t segments = 0;       // of all lines but the outline
};

// Writes GeoJSON: LineStrings with the properties `kind` (fracture, horizon, fault), `number` and, of
// fractures, `set`; the outline, if the model has one, is a Polygon of the kind outline. Throws
// Error(kOutput).
void write_model(const std::string& path, const GeneratedModel& model);

// Throws Error(kUsage) unless the box has finite sides above 0.
void require_box(const Box2& box);

// Keeps lines to a box, and coordinates to a grid whose step is a power of ten, so that files are short.
// Points that are equal stay equal.
class ModelFrame {
 public:
  ModelFrame(const Box2& box, double coarsest_step);

  [[nodiscard]] const Box2& box() const { return box_; }
  // Appends the parts of a line that lie in the box, which end on its sides exactly. Returns their length.
  double add(const std::vector<Vec2>& line, LineLabel label, GeneratedModel& model) const;
  void add_outline(GeneratedModel& model) const;

 private:
  [[nodiscard]] Vec2 rounded(Vec2 point) const;
  void finish(std::vector<Vec2>& part, LineLabel label, double& length, GeneratedModel& model) const;

  Box2 box_;
  double steps_in_unit_ = 1;
};

}  // namespace quarry
