#include "pipeline/batch/batch_folder.hpp"

#include <cstring>
#include <filesystem>
#include <map>
#include <set>

#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "engine/base/error.hpp"
#include "io/atomic_file.hpp"

namespace quarry {
namespace {

namespace fs = std::filesystem;

void make_folder(const fs::path& path) {
  std::error_code failure;
  fs::create_directories(path, failure);
  if (failure)
    throw Error(ErrorKind::kOutput,
                fmt::format("{}: no such folder can be made: {}", path.string(), failure.message()));
}

fs::path folder_of(const std::string& file) {
  const fs::path folder = fs::path(file).parent_path();
  return folder.empty() ? "." : folder;
}

}  // namespace

BatchFolder::BatchFolder(std::string path) : path_(std::move(path)) {
  make_folder(path_ + "/batch/logs");
  make_folder(path_ + "/batch/records");
}

std::string BatchFolder::log(const BatchJob& job) const { return path_ + "/batch/logs/" + job.name + ".log"; }

std::string BatchFolder::record(const BatchJob& job) const {
  return path_ + "/batch/records/" + job.name + ".json";
}

std::string BatchFolder::table() const { return path_ + "/batch/table.json"; }

std::string BatchFolder::lock() const { return path_ + "/batch/lock"; }

BatchLock::BatchLock(const BatchFolder& folder) {
  const std::string path = folder.lock();
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  const int reason = errno;
  if (descriptor_ >= 0) ::close(descriptor_);
  throw Error(ErrorKind::kOutput,
              reason == EWOULDBLOCK ? fmt::format("{}: another batch is at work there; wait for it, or name "
                                                  "another folder",
                                                  folder.path())
                                    : fmt::format("{}: cannot be locked: {}", path, std::strerror(reason)));
}

BatchLock::~BatchLock() { ::close(descriptor_); }

void make_output_folders(std::span<const BatchJob> jobs) {
  std::set<fs::path> folders;
  for (const BatchJob& job : jobs)
    for (const std::string& output : job.outputs) folders.insert(folder_of(output));
  for (const fs::path& folder : folders) make_folder(folder);
}

void remove_partial_outputs(std::span<const BatchJob> jobs, int process) {
  std::map<fs::path, std::set<std::string>> names;
  for (const BatchJob& job : jobs)
    for (const std::string& output : job.outputs)
      names[folder_of(output)].insert(fs::path(output).filename());
  std::error_code failure;
  for (const auto& [folder, outputs] : names)
    for (fs::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure)) {
      const std::optional<PartialFile> partial = parse_partial_name(at->path().filename().string());
      std::error_code ignored;
      if (partial && (process == 0 || partial->process == process) && outputs.contains(partial->target))
        fs::remove(at->path(), ignored);
    }
}

}  // namespace quarry
