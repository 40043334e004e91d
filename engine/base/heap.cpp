#include "engine/base/heap.hpp"

// Defines __GLIBC__ too.
#include <climits>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace quarry {
namespace {

bool keeps = false;  // set before threads are started

}  // namespace

void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 256 << 20);
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
  keeps = true;
#endif
}

void give_back_freed_memory() {
  if (!keeps) return;
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 4 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
  malloc_trim(0);
#endif
}

}  // namespace quarry
