#include "io/child_process.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <poll.h>

#include "engine/base/error.hpp"

namespace quarry {
namespace {

// How long an interrupt may go unseen.
constexpr std::chrono::milliseconds kLook{20};
// What a shell gives for a program that cannot be run.
constexpr int kNotFound = 127;

}  // namespace

std::optional<int> run_program(const ChildStart& start, const Progress& progress,
                               std::chrono::seconds time_limit) {
  std::optional<RunningChild> child = RunningChild::start(start);
  if (!child) return std::nullopt;
  const auto end = std::chrono::steady_clock::now() + time_limit;
  std::optional<ChildEnd> ended;
  while (!(ended = child->ended())) {
    progress.throw_if_cancelled();
    if (std::chrono::steady_clock::now() > end)
      throw Error(ErrorKind::kBudget,
                  fmt::format("{}: not done after {} seconds", start.words[0], time_limit.count()));
    pollfd wait{child->descriptor(), POLLIN, 0};
    ::poll(&wait, 1, static_cast<int>(kLook.count()));
  }
  progress.throw_if_cancelled();
  return ended->exit_code == kNotFound ? std::nullopt : std::optional(ended->exit_code);
}

}  // namespace quarry
