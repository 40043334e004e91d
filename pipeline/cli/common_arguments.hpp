// What every command that works takes: how many threads, and how much to say.
#pragma once

#include <CLI/CLI.hpp>

#include "engine/base/log.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry::cli {

struct CommonArguments {
  int threads = 0;
  bool quiet = false;
  bool verbose = false;

  [[nodiscard]] int resolved_threads() const { return threads > 0 ? threads : parallel::hardware_threads(); }
};

inline void add_common_options(CLI::App& command, CommonArguments& arguments) {
  command
      .add_option("--threads", arguments.threads,
                  "how many threads to use; 0: one for each core. Never changes the result")
      ->check(CLI::Range(0, 1024))
      ->type_name("N")
      ->group("Running");
  command.add_flag("--quiet,-q", arguments.quiet, "only errors are told")->group("Running");
  command.add_flag("--verbose,-v", arguments.verbose, "more is told")->group("Running");
}

// Sets how much is told, and runs the job on the wanted number of threads.
template <class Job>
void run_job(const CommonArguments& arguments, Job&& job) {
  if (arguments.verbose) log::set_level(log::Level::kVerbose);
  if (arguments.quiet) log::set_level(log::Level::kQuiet);
  parallel::with_threads(arguments.resolved_threads(), job);
}

}  // namespace quarry::cli
