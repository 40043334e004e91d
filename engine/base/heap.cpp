#include "engine/base/heap.hpp"

// Defines __GLIBC__ too.
#include <climits>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace quarry {

void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 256 << 20);
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
#endif
}

}  // namespace quarry
