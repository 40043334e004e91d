// A plan as a text, by which rank 0 tells it to others.
#pragma once

#include <string>
#include <vector>

#include "pipeline/batch/job.hpp"

namespace quarry {

struct SharedPlan {
  std::vector<BatchJob> jobs;
  std::vector<std::size_t> order;
};

[[nodiscard]] std::string plan_text(const SharedPlan& plan);
[[nodiscard]] SharedPlan parse_plan(const std::string& text);

}  // namespace quarry
