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
  has_said_all,  ///< will say no more: it waits for its answer, or it is gone
  at_rest,       ///< between two requests
};

/// A session that waits for its client.
struct Standing {
  Wait wait = Wait::says_nothing;
  std::chrono::steady_clock::time_point since;
};

/// Who makes room for newcomers: by how they wait, of these those of the client that has
/// most, of these those that have waited longest. What has work in hand stays, while its client may
/// still say something.
/// @param most  of them
[[nodiscard]] std::vector<std::shared_ptr<Session>> those_to_displace(
    const std::vector<std::shared_ptr<Session>>& sessions, const Limits& limits,
    std::chrono::steady_clock::time_point now, std::size_t most);

/// Who lets go of its answer so that `client` can have one of so many bytes, where answers may hold
/// `limits.answer_bytes` together: slow readers; then, for a client within its share, those of the
/// clients that hold most and more than theirs. A share is the same part of the limit for each
/// client that holds any. The largest answers first; fewer than needed where there are no more.
[[nodiscard]] std::vector<std::shared_ptr<Session>> those_to_cut_off(
    const std::vector<std::shared_ptr<Session>>& sessions, const std::string& client,
    std::size_t bytes, const Limits& limits, std::chrono::steady_clock::time_point now);

}  // namespace slackwater::api::http
