#pragma once

namespace slackwater {

/// Gives the pages of freed memory back to the system, some milliseconds of work: for a program
/// that lasts, after an answer whose making took far more memory than it has itself. Each thread
/// of a pool would keep its own otherwise, for whatever it makes next. Where the C library is not
/// glibc nothing is done.
void give_back_spare_memory() noexcept;

/// From now on memory that is freed at the end of a thread's own heap goes back to the system once
/// there are 8 MB of it, and blocks of 32 MB and more at once. Without this glibc raises both marks
/// by itself, up to 64 MB a thread, after the first large block is freed, and
/// `give_back_spare_memory` does not reach the ends of threads' heaps (mallopt(3), "Note").
void hold_little_spare_memory() noexcept;

}  // namespace slackwater
