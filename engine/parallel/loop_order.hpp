// Tells the thread sanitizer what order a loop guarantees. It cannot see into oneTBB's library, which is not
// built with it, and would report each loop as a race with what follows. Empty in every other build.
#pragma once

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define QUARRY_THREAD_SANITIZER 1
#include <sanitizer/tsan_interface.h>
#endif
#endif

namespace quarry::parallel::detail {

#ifdef QUARRY_THREAD_SANITIZER

// All before the loop happens before its chunks, and all chunks before what follows the loop. The chunks get
// no order among themselves, so races between them are still found.
class LoopOrder {
 public:
  LoopOrder() { __tsan_release(&begin_); }
  ~LoopOrder() { __tsan_acquire(&end_); }
  LoopOrder(const LoopOrder&) = delete;
  LoopOrder& operator=(const LoopOrder&) = delete;

  // Alive while a chunk runs.
  class Chunk {
   public:
    explicit Chunk(LoopOrder& loop) : loop_(loop) { __tsan_acquire(&loop.begin_); }
    ~Chunk() { __tsan_release(&loop_.end_); }
    Chunk(const Chunk&) = delete;
    Chunk& operator=(const Chunk&) = delete;

   private:
    LoopOrder& loop_;
  };

 private:
  char begin_ = 0;
  char end_ = 0;
};

#else

struct LoopOrder {
  struct Chunk {
    explicit Chunk(LoopOrder&) {}
  };
};

#endif

}  // namespace quarry::parallel::detail
