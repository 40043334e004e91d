#include "pipeline/generate/fault.hpp"

#include <algorithm>
#include <utility>

namespace quarry {

bool Fault::above(Vec2 point) const {
  const double side = cross(updip_, point - place_);
  // The fault dips to the left if it rises to the right; what is above it is then on its left.
  return updip_.x >= 0 ? side > 0 : side < 0;
}

Vec2 Fault::meet(Vec2 a, Vec2 b) const {
  const double from = cross(updip_, a - place_), to = cross(updip_, b - place_);
  return a + (from / (from - to)) * (b - a);
}

void Fault::cut(const DrawnLine& line, std::vector<DrawnLine>& parts, std::vector<Vec2>& contacts) const {
  DrawnLine part{{}, line.label};
  const auto take = [&](Vec2 point, bool moved) { part.points.push_back(moved ? point + slip_ : point); };
  bool moved = above(line.points.front());
  take(line.points.front(), moved);
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const bool next = above(line.points[i]);
    if (next != moved) {
      const Vec2 contact = meet(line.points[i - 1], line.points[i]);
      contacts.insert(contacts.end(), {contact, contact + slip_});
      take(contact, moved);
      parts.push_back(std::exchange(part, {{}, line.label}));
      take(contact, next);
      moved = next;
    }
    take(line.points[i], moved);
  }
  parts.push_back(std::move(part));
}

void Fault::apply(std::vector<DrawnLine>& lines, double reach, LineLabel label) const {
  std::vector<DrawnLine> parts;
  std::vector<Vec2> contacts;
  for (const DrawnLine& line : lines) cut(line, parts, contacts);
  // A point is appended as it is: the ends of other lines have its bits.
  const auto height = [&](Vec2 point) { return dot(updip_, point - place_); };
  std::stable_sort(contacts.begin(), contacts.end(), [&](Vec2 a, Vec2 b) { return height(a) < height(b); });
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
  DrawnLine fault{{place_ - reach * updip_}, label};
  fault.points.insert(fault.points.end(), contacts.begin(), contacts.end());
  fault.points.push_back(place_ + reach * updip_);
  parts.push_back(std::move(fault));
  lines = std::move(parts);
}

}  // namespace quarry
