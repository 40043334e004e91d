// How large elements are wanted, by place. A field answers from many threads at once, and the same place
// always gets the same answer.
#pragma once

#include "engine/geometry/vec.hpp"

namespace quarry {

class SizeField {
 public:
  virtual ~SizeField() = default;
  // The wanted edge of an element at p, in the units of p; positive.
  [[nodiscard]] virtual double at(Vec2 p) const = 0;
};

// The same size everywhere.
class UniformSize final : public SizeField {
 public:
  explicit UniformSize(double size) : size_(size) {}
  [[nodiscard]] double at(Vec2 /*p*/) const override { return size_; }

 private:
  double size_;
};

}  // namespace quarry
