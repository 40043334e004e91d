// How the process keeps the memory that it frees.
#pragma once

namespace quarry {

// Vectors of up to 256 MiB are taken from the heap, and what is freed stays there for the next ones. By
// default glibc maps each vector above 32 MiB anew and gives it back when it is freed: the pages are zeroed
// and faulted in each time, and other threads are stopped while they go. Without effect where there is
// another malloc. To be called before threads are started.
void keep_freed_memory();

// Gives back what is free now, and from now on vectors above 4 MiB as they are freed: for what needs most
// memory at last, after steps whose freed vectors do not fit it. Without effect unless freed memory was kept.
void give_back_freed_memory();

}  // namespace quarry
