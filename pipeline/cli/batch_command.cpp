#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "io/atomic_file.hpp"
#include "io/mesh/mesh_format.hpp"
#include "pipeline/batch/batch_folder.hpp"
#include "pipeline/batch/records.hpp"
#include "pipeline/batch/supervisor.hpp"
#include "pipeline/batch/time_left.hpp"
#include "pipeline/cli/batch_jobs.hpp"
#include "pipeline/cli/commands.hpp"
#include "pipeline/cli/config_file.hpp"
#include "pipeline/cli/progress_bar.hpp"

namespace quarry::cli {
namespace {

BatchOptions options_of(const BatchArguments& arguments) {
  BatchOptions options;
  options.worker = {std::filesystem::read_symlink("/proc/self/exe").string(), "mesh"};
  options.version = QUARRY_VERSION;
  options.threads = arguments.mesh.common.resolved_threads();
  options.job_seconds = arguments.job_seconds;
  options.job_bytes = arguments.job_bytes;
  options.memory_bytes = arguments.bytes.value_or(usual_memory_limit());
  return options;
}

void check(const BatchArguments& arguments) {
  if (arguments.mesh.section.inputs.empty())
    throw Error(ErrorKind::kUsage, "no job is given: name folders, lists or files; see quarry batch --help");
  if (arguments.mesh.output.empty())
    throw Error(ErrorKind::kUsage, "no folder is given to write to: name it with -o DIR");
  check_writable_extension("mesh." + arguments.format);
}

void tell_record(const BatchJob& job, const JobRecord& record) {
  if (is_good(record.outcome))
    log::detail("{}: {} in {:.2f} s", job.name, outcome_text(record.outcome), record.seconds);
  else
    log::warn("{}: {}: {}", job.name, outcome_text(record.outcome), record.message);
}

// One record for each job, in the order of the list.
std::vector<JobRecord> complete(std::size_t count, const std::vector<JobRecord>& known) {
  std::vector<JobRecord> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i].job = i;
  for (const JobRecord& record : known) all[record.job] = record;
  return all;
}

void tell(const BatchArguments& arguments, const BatchFolder& folder, const std::vector<BatchJob>& jobs,
          const std::vector<JobRecord>& records) {
  const std::string json = table_json(jobs, records);
  write_file(folder.table(), json);
  const std::string text = arguments.json ? json : table_text(jobs, records);
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

void run(const CLI::App& command, const BatchArguments& arguments) {
  check(arguments);
  const auto began = std::chrono::steady_clock::now();
  const BatchJobs batch = make_batch_jobs(command, arguments);
  for (const std::string& note : batch.notes) log::info("{}", note);
  BatchOptions options = options_of(arguments);
  const BatchFolder folder(arguments.mesh.output);
  const BatchLock lock(folder);
  make_output_folders(batch.jobs);
  remove_partial_outputs(batch.jobs, 0);
  ProgressBar bar(!arguments.mesh.common.quiet);
  const Progress progress = bar.progress();
  BatchPlan plan = plan_batch(batch.jobs, folder, options.version, progress);
  options.on_record = [&](const JobRecord& record) {
    bar.clear();
    tell_record(batch.jobs[record.job], record);
  };
  JobShare share(std::move(plan.order));
  std::vector<JobRecord> known = run_batch(options, folder, batch.jobs, share, progress);
  bar.clear();
  known.insert(known.end(), plan.done.begin(), plan.done.end());
  const std::vector<JobRecord> records = complete(batch.jobs.size(), known);
  tell(arguments, folder, batch.jobs, records);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  log::info("{} jobs in {}: {}; what became of each is in {}", records.size(), duration_text(seconds),
            count_text(records), folder.table());
  if (progress.cancelled())
    throw Error(ErrorKind::kInterrupted, "interrupted: the same command goes on from here");
  const auto bad = std::ranges::count_if(records, [](const JobRecord& r) { return !is_good(r.outcome); });
  if (bad > 0)
    throw Error(ErrorKind::kJobs, fmt::format("{} of {} jobs did not end well; {} tells why", bad,
                                              records.size(), folder.table()));
}

void add_batch_options(CLI::App& command, BatchArguments& arguments) {
  add_mesh_options(command, arguments.mesh);
  // Each job has such files of its own.
  for (const char* name : {"--report", "--picture", "--page", "--repaired"})
    command.remove_option(command.get_option(name));
  command.get_option("inputs")
      ->description("folders: each file of lines or surface in them is a job; lists of jobs (.toml); files")
      ->type_name("JOBS|DIR");
  command.get_option("--output")
      ->description(
          "the folder for meshes, reports (NAME.json) and, in its folder `batch`, what became of each")
      ->type_name("DIR");
  command.get_option("--threads")
      ->description(
          "of all jobs that run at the same time, together; 0: one for each core. Never changes a result");
  command.add_option("--format", arguments.format, "extension of the meshes; default vtu")
      ->type_name("EXTENSION")
      ->group("Output");
  command.add_option("--pictures", arguments.pictures, "a drawing of each mesh")
      ->check(CLI::IsMember({"svg", "png"}).description(""))
      ->type_name("svg|png")
      ->group("Output");
  command.add_flag("--pages", arguments.pages, "a page of each mesh, with a view that turns")
      ->group("Output");
  command.add_flag("--json", arguments.json, "the table in the end is JSON")->group("Output");
  const char* limits = "Limits";
  command.add_option("--job-time", arguments.job_seconds, "a job that takes longer is ended; 90, 15m, 2h")
      ->transform(CLI::AsNumberWithUnit(std::map<std::string, double>{{"s", 1}, {"m", 60}, {"h", 3600}},
                                        CLI::AsNumberWithUnit::CASE_SENSITIVE)
                      .description(""))
      ->check(CLI::PositiveNumber.description(""))
      ->type_name("TIME")
      ->group(limits);
  const auto size_option = [&](const char* name, auto& value, const char* help) {
    command.add_option(name, value, help)
        ->transform(CLI::AsSizeValue(true).description(""))
        ->type_name("SIZE")
        ->group(limits);
  };
  size_option("--job-memory", arguments.job_bytes, "a job that takes more memory is ended; 500MB, 4GB");
  size_option("--memory", arguments.bytes,
              "of all jobs together; beyond it the largest is ended, and done again when no other is left; "
              "default nine tenths of the machine's");
}

}  // namespace

void add_batch_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("batch", "many models on every core");
  const auto arguments = std::make_shared<BatchArguments>();
  add_batch_options(*command, *arguments);
  command->footer(
      "\nA list has a table [defaults] and a table [[job]] for each job: input (a file, or several that are "
      "meshed\ntogether), name, output, and options of quarry mesh without their dashes. What the command "
      "line "
      "gives wins.\nRun again, the same command passes over what is done. Exit code 8: some jobs did not end "
      "well."
      "\n\nExample: quarry batch sections -o meshes --size 5 --job-time 10m");
  command->callback([command, arguments] {
    const CommonArguments& common = arguments->mesh.common;
    if (!arguments->mesh.config.empty()) apply_config(*command, arguments->mesh.config);
    if (common.verbose) log::set_level(log::Level::kVerbose);
    if (common.quiet) log::set_level(log::Level::kQuiet);
    run(*command, *arguments);
  });
}

}  // namespace quarry::cli
