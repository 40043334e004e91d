#include "io/mesh/ply_row.hpp"

#include <fmt/format.h>

#include "engine/base/error.hpp"

namespace quarry {

void PlyBytes::fail(std::size_t at, const std::string& message) const {
  throw Error(ErrorKind::kInput, fmt::format("{}: byte {}: {}", path_, at, message));
}

PlyRows::PlyRows(const PlyBytes& bytes, const PlyElement& element, std::size_t begin) : begin_(begin) {
  std::vector<Step> steps(1);
  bool lists = false;
  for (const PlyProperty& property : element.properties) {
    Step& step = steps.back();
    if (property.length_type) {
      step.length_type = *property.length_type;
      step.value_size = size_of(property.type);
      stride_ += size_of(step.length_type);
      steps.emplace_back();
      lists = true;
    } else {
      step.constant += size_of(property.type);
      stride_ += size_of(property.type);
    }
  }
  // No row is shorter: before anything that has the size of a count is asked of memory.
  const std::size_t left = bytes.text().size() - begin;
  if (stride_ > 0 && element.rows > left / stride_)
    bytes.fail(bytes.text().size(),
               fmt::format("the file ends too early: {} rows of element {} are announced", element.rows,
                           element.name));
  end_ = begin + element.rows * stride_;
  if (!lists) return;
  begins_.resize(element.rows);
  end_ = begin;
  for (std::size_t& row : begins_) {
    row = end_;
    end_ = end_of_row(bytes, steps, end_);
  }
}

std::size_t PlyRows::end_of_row(const PlyBytes& bytes, const std::vector<Step>& steps, std::size_t at) const {
  const std::size_t size = bytes.text().size();
  const auto require = [&](std::size_t count, std::size_t value_size) {
    if (count > (size - at) / value_size) bytes.fail(size, "the file ends too early: within a row of a list");
    at += count * value_size;
  };
  for (const Step& step : steps) {
    require(step.constant, 1);
    if (step.value_size == 0) continue;
    const std::size_t length_at = at;
    require(size_of(step.length_type), 1);
    const auto length = bytes.number<std::int64_t>(length_at, step.length_type);
    if (length < 0) bytes.fail(length_at, "the length of a list is negative");
    require(static_cast<std::size_t>(length), step.value_size);
  }
  return at;
}

}  // namespace quarry
