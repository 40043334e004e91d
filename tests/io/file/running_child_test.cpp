#include "io/running_child.hpp"

#include <csignal>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include "engine/base/error.hpp"
#include "io/scratch_folder.hpp"

namespace quarry {
namespace {

class Beside : public testing::Test {
 protected:
  RunningChild start(const std::string& script) {
    return RunningChild::start({{"sh", "-c", script},
                                folder_.file("out"),
                                folder_.file("err"),
                                {{"QUARRY_TEST", "a b"}, {"PATH", ::getenv("PATH")}}})
        .value();
  }
  static ChildEnd wait(RunningChild& child) {
    for (;;) {
      pollfd descriptor{child.descriptor(), POLLIN, 0};
      ::poll(&descriptor, 1, 10'000);
      if (const std::optional<ChildEnd> end = child.ended()) return *end;
    }
  }
  [[nodiscard]] std::string written() const {
    std::ifstream file(folder_.file("out"));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  // The number that a program writes first; waits for it.
  [[nodiscard]] int number() const {
    for (;;) {
      const std::string text = written();
      if (!text.empty() && text.back() == '\n') return std::stoi(text);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  // Whether a process is there, or is on its way out.
  static bool is_there(int process) {
    for (int look = 0; look < 2000; ++look) {
      if (::kill(process, 0) != 0) return false;
      std::ifstream file("/proc/" + std::to_string(process) + "/stat");
      std::string number, name, state;
      if (!(file >> number >> name >> state) || state == "Z") return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
  }

  ScratchFolder folder_;
};

TEST_F(Beside, TellsHowItEndedAndWhatItTook) {
  RunningChild child = start("exit 3");
  const ChildEnd end = wait(child);
  EXPECT_EQ(end.exit_code, 3);
  EXPECT_EQ(end.signal, 0);
  EXPECT_GT(end.peak_bytes, 0U);
  EXPECT_GE(end.cpu_seconds, 0.0);
}

TEST_F(Beside, TellsTheSignalThatEndedIt) {
  RunningChild child = start("kill -SEGV $$");
  const ChildEnd end = wait(child);
  EXPECT_EQ(end.signal, SIGSEGV);
  EXPECT_EQ(end.exit_code, 128 + SIGSEGV);
}

TEST_F(Beside, HasMoreVariablesInItsEnvironment) {
  RunningChild child = start("echo \"$QUARRY_TEST|$HOME\"");
  (void)wait(child);
  const char* home = ::getenv("HOME");
  EXPECT_EQ(written(), std::string("a b|") + (home == nullptr ? "" : home) + "\n");
}

TEST_F(Beside, EndsWithAllThatItStartedWhenItIsKilled) {
  RunningChild child = start("sleep 600 & echo $!; wait");
  const int grandchild = number();
  EXPECT_GT(child.resident_bytes(), 0U);
  EXPECT_EQ(child.ended(), std::nullopt);
  child.kill();
  EXPECT_EQ(wait(child).signal, SIGKILL);
  EXPECT_FALSE(is_there(grandchild));
}

TEST_F(Beside, LeavesNothingBehindWhenItEndsByItself) {
  RunningChild child = start("sleep 600 & echo $!");
  EXPECT_EQ(wait(child).exit_code, 0);
  EXPECT_FALSE(is_there(number()));
}

TEST_F(Beside, DiesWithItsStarter) {
  const pid_t starter = ::fork();
  if (starter == 0) {
    const RunningChild child = start("echo $$; exec sleep 600");
    (void)number();
    // Killed like this it cannot end anything itself.
    ::raise(SIGKILL);
  }
  ::waitpid(starter, nullptr, 0);
  EXPECT_FALSE(is_there(number()));
}

TEST_F(Beside, IsAnErrorWhereItsFilesCannotBeWritten) {
  try {
    (void)RunningChild::start({{"true"}, folder_.file("no/such/folder"), "/dev/null", {}});
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kOutput);
  }
  EXPECT_FALSE(RunningChild::start({{"no_such_program_at_all"}, "/dev/null", "/dev/null", {}}).has_value());
}

}  // namespace
}  // namespace quarry
