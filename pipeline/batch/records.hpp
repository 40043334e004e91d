// What became of jobs, kept: a file for each job, by which a batch that is run again knows what is done; and
// a table of all.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/batch/batch_folder.hpp"
#include "pipeline/batch/job.hpp"

namespace quarry {

// Adds what the report of a job that is done tells: its elements, and the hash of its input.
void add_report(const BatchJob& job, JobRecord& record);

// Writes the file of a job. Throws Error(kOutput).
void write_record(const BatchFolder& folder, const BatchJob& job, const JobRecord& record,
                  const std::string& version);

// What is known of a job that need not be run: it was done by this version with the same words on the same
// input, and its outputs have the size and the time of change that they were left with. None for all others.
[[nodiscard]] std::optional<JobRecord> find_done(const BatchFolder& folder, const BatchJob& job,
                                                 const std::string& version);

// One line of JSON, and what it says.
[[nodiscard]] std::string record_text(const JobRecord& record);
[[nodiscard]] JobRecord parse_record(const std::string& text);

// All jobs as JSON: {"jobs": [{"name", "outcome", "exit_code", "message", "seconds", ...}], "counts": {...}}.
[[nodiscard]] std::string table_json(std::span<const BatchJob> jobs, std::span<const JobRecord> records);

// All jobs for people: a row each, columns aligned.
[[nodiscard]] std::string table_text(std::span<const BatchJob> jobs, std::span<const JobRecord> records);

// "197 done, 2 crashed, 1 out of time"
[[nodiscard]] std::string count_text(std::span<const JobRecord> records);

}  // namespace quarry
