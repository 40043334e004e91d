#include "pipeline/batch/plan_text.hpp"

#include <nlohmann/json.hpp>

namespace quarry {

std::string plan_text(const SharedPlan& plan) {
  nlohmann::json jobs = nlohmann::json::array();
  for (const BatchJob& job : plan.jobs)
    jobs.push_back({job.name, job.words, job.inputs, job.outputs, job.report, job.weight});
  const std::vector<std::uint8_t> bytes = nlohmann::json::to_msgpack({{"jobs", jobs}, {"order", plan.order}});
  return {bytes.begin(), bytes.end()};
}

SharedPlan parse_plan(const std::string& text) {
  const nlohmann::json json = nlohmann::json::from_msgpack(text);
  SharedPlan plan;
  for (const nlohmann::json& job : json.at("jobs"))
    plan.jobs.push_back({job.at(0), job.at(1), job.at(2), job.at(3), job.at(4), job.at(5)});
  plan.order = json.at("order").get<std::vector<std::size_t>>();
  return plan;
}

}  // namespace quarry
