#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/batch/records.hpp"

namespace quarry {

std::string table_text(std::span<const BatchJob> jobs, std::span<const JobRecord> records) {
  // Long names are in the table of JSON; here they would push everything aside.
  constexpr std::size_t kWidest = 40;
  std::size_t width = 3;
  for (const JobRecord& record : records) width = std::max(width, jobs[record.job].name.size());
  width = std::min(width, kWidest);
  std::string text = fmt::format("{:<{}}  {:<13} {:>9} {:>7} {:>8} {:>10}  why\n", "job", width, "outcome",
                                 "seconds", "threads", "peak MB", "elements");
  for (const JobRecord& record : records) {
    const bool ran = record.outcome != Outcome::kNotRun;
    std::string row =
        fmt::format("{:<{}}  {:<13} {:>9} {:>7} {:>8} {:>10}  {}", jobs[record.job].name, width,
                    outcome_text(record.outcome), ran ? fmt::format("{:.2f}", record.seconds) : "-",
                    ran ? fmt::format("{}", record.threads) : "-",
                    ran ? fmt::format("{:.0f}", static_cast<double>(record.peak_bytes) / 1e6) : "-",
                    record.elements ? fmt::format("{}", *record.elements) : "-", record.message);
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n";
  }
  return text;
}

std::string count_text(std::span<const JobRecord> records) {
  std::map<Outcome, std::size_t> counts;
  for (const JobRecord& record : records) ++counts[record.outcome];
  std::vector<std::string> parts;
  for (const auto& [outcome, count] : counts)
    parts.push_back(fmt::format("{} {}", count, outcome_text(outcome)));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace quarry
