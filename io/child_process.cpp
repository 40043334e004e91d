#include "io/child_process.hpp"

#include <csignal>
#include <cstring>
#include <thread>

#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "engine/base/error.hpp"

namespace quarry {
namespace {

constexpr std::chrono::milliseconds kLook{2};
// What a shell gives for a program that cannot be run, and posix_spawn where it learns of it too late.
constexpr int kNotFound = 127;

class FileActions {
 public:
  FileActions(const std::string& out, const std::string& err) {
    posix_spawn_file_actions_init(&actions_);
    constexpr int kWrite = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, out.c_str(), kWrite, 0600);
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, err.c_str(), kWrite, 0600);
  }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

// Ends the program where it is still there when the caller leaves.
class Running {
 public:
  explicit Running(pid_t process) : process_(process) {}
  ~Running() {
    if (ended_) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  // True once it has ended, with its status.
  bool ended(int& status) {
    const pid_t found = ::waitpid(process_, &status, WNOHANG);
    ended_ = found == process_ || (found < 0 && errno != EINTR);
    return ended_;
  }

 private:
  pid_t process_;
  bool ended_ = false;
};

}  // namespace

std::optional<int> run_program(const ChildProcess& process, const Progress& progress) {
  std::vector<std::string> words = process.words;
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const FileActions actions(process.out, process.err);
  pid_t id = 0;
  const int failure = ::posix_spawnp(&id, pointers[0], actions.get(), nullptr, pointers.data(), environ);
  if (failure == ENOENT) return std::nullopt;
  if (failure != 0)
    throw Error(ErrorKind::kOutput, fmt::format("{}: cannot be run: {}", words[0], std::strerror(failure)));
  Running running(id);
  const auto end = std::chrono::steady_clock::now() + process.time_limit;
  int status = 0;
  while (!running.ended(status)) {
    progress.throw_if_cancelled();
    if (std::chrono::steady_clock::now() > end)
      throw Error(ErrorKind::kBudget,
                  fmt::format("{}: not done after {} seconds", words[0], process.time_limit.count()));
    std::this_thread::sleep_for(kLook);
  }
  // An interrupt reaches both programs; this one may learn of it later.
  progress.throw_if_cancelled();
  const int code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return code == kNotFound ? std::nullopt : std::optional(code);
}

}  // namespace quarry
