#pragma once
#include <cstddef>

namespace slackwater::bench {

/// Calls of operator new so far. A program that links counted_allocations.cc counts them.
[[nodiscard]] std::size_t allocations() noexcept;
/// What they asked for so far, in this thread.
[[nodiscard]] std::size_t allocated_bytes() noexcept;

}  // namespace slackwater::bench
