#include "pipeline/cli/batch_jobs.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string_view>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/input_text.hpp"
#include "io/lower_case.hpp"
#include "pipeline/batch/folder_inputs.hpp"
#include "pipeline/batch/guess_weights.hpp"
#include "pipeline/cli/batch_list.hpp"
#include "pipeline/cli/job_weight.hpp"
#include "pipeline/cli/mesh_surface_command.hpp"
#include "pipeline/section/section_report.hpp"

namespace quarry::cli {
namespace {

namespace fs = std::filesystem;

// Options of `quarry mesh` that a batch chooses for each job.
constexpr std::array<std::string_view, 10> kChosen = {"help",    "output",   "report",  "picture", "page",
                                                      "threads", "repaired", "verbose", "quiet",   "config"};

struct Source {
  std::vector<std::string> inputs;
  std::string name, output;
  std::function<void(CLI::App&)> apply;  // what a list says
};

void add_file(std::vector<Source>& sources, const std::string& path) {
  sources.push_back({{path}, "", "", [](CLI::App&) {}});
}

void add_folder(std::vector<Source>& sources, const std::string& path, const std::string& output,
                std::vector<std::string>& notes) {
  std::error_code ignored;
  if (fs::equivalent(path, output, ignored))
    throw Error(ErrorKind::kUsage,
                fmt::format("{}: is the folder of the models as well; name another one with -o", output));
  const FolderInputs inputs = list_inputs(path);
  for (const std::string& file : inputs.files) add_file(sources, file);
  constexpr std::size_t kNamed = 5;
  std::string names;
  for (std::size_t i = 0; i < std::min(inputs.passed_over.size(), kNamed); ++i)
    names += (i == 0 ? "" : ", ") + inputs.passed_over[i];
  if (!names.empty())
    notes.push_back(fmt::format("{}: passed over {} files that are neither lines nor surfaces: {}{}", path,
                                inputs.passed_over.size(), names,
                                inputs.passed_over.size() > kNamed ? " and so on" : ""));
}

void add_list(std::vector<Source>& sources, const std::string& path) {
  const auto list = std::make_shared<BatchList>(path);
  for (const ListedJob& job : list->jobs())
    sources.push_back(
        {job.inputs, job.name, job.output, [list, &job](CLI::App& mesh) { list->apply(job, mesh); }});
}

std::vector<Source> find_sources(const BatchArguments& arguments, std::vector<std::string>& notes) {
  std::vector<Source> sources;
  for (const std::string& path : arguments.mesh.section.inputs) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
      add_folder(sources, path, arguments.mesh.output, notes);
    else if (lower_case(fs::path(path).extension().string()) == ".toml")
      add_list(sources, path);
    else
      add_file(sources, path);
  }
  for (const Source& source : sources)
    if (std::ranges::count(source.inputs, kStandardInput) > 0)
      throw Error(ErrorKind::kUsage, "standard input is no input of a batch; name files");
  if (sources.empty())
    throw Error(ErrorKind::kInput, "there is no job: no file of lines and no surface in the folders named");
  return sources;
}

// Names that jobs do not have yet: of the first input without its extension; where several have that, with
// it; where that is not enough, with its folder.
void name_sources(std::vector<Source>& sources) {
  const std::array<std::function<std::string(const fs::path&)>, 3> rules = {
      [](const fs::path& path) { return path.stem().string(); },
      [](const fs::path& path) { return path.filename().string(); },
      [](const fs::path& path) {
        return fs::absolute(path).parent_path().filename().string() + "_" + path.filename().string();
      }};
  std::vector<Source*> unnamed;
  std::map<std::string, int> taken;
  for (Source& source : sources) {
    if (source.name.empty())
      unnamed.push_back(&source);
    else
      ++taken[source.name];
  }
  for (const auto& rule : rules) {
    std::map<std::string, int> wanted = taken;
    for (const Source* source : unnamed) ++wanted[rule(source->inputs.front())];
    std::erase_if(unnamed, [&](Source* source) {
      const std::string name = rule(source->inputs.front());
      if (name.empty() || wanted[name] > 1) return false;
      source->name = name;
      ++taken[name];
      return true;
    });
  }
  for (const auto& [name, count] : taken)
    if (count > 1)
      throw Error(ErrorKind::kUsage, fmt::format("{} jobs are called {}; name them apart", count, name));
  if (!unnamed.empty())
    throw Error(ErrorKind::kUsage, fmt::format("{}: two jobs have this input; give them names in a list",
                                               unnamed.front()->inputs.front()));
}

// What was given for an option that all jobs have: as words of a command line.
void append_words(const CLI::App& mesh, std::vector<std::string>& words) {
  for (const CLI::Option* option : mesh.get_options()) {
    const std::string name = option->get_lnames().empty() ? "" : option->get_lnames().front();
    if (name.empty() || option->count() == 0 || std::ranges::find(kChosen, name) != kChosen.end()) continue;
    const bool flag = option->get_expected_max() == 0;
    for (const std::string& value : option->results()) {
      if (!flag)
        words.push_back(fmt::format("--{}={}", name, value));
      else if (value != "false")
        words.push_back("--" + name);
    }
  }
}

void copy_given(const CLI::App& command, CLI::App& mesh) {
  for (CLI::Option* option : mesh.get_options()) {
    const std::string name = option->get_lnames().empty() ? "" : option->get_lnames().front();
    if (name.empty() || std::ranges::find(kChosen, name) != kChosen.end()) continue;
    const CLI::Option* given = command.get_option_no_throw("--" + name);
    if (given == nullptr || given->count() == 0) continue;
    for (const std::string& value : given->results()) option->add_result(value);
    option->run_callback();
  }
}

// The files that the job reads; none where its options make no sense, which it will tell itself.
std::vector<std::string> files_of(MeshArguments mesh) {
  try {
    if (is_surface(mesh.section.inputs)) return surface_input_files(mesh);
    fill_section(mesh);
    return input_files(mesh.section);
  } catch (const Error&) {
    return {};
  }
}

double bytes_of(const std::vector<std::string>& files) {
  double bytes = 0;
  for (const std::string& file : files) {
    std::error_code failure;
    const auto size = fs::file_size(file, failure);
    if (!failure) bytes += static_cast<double>(size);
  }
  return bytes;
}

struct Prepared {
  BatchJob job;
  MeshArguments mesh;
};

Prepared prepare_job(const Source& source, const CLI::App& command, const BatchArguments& arguments) {
  CLI::App app("", "mesh");
  MeshArguments mesh;
  add_mesh_options(app, mesh);
  copy_given(command, app);
  source.apply(app);
  BatchJob job;
  job.name = source.name;
  const auto place = [&](const std::string& file) {
    return (fs::path(arguments.mesh.output) / file).lexically_normal().string();
  };
  const auto add_output = [&](const char* option, std::string& path, const std::string& otherwise) {
    if (path.empty()) path = otherwise;
    if (path.empty()) return;
    path = place(path);
    job.outputs.push_back(path);
    job.words.insert(job.words.end(), {option, path});
  };
  for (const std::string& input : source.inputs) {
    job.words.push_back(input.starts_with("-") ? "./" + input : input);
    mesh.section.inputs.push_back(job.words.back());
  }
  mesh.output = source.output;
  add_output("--output", mesh.output, job.name + "." + arguments.format);
  add_output("--report", mesh.report, job.name + ".json");
  add_output("--picture", mesh.picture,
             arguments.pictures.empty() ? "" : job.name + "." + arguments.pictures);
  add_output("--page", mesh.page, arguments.pages ? job.name + ".html" : "");
  add_output("--repaired", mesh.repaired, "");
  append_words(app, job.words);
  job.report = mesh.report;
  job.inputs = files_of(mesh);
  job.weight = elements_of_bytes(bytes_of(job.inputs.empty() ? mesh.section.inputs : job.inputs));
  return {std::move(job), std::move(mesh)};
}

void check_files(const std::vector<BatchJob>& jobs) {
  std::error_code ignored;
  const auto full = [&](const std::string& path) { return fs::weakly_canonical(path, ignored).string(); };
  std::map<std::string, std::string> writers;
  for (const BatchJob& job : jobs)
    for (const std::string& output : job.outputs)
      if (const auto [at, first] = writers.emplace(full(output), job.name); !first)
        throw Error(ErrorKind::kUsage,
                    fmt::format("{}: is an output of {} and of {}", output, at->second, job.name));
  for (const BatchJob& job : jobs)
    for (const std::string& input : job.inputs)
      if (const auto at = writers.find(full(input)); at != writers.end())
        throw Error(ErrorKind::kUsage,
                    fmt::format("{}: is an input of {} and an output of {}", input, job.name, at->second));
}

// By what the jobs read, or its bytes where that tells nothing. A pipe would be read once only.
void weigh(std::vector<Prepared>& prepared, const Progress& progress) {
  const auto guess = [&](std::size_t i) {
    std::error_code ignored;
    for (const std::string& input : prepared[i].job.inputs)
      if (!fs::is_regular_file(input, ignored)) return 0.0;
    return foresee_elements(prepared[i].mesh);
  };
  const std::vector<std::optional<double>> weights = guess_weights(prepared.size(), guess, progress);
  for (std::size_t i = 0; i < prepared.size(); ++i)
    if (weights[i]) prepared[i].job.weight = *weights[i];
}

}  // namespace

BatchJobs make_batch_jobs(const CLI::App& command, const BatchArguments& arguments,
                          const Progress& progress) {
  BatchJobs batch;
  std::vector<Source> sources = find_sources(arguments, batch.notes);
  name_sources(sources);
  std::vector<Prepared> prepared;
  for (const Source& source : sources) prepared.push_back(prepare_job(source, command, arguments));
  weigh(prepared, progress);
  for (Prepared& each : prepared) batch.jobs.push_back(std::move(each.job));
  check_files(batch.jobs);
  return batch;
}

}  // namespace quarry::cli
