// What goes wrong for a reason that the user can act upon: one value with the kind, the place and the remedy.
// Broken invariants are not errors but bugs, and are asserted.
#pragma once

#include <exception>
#include <string>

namespace quarry {

// The kinds are the exit codes of the command (docs/contract.md).
enum class ErrorKind {
  kBug = 1,
  kUsage = 2,
  kInput = 3,
  kGeometry = 4,
  kBudget = 5,
  kQuality = 6,
  kOutput = 7,
  kJobs = 8,
  kInterrupted = 130,
};

class Error : public std::exception {
 public:
  // message: one line with the file, the feature or line number, the coordinates and what to do.
  Error(ErrorKind kind, std::string message) : kind_(kind), message_(std::move(message)) {}

  [[nodiscard]] ErrorKind kind() const { return kind_; }
  [[nodiscard]] int exit_code() const { return static_cast<int>(kind_); }
  [[nodiscard]] const std::string& message() const { return message_; }
  [[nodiscard]] const char* what() const noexcept override { return message_.c_str(); }

 private:
  ErrorKind kind_;
  std::string message_;
};

// A coordinate as people read it: enough digits to find the place in the input, no more.
std::string format_point(double x, double y);

}  // namespace quarry
