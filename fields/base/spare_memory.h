#pragma once

namespace slackwater {

/// Gives the pages of freed memory back to the system, some milliseconds of work: for a program
/// that lasts, after an answer whose making took far more memory than it has itself. Each thread
/// of a pool would keep its own otherwise, for whatever it makes next. Where the C library is not
/// glibc nothing is done.
void give_back_spare_memory() noexcept;

}  // namespace slackwater
