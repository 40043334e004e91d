// Wall-clock seconds, for reports; nothing that is computed may depend on them.
#pragma once

#include <chrono>
#include <utility>

namespace quarry {

class Stopwatch {
 public:
  // Seconds since it was made, or since the last lap.
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  // The same, and starts anew.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Runs work() and adds its seconds to a sum.
template <class Work>
void add_time(double& seconds, const Work& work) {
  const Stopwatch watch;
  work();
  seconds += watch.seconds();
}

}  // namespace quarry
