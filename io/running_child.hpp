// Another program that runs beside this one: started without a shell, looked at without waiting, and ended
// with this one at the latest.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace quarry {

struct ChildStart {
  // The program, found in PATH, and what it is given.
  std::vector<std::string> words;
  // Files that take what it writes; its standard input is empty.
  std::string out, err;
  // Variables of its environment beside those of this program.
  std::vector<std::pair<std::string, std::string>> environment{};
};

struct ChildEnd {
  int exit_code = 0;  // 128 + n where signal n ended it
  int signal = 0;     // 0: it ended by itself
  double cpu_seconds = 0;
  std::uint64_t peak_bytes = 0;  // of resident memory; with what it waited for
};

// The program leads a process group of its own, so that an interrupt at the terminal reaches this program
// alone, which ends the other. It is killed when it goes out of scope, and by the system when the thread that
// started it dies of whatever cause.
class RunningChild {
 public:
  // None if there is no such program. Throws Error(kOutput) where it cannot be started.
  [[nodiscard]] static std::optional<RunningChild> start(const ChildStart& start);
  ~RunningChild();
  RunningChild(RunningChild&& other) noexcept;
  RunningChild& operator=(RunningChild&&) = delete;

  [[nodiscard]] int process() const { return process_; }
  // Becomes readable, for poll(2), when the program has ended.
  [[nodiscard]] int descriptor() const { return descriptor_; }
  // How it ended; none while it runs. To be asked no more once it has told.
  [[nodiscard]] std::optional<ChildEnd> ended();
  // Ends it and all of its group at once.
  void kill() const;
  // Resident memory of the program and of those that it has started, as it is now.
  [[nodiscard]] std::uint64_t resident_bytes() const;

 private:
  RunningChild(int process, int descriptor) : process_(process), descriptor_(descriptor) {}

  int process_ = -1;  // -1: nothing is left to end
  int descriptor_ = -1;
};

}  // namespace quarry
