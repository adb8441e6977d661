#pragma once
#include <cstddef>
#include <functional>

namespace slackwater {

/// Runs `work(i)` for i in [0, count) on up to `threads` threads, the caller's among them; the
/// first exception is thrown again here once all threads have stopped.
void for_all(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

}  // namespace slackwater
