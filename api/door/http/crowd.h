#pragma once
#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slackwater::api::http {

class Session;
struct Limits;

/// How a session waits for its client; where there is no room the first of these goes first.
enum class Wait {
  says_nothing,  ///< has not said one whole request
  reads_slowly,  ///< takes in its answer slowly: less than 128 kB/s
  at_rest,       ///< between two requests
};

/// A session that waits for its client.
struct Standing {
  Wait wait = Wait::says_nothing;
  std::chrono::steady_clock::time_point since;
  std::size_t answer_bytes = 0;  ///< that it holds
};

/// Who makes room for newcomers: by how they wait, of these those of the client that has
/// most, of these those that have waited longest. What has work in hand stays.
/// @param most  of them
[[nodiscard]] std::vector<std::shared_ptr<Session>> those_to_displace(
    const std::vector<std::shared_ptr<Session>>& sessions, const Limits& limits,
    std::chrono::steady_clock::time_point now, std::size_t most);

/// Slow readers that hold so many bytes together, the largest first; fewer where there are no more.
[[nodiscard]] std::vector<std::shared_ptr<Session>> slow_readers(
    const std::vector<std::shared_ptr<Session>>& sessions, std::size_t bytes);

}  // namespace slackwater::api::http
