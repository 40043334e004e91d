#include "engine/base/progress.hpp"

#include "engine/base/error.hpp"

namespace quarry {

void Progress::report(std::string_view stage, double share) const {
  throw_if_cancelled();
  if (sink_) sink_(stage, share);
}

void Progress::throw_if_cancelled() const {
  if (cancelled()) throw Error(ErrorKind::kInterrupted, "interrupted: nothing was written");
}

}  // namespace quarry
