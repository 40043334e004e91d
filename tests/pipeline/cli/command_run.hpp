// Runs the built command as its users do: a process of its own, with its exit code, what it printed, and a
// time limit.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace quarry {

struct CommandResult {
  int exit_code = -1;  // -1: ended by a signal or by the time limit
  std::string out;
  std::string err;

  // Lines on the standard error stream.
  [[nodiscard]] std::size_t error_lines() const;
};

struct CommandOptions {
  int time_limit_seconds = 120;
  // A file that is the standard input; "": an empty one.
  std::string input;
  // A file or device that is the standard output; "": what comes there is in CommandResult::out.
  std::string output;
  // Asked for a signal to send each few milliseconds until it names one; 0: none yet. Gets what the command
  // has written to the standard error stream so far.
  std::function<int(const std::string& err)> signal;
};

// Runs `quarry ARGUMENTS...`.
[[nodiscard]] CommandResult run_quarry(const std::vector<std::string>& arguments,
                                       const CommandOptions& options = {});

// A folder of its own for one test, removed with everything in it.
class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  [[nodiscard]] std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  // Writes a file and returns its path.
  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const;
  // Names of all files, sorted.
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::string path_;
};

// The whole file; "" if there is none.
[[nodiscard]] std::string read_text(const std::string& path);

// The section that ships with the repository: 127 lines, 899 by 450 units.
inline constexpr const char* kDemoSection = "tests/data/demo_section.geojson";

}  // namespace quarry
