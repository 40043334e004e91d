// A fault that cuts lines and slides what is above it along itself.
#pragma once

#include <vector>

#include "engine/geometry/vec.hpp"
#include "pipeline/generate/model.hpp"

namespace quarry {

struct DrawnLine {
  std::vector<Vec2> points;
  LineLabel label;
};

class Fault {
 public:
  // Through a point, with the unit vector that points up along it. slip: how far the block above it moves
  // down along it.
  Fault(Vec2 place, Vec2 updip, double slip) : place_(place), updip_(updip), slip_(-slip * updip) {}

  // Cuts the lines where they cross the fault, moves the parts above it, and appends the fault: a line of
  // that reach up and down from its place, with a vertex at each end of what it has cut.
  void apply(std::vector<DrawnLine>& lines, double reach, LineLabel label) const;

 private:
  // Above: on the side to which the block moves down.
  [[nodiscard]] bool above(Vec2 point) const;
  void cut(const DrawnLine& line, std::vector<DrawnLine>& parts, std::vector<Vec2>& contacts) const;
  // Where a segment that crosses the fault meets it.
  [[nodiscard]] Vec2 meet(Vec2 a, Vec2 b) const;

  Vec2 place_, updip_, slip_;
};

}  // namespace quarry
