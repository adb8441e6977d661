#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace slackwater::bench {

/// What `wrk --latency` measured.
struct HttpLoad {
  double requests_per_s = 0;
  double p50_ms = 0;
  double p99_ms = 0;
  std::uint64_t bad_answers = 0;    ///< neither 2xx nor 3xx
  std::uint64_t socket_errors = 0;  ///< connect, read, write and timeout
};

/// http://127.0.0.1:<port><target>
struct LocalUrl {
  std::uint16_t port = 0;
  std::string target;
};

/// Throws Error(usage) for any other form.
[[nodiscard]] LocalUrl parse_local_url(const std::string& url);

/// Reads the report of wrk 4. Throws Error(invalid_input) that shows it where a figure is missing.
[[nodiscard]] HttpLoad parse_wrk(const std::string& report);

/// `wrk -t1 -c16 -d<seconds>s --latency <url>`; nothing where wrk is not installed. wrk asks for no
/// content coding.
[[nodiscard]] std::optional<HttpLoad> load_with_wrk(const std::string& url, int seconds);

}  // namespace slackwater::bench
