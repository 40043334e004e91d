#include "pipeline/batch/records.hpp"

#include <array>
#include <filesystem>
#include <string_view>

#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "engine/base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/mapped_file.hpp"
#include "pipeline/report/input_hash.hpp"

namespace quarry {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 7> kOutcomes = {"done",        "skipped",       "failed", "crashed",
                                                       "out of time", "out of memory", "not run"};

Outcome parse_outcome(const std::string& text) {
  for (std::size_t i = 0; i < kOutcomes.size(); ++i)
    if (kOutcomes[i] == text) return static_cast<Outcome>(i);
  return Outcome::kNotRun;
}

Json json_of(const JobRecord& record) {
  Json json = {{"outcome", outcome_text(record.outcome)},
               {"exit_code", record.exit_code},
               {"message", record.message},
               {"seconds", record.seconds},
               {"cpu_seconds", record.cpu_seconds},
               {"peak_bytes", record.peak_bytes},
               {"threads", record.threads},
               {"rank", record.rank}};
  json["elements"] = record.elements ? Json(*record.elements) : Json(nullptr);
  json["input_hash"] = record.input_hash;
  return json;
}

JobRecord record_of(const Json& json) {
  JobRecord record;
  record.outcome = parse_outcome(json.at("outcome"));
  record.exit_code = json.at("exit_code");
  record.message = json.at("message");
  record.seconds = json.at("seconds");
  record.cpu_seconds = json.at("cpu_seconds");
  record.peak_bytes = json.at("peak_bytes");
  record.threads = json.at("threads");
  record.rank = json.at("rank");
  if (!json.at("elements").is_null()) record.elements = json.at("elements");
  record.input_hash = json.at("input_hash");
  return record;
}

// Size and time of last change (nanoseconds) of each output; null for one that is not there.
Json stamps_of(const BatchJob& job) {
  Json stamps = Json::array();
  for (const std::string& output : job.outputs) {
    struct stat state {};
    if (::stat(output.c_str(), &state) != 0) {
      stamps.push_back(nullptr);
      continue;
    }
    const std::int64_t changed = std::int64_t{state.st_mtim.tv_sec} * 1'000'000'000 + state.st_mtim.tv_nsec;
    stamps.push_back({{"path", output}, {"bytes", std::int64_t{state.st_size}}, {"changed", changed}});
  }
  return stamps;
}

// Of the files that the worker hashed as well. Pipes and devices have no hash: reading them may never end.
std::optional<std::string> hash_inputs(const BatchJob& job) {
  std::error_code ignored;
  for (const std::string& input : job.inputs)
    if (!std::filesystem::is_regular_file(input, ignored)) return std::nullopt;
  try {
    return hash_files(job.inputs);
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace

std::string_view outcome_text(Outcome outcome) { return kOutcomes[static_cast<std::size_t>(outcome)]; }

void add_report(const BatchJob& job, JobRecord& record) {
  // Lists of lines are most of a long report, and none of it is needed here.
  const auto keep = [](int depth, Json::parse_event_t event, const Json&) {
    return event != Json::parse_event_t::array_start || depth < 2;
  };
  try {
    const MappedFile file(job.report);
    const Json report = Json::parse(file.text(), keep);
    record.input_hash = report.at("input").at("hash");
    const Json& counts = report.at("counts");
    record.elements = counts.value("quads", std::int64_t{0}) + counts.value("triangles", std::int64_t{0});
  } catch (const Error&) {
  } catch (const Json::exception&) {
  }
}

void write_record(const BatchFolder& folder, const BatchJob& job, const JobRecord& record,
                  const std::string& version) {
  Json json = json_of(record);
  json["version"] = version;
  json["words"] = job.words;
  json["outputs"] = stamps_of(job);
  write_file(folder.record(job), json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<JobRecord> find_done(const BatchFolder& folder, const BatchJob& job,
                                   const std::string& version) {
  const std::string path = folder.record(job);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return std::nullopt;
  try {
    const MappedFile file(path);
    const Json json = Json::parse(file.text());
    JobRecord record = record_of(json);
    if (record.outcome != Outcome::kDone || record.input_hash.empty() || json.at("version") != version ||
        json.at("words") != Json(job.words) || json.at("outputs") != stamps_of(job) ||
        record.input_hash != hash_inputs(job))
      return std::nullopt;
    record.outcome = Outcome::kSkipped;
    return record;
  } catch (const Error&) {
  } catch (const Json::exception&) {
  }
  return std::nullopt;
}

std::string record_text(const JobRecord& record) {
  Json json = json_of(record);
  json["job"] = record.job;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

JobRecord parse_record(const std::string& text) {
  const Json json = Json::parse(text);
  JobRecord record = record_of(json);
  record.job = json.at("job");
  return record;
}

std::string table_json(std::span<const BatchJob> jobs, std::span<const JobRecord> records) {
  Json rows = Json::array();
  std::array<std::size_t, kOutcomes.size()> counts{};
  for (const JobRecord& record : records) {
    Json row = {{"name", jobs[record.job].name}};
    row.update(json_of(record));
    row["outputs"] = is_good(record.outcome) ? Json(jobs[record.job].outputs) : Json::array();
    rows.push_back(std::move(row));
    ++counts[static_cast<std::size_t>(record.outcome)];
  }
  Json json = {{"jobs", std::move(rows)}};
  for (std::size_t i = 0; i < counts.size(); ++i) json["counts"][std::string(kOutcomes[i])] = counts[i];
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace quarry
