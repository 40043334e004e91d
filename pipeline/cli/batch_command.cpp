#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "io/atomic_file.hpp"
#include "io/mesh/mesh_format.hpp"
#include "pipeline/batch/batch_folder.hpp"
#include "pipeline/batch/plan_text.hpp"
#include "pipeline/batch/ranks.hpp"
#include "pipeline/batch/records.hpp"
#include "pipeline/batch/supervisor.hpp"
#include "pipeline/cli/batch_jobs.hpp"
#include "pipeline/cli/commands.hpp"
#include "pipeline/cli/config_file.hpp"
#include "pipeline/cli/outputs.hpp"
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
  write_standard_output(arguments.json ? json : table_text(jobs, records));
}

// The share of this rank in what the machine has.
void divide(BatchOptions& options, const BatchArguments& arguments, const Ranks& ranks) {
  if (arguments.mesh.common.threads == 0) {
    // A launcher may have bound this process to some of the cores: those are its share already.
    const int each = static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN)) / ranks.on_this_machine();
    options.threads = std::clamp(each, 1, options.threads);
  }
  if (!arguments.bytes) options.memory_bytes /= static_cast<std::uint64_t>(ranks.on_this_machine());
}

void finish(const BatchArguments& arguments, const BatchFolder& folder, const std::vector<BatchJob>& jobs,
            const std::vector<JobRecord>& records, const Progress& progress) {
  tell(arguments, folder, jobs, records);
  log::info("{} jobs: {}; what became of each is in {}", records.size(), count_text(records), folder.table());
  if (progress.cancelled())
    throw Error(ErrorKind::kInterrupted, "interrupted: the same command goes on from here");
  const auto bad = std::ranges::count_if(records, [](const JobRecord& r) { return !is_good(r.outcome); });
  if (bad > 0)
    throw Error(ErrorKind::kJobs, fmt::format("{} of {} jobs did not end well; {} tells why", bad,
                                              records.size(), folder.table()));
}

// Rank 0: finds the jobs, tells the others, does its share, and has the last word.
void lead(const CLI::App& command, const BatchArguments& arguments, BatchOptions& options, Ranks& ranks,
          const Progress& progress, ProgressBar& bar) {
  std::optional<BatchFolder> folder;
  std::optional<BatchLock> lock;
  BatchJobs batch;
  BatchPlan plan;
  try {
    check(arguments);
    batch = make_batch_jobs(command, arguments, progress);
    bar.clear();
    for (const std::string& note : batch.notes) log::info("{}", note);
    folder.emplace(arguments.mesh.output);
    lock.emplace(*folder);
    make_output_folders(batch.jobs);
    remove_partial_outputs(batch.jobs, 0);
    plan = plan_batch(batch.jobs, *folder, options.version, progress);
  } catch (const std::exception&) {
    static_cast<void>(ranks.broadcast(""));
    throw;
  }
  if (ranks.count() > 1) static_cast<void>(ranks.broadcast(plan_text({batch.jobs, plan.order})));
  options.on_record = [&](const JobRecord& record) {
    bar.clear();
    tell_record(batch.jobs[record.job], record);
  };
  const std::unique_ptr<JobShare> share = ranks.share(std::move(plan.order));
  std::vector<JobRecord> known = run_batch(options, *folder, batch.jobs, *share, progress);
  bar.clear();
  known.insert(known.end(), plan.done.begin(), plan.done.end());
  finish(arguments, *folder, batch.jobs, complete(batch.jobs.size(), known), progress);
}

// Every other rank. Rank 0 tells what went wrong before there was a plan.
void follow(const BatchArguments& arguments, const BatchOptions& options, Ranks& ranks,
            const Progress& progress) {
  const std::string text = ranks.broadcast("");
  if (text.empty()) return;
  SharedPlan plan = parse_plan(text);
  const BatchFolder folder(arguments.mesh.output);
  const std::unique_ptr<JobShare> share = ranks.share(std::move(plan.order));
  static_cast<void>(run_batch(options, folder, plan.jobs, *share, progress));
  if (progress.cancelled()) throw Error(ErrorKind::kInterrupted, "interrupted");
}

void run(const CLI::App& command, const BatchArguments& arguments) {
  const std::unique_ptr<Ranks> ranks = join_ranks();
  ProgressBar bar(!arguments.mesh.common.quiet && ranks->rank() == 0,
                  std::chrono::duration<double>(arguments.tell_seconds));
  const Progress progress = bar.progress();
  BatchOptions options = options_of(arguments);
  divide(options, arguments, *ranks);
  try {
    if (ranks->rank() == 0)
      lead(command, arguments, options, *ranks, progress, bar);
    else
      follow(arguments, options, *ranks, progress);
  } catch (const Error& error) {
    // Rank 0 ends like this when all others are through, or have not begun; else they must not wait for it.
    const bool in_order = error.kind() == ErrorKind::kJobs || error.kind() == ErrorKind::kUsage ||
                          error.kind() == ErrorKind::kInput;
    if (in_order || ranks->count() == 1) throw;
    bar.clear();
    log::write_error(error.message());
    ranks->abort(error.exit_code());
  } catch (const std::exception&) {
    ranks->abort(static_cast<int>(ErrorKind::kBug));
    throw;
  }
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
  const auto time_option = [&](const char* name, auto& value, const char* help, const char* group) {
    command.add_option(name, value, help)
        ->transform(CLI::AsNumberWithUnit(std::map<std::string, double>{{"s", 1}, {"m", 60}, {"h", 3600}},
                                          CLI::AsNumberWithUnit::CASE_SENSITIVE)
                        .description(""))
        ->check(CLI::PositiveNumber.description(""))
        ->type_name("TIME")
        ->group(group);
  };
  time_option("--tell-every", arguments.tell_seconds,
              "off a terminal, how often a line tells how far the batch is; default 1m", "Output");
  time_option("--job-time", arguments.job_seconds, "a job that takes longer is ended; 90, 15m, 2h", limits);
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
