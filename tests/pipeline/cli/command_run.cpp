#include "tests/pipeline/cli/command_run.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

namespace quarry {
namespace {

class FileActions {
 public:
  FileActions(const std::string& in, const std::string& out, const std::string& err) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, 0, in.empty() ? "/dev/null" : in.c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions_, 2, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

pid_t start(const std::vector<std::string>& arguments, const FileActions& actions) {
  std::vector<std::string> words = {QUARRY_COMMAND};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t process = 0;
  if (posix_spawn(&process, words[0].c_str(), actions.get(), nullptr, pointers.data(), environ) != 0)
    throw std::runtime_error("cannot run " + words[0]);
  return process;
}

// The status that waitpid gives, after the signal that was asked for or the time limit.
int wait_for(pid_t process, const std::string& err, const CommandOptions& options) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(options.time_limit_seconds);
  bool asked = static_cast<bool>(options.signal);
  int status = 0;
  while (waitpid(process, &status, WNOHANG) == 0) {
    if (asked) {
      const int number = options.signal(read_text(err));
      if (number != 0) kill(process, number);
      asked = number == 0;
    }
    if (std::chrono::steady_clock::now() > end) {
      kill(process, SIGKILL);
      waitpid(process, &status, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
  }
  return status;
}

}  // namespace

std::size_t CommandResult::error_lines() const {
  return static_cast<std::size_t>(std::count(err.begin(), err.end(), '\n'));
}

CommandResult run_quarry(const std::vector<std::string>& arguments, const CommandOptions& options) {
  const TestFolder folder;
  const std::string out = options.output.empty() ? folder / "out" : options.output;
  const std::string err = folder / "err";
  const FileActions actions(options.input, out, err);
  const int status = wait_for(start(arguments, actions), err, options);
  CommandResult result;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (options.output.empty()) result.out = read_text(out);
  result.err = read_text(err);
  return result;
}

TestFolder::TestFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "quarry_test_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
  path_ = name;
}

TestFolder::~TestFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string TestFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(*this / name, std::ios::binary) << text;
  return *this / name;
}

std::vector<std::string> TestFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace quarry
