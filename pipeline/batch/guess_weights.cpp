#include "pipeline/batch/guess_weights.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <exception>

#include <cerrno>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "engine/base/log.hpp"

namespace quarry {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kForOne{500};
constexpr std::chrono::seconds kForAll{10};

// A process that guesses from one index on, and writes what it finds.
class Guesser {
 public:
  Guesser(std::size_t first, std::size_t count, const std::function<double(std::size_t)>& guess) {
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) return;
    process_ = ::fork();
    if (process_ == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_DFL);
      run(pipe[1], first, count, guess);
    }
    ::close(pipe[1]);
    pipe_ = pipe[0];
  }
  ~Guesser() {
    if (pipe_ >= 0) ::close(pipe_);
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  Guesser(const Guesser&) = delete;
  Guesser& operator=(const Guesser&) = delete;

  // The next one; none where it does not come.
  std::optional<double> next() const {
    pollfd wait{pipe_, POLLIN, 0};
    double value = 0;
    if (pipe_ < 0 || ::poll(&wait, 1, static_cast<int>(kForOne.count())) <= 0 ||
        ::read(pipe_, &value, sizeof value) != sizeof value)
      return std::nullopt;
    return value;
  }

 private:
  [[noreturn]] static void run(int pipe, std::size_t first, std::size_t count,
                               const std::function<double(std::size_t)>& guess) {
    // What there is to be told of an input, its job tells.
    log::set_level(log::Level::kQuiet);
    for (std::size_t i = first; i < count; ++i) {
      double value = 0;
      try {
        value = guess(i);
      } catch (const std::exception&) {
        // So is what is wrong with it.
      }
      if (::write(pipe, &value, sizeof value) != sizeof value) break;
    }
    // Nothing of the parent's is to be ended or written twice.
    ::_exit(0);
  }

  pid_t process_ = -1;
  int pipe_ = -1;
};

}  // namespace

std::vector<std::optional<double>> guess_weights(std::size_t count,
                                                 const std::function<double(std::size_t)>& guess,
                                                 const Progress& progress) {
  std::vector<std::optional<double>> weights(count);
  const Clock::time_point end = Clock::now() + kForAll;
  for (std::size_t i = 0; i < count;) {
    const Guesser guesser(i, count, guess);
    for (bool goes_on = true; goes_on && i < count; ++i) {
      progress.report("looking", static_cast<double>(i) / static_cast<double>(count));
      if (Clock::now() > end) return weights;
      const std::optional<double> value = guesser.next();
      goes_on = value.has_value();
      if (value && *value > 0 && std::isfinite(*value)) weights[i] = value;
    }
  }
  return weights;
}

}  // namespace quarry
