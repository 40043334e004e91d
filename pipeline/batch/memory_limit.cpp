#include <algorithm>
#include <fstream>

#include <unistd.h>

#include "pipeline/batch/options.hpp"

namespace quarry {

std::uint64_t usual_memory_limit() {
  std::uint64_t bytes = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
                        static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  // In a container its own group is the root of what it sees. "max" stands for none.
  for (const char* file : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    std::uint64_t limit = 0;
    if (std::ifstream(file) >> limit && limit > 0) bytes = std::min(bytes, limit);
  }
  return bytes / 10 * 9;
}

}  // namespace quarry
