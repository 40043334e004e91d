// Quality demands: `--require min-sj=0.1,irregular=5`. A mesh that does not meet one is not written.
#pragma once

#include <string>
#include <vector>

#include "engine/mesh/mesh.hpp"
#include "kernels/quality/summary.hpp"

namespace quarry::cli {

struct Demand {
  std::string name;
  double limit = 0;
};

// What --help says about the names.
[[nodiscard]] std::string demand_help();

// texts: "name=number" each. Throws Error(kUsage) for an unknown name or a limit that is no number.
[[nodiscard]] std::vector<Demand> parse_demands(const std::vector<std::string>& texts);

// Throws Error(kQuality) for the first demand that is not met, with the place of the worst face where there
// is one.
void require_demands(const std::vector<Demand>& demands, const Mesh& mesh, const QualitySummary& quality);

}  // namespace quarry::cli
