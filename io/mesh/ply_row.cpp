#include "io/mesh/ply_row.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "engine/base/error.hpp"

namespace quarry {

void PlyBytes::fail(std::size_t at, const std::string& message) const {
  throw Error(ErrorKind::kInput, fmt::format("{}: byte {}: {}", path_, at, message));
}

PlyLayout::PlyLayout(const PlyBytes& bytes, const PlyElement& element, std::size_t begin) : end_(begin) {
  take_steps(element);
  // Before anything that has the size of a count is asked of memory.
  const std::size_t left = bytes.text().size() - begin;
  if (shortest_ > 0 && element.rows > left / shortest_)
    bytes.fail(bytes.text().size(),
               fmt::format("the file ends too early: {} rows of element {} are announced", element.rows,
                           element.name));
  const bool lists = steps_.size() > 1;
  for (std::size_t row = 0; row < element.rows; row += kRowsInPart) {
    begins_.push_back(end_);
    const std::size_t rows = std::min(kRowsInPart, element.rows - row);
    if (!lists) end_ += rows * shortest_;
    for (std::size_t i = 0; lists && i < rows; ++i) end_ = end_of_row(bytes, end_);
  }
}

void PlyLayout::take_steps(const PlyElement& element) {
  steps_.resize(1);
  for (const PlyProperty& property : element.properties) {
    Step& step = steps_.back();
    if (property.length_type) {
      step.length_type = *property.length_type;
      step.value_size = size_of(property.type);
      shortest_ += size_of(step.length_type);
      steps_.emplace_back();
    } else {
      step.constant += size_of(property.type);
      shortest_ += size_of(property.type);
    }
  }
}

std::size_t PlyLayout::end_of_row(const PlyBytes& bytes, std::size_t at) const {
  const std::size_t size = bytes.text().size();
  const auto pass = [&](std::size_t count) {
    if (count > size - at) bytes.fail(size, "the file ends too early: within a row of a list");
    at += count;
  };
  for (const Step& step : steps_) {
    pass(step.constant);
    if (step.value_size == 0) continue;
    const std::size_t length_at = at;
    pass(size_of(step.length_type));
    const auto length = bytes.number<std::int64_t>(length_at, step.length_type);
    if (length < 0) bytes.fail(length_at, "the length of a list is negative");
    pass(static_cast<std::size_t>(length) * step.value_size);
  }
  return at;
}

}  // namespace quarry
