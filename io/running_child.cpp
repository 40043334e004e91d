#include "io/running_child.hpp"

#include <array>
#include <csignal>
#include <cstring>
#include <fstream>
#include <string_view>

#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <linux/close_range.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "engine/base/error.hpp"

namespace quarry {
namespace {

// What keeps the program from running, as the child tells its parent.
struct Failure {
  enum class Step { kFiles, kProgram } step;
  int reason;
};

// Texts as the system wants them: pointers, the last of them null.
class Pointers {
 public:
  explicit Pointers(std::vector<std::string> texts) : texts_(std::move(texts)) {
    for (std::string& text : texts_) pointers_.push_back(text.data());
    pointers_.push_back(nullptr);
  }
  [[nodiscard]] char** get() { return pointers_.data(); }

 private:
  std::vector<std::string> texts_;
  std::vector<char*> pointers_;
};

std::vector<std::string> environment_with(const std::vector<std::pair<std::string, std::string>>& more) {
  std::vector<std::string> all;
  for (const auto& [name, value] : more) all.push_back(name + "=" + value);
  const std::size_t added = all.size();
  for (char** at = environ; *at != nullptr; ++at) {
    const std::string_view variable(*at);
    bool replaced = false;
    for (std::size_t i = 0; i < added; ++i)
      replaced |= variable.starts_with(std::string_view(all[i]).substr(0, all[i].find('=') + 1));
    if (!replaced) all.emplace_back(variable);
  }
  return all;
}

bool redirect(const char* path, int flags, int descriptor) {
  const int file = ::open(path, flags | O_CLOEXEC, 0600);
  return file >= 0 && ::dup2(file, descriptor) >= 0;
}

// Where memory runs out, the system ends this program first, and not the one that looks after it.
void offer_memory() {
  const int file = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
  constexpr std::string_view kScore = "500";
  if (file >= 0) static_cast<void>(::write(file, kScore.data(), kScore.size()) < 0);
}

// Between fork and exec: other threads of the parent may have held any lock, so only calls that need none.
[[noreturn]] void become(const ChildStart& start, char** words, char** environment, pid_t parent,
                         int failure_pipe) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  ::close_range(STDERR_FILENO + 1, ~0U, CLOSE_RANGE_CLOEXEC);
  offer_memory();
  constexpr int kWrite = O_WRONLY | O_CREAT | O_TRUNC;
  Failure failure{Failure::Step::kFiles, 0};
  if (redirect("/dev/null", O_RDONLY, STDIN_FILENO) && redirect(start.out.c_str(), kWrite, STDOUT_FILENO) &&
      redirect(start.err.c_str(), kWrite, STDERR_FILENO)) {
    failure.step = Failure::Step::kProgram;
    ::execvpe(words[0], words, environment);
  }
  failure.reason = errno;
  static_cast<void>(::write(failure_pipe, &failure, sizeof failure) < 0);
  ::_exit(127);
}

[[noreturn]] void fail_to_start(const ChildStart& start, int reason) {
  throw Error(ErrorKind::kOutput,
              fmt::format("{}: cannot be run: {}", start.words[0], std::strerror(reason)));
}

std::uint64_t resident_bytes_of(int process) {
  std::ifstream file(fmt::format("/proc/{}/statm", process));
  std::uint64_t total = 0, resident = 0;
  if (!(file >> total >> resident)) return 0;
  return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

std::optional<RunningChild> RunningChild::start(const ChildStart& start) {
  Pointers words(start.words), environment(environment_with(start.environment));
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) fail_to_start(start, errno);
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process == 0) become(start, words.get(), environment.get(), parent, pipe[1]);
  const int refused = errno;
  ::close(pipe[1]);
  Failure failure{};
  ssize_t told = 0;
  // The pipe closes without a word when the program runs.
  while (process > 0 && (told = ::read(pipe[0], &failure, sizeof failure)) < 0 && errno == EINTR) {
  }
  ::close(pipe[0]);
  if (process < 0) fail_to_start(start, refused);
  // The header of glibc 2.36 declares no such function for C++.
  RunningChild child(process, static_cast<int>(::syscall(SYS_pidfd_open, process, 0)));
  if (told > 0) {
    if (failure.step == Failure::Step::kProgram && failure.reason == ENOENT) return std::nullopt;
    fail_to_start(start, failure.reason);
  }
  if (child.descriptor_ < 0) fail_to_start(start, errno);
  return child;
}

RunningChild::RunningChild(RunningChild&& other) noexcept
    : process_(std::exchange(other.process_, -1)), descriptor_(std::exchange(other.descriptor_, -1)) {}

RunningChild::~RunningChild() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (process_ < 0) return;
  kill();
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

std::optional<ChildEnd> RunningChild::ended() {
  siginfo_t info{};
  // Nobody else gets its number, and its group's, until it has been waited for.
  if (::waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
      info.si_pid == 0)
    return std::nullopt;
  // What it has left running in its group has nobody to report to.
  kill();
  int status = 0;
  rusage usage{};
  while (::wait4(process_, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  process_ = -1;
  ChildEnd end;
  end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  end.exit_code = end.signal != 0 ? 128 + end.signal : WEXITSTATUS(status);
  end.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  end.peak_bytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  return end;
}

void RunningChild::kill() const { ::kill(-process_, SIGKILL); }

std::uint64_t RunningChild::resident_bytes() const {
  std::uint64_t bytes = resident_bytes_of(process_);
  std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", process_));
  for (int child = 0; children >> child;) bytes += resident_bytes_of(child);
  return bytes;
}

}  // namespace quarry
