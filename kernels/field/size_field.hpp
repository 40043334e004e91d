// How large elements are wanted, by place. A field answers from many threads at once, and the same place
// always gets the same answer.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

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

// The smallest of several fields, of which there is at least one.
class SmallestSize final : public SizeField {
 public:
  explicit SmallestSize(std::vector<std::shared_ptr<const SizeField>> fields) : fields_(std::move(fields)) {}
  [[nodiscard]] double at(Vec2 p) const override {
    double size = fields_.front()->at(p);
    for (const auto& field : fields_) size = std::min(size, field->at(p));
    return size;
  }

 private:
  std::vector<std::shared_ptr<const SizeField>> fields_;
};

// Another field times a factor, and never below a floor (in input units, not multiplied). The field must
// outlive it.
class ScaledSize final : public SizeField {
 public:
  explicit ScaledSize(const SizeField& field, double factor, double floor = 0)
      : field_(&field), factor_(factor), floor_(floor) {}
  [[nodiscard]] double at(Vec2 p) const override { return std::max(floor_, factor_ * field_->at(p)); }

 private:
  const SizeField* field_;
  double factor_, floor_;
};

}  // namespace quarry
