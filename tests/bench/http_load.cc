#include "tests/bench/http_load.h"

#include <regex>

#include "fields/base/error.h"
#include "tests/bench/timed_child.h"

namespace slackwater::bench {
namespace {

/// The milliseconds of "635.00us", "2.13ms", "1.02s", "1.5m".
double milliseconds_of(const std::string& value, const std::string& unit) {
  const double number = std::stod(value);
  if (unit == "us") return number / 1e3;
  if (unit == "ms") return number;
  return unit == "s" ? number * 1e3 : number * 60e3;
}

std::smatch found_in(const std::string& report, const std::string& form) {
  std::smatch match;
  if (!std::regex_search(report, match, std::regex(form))) {
    throw Error(ErrorKind::invalid_input,
                "the report of wrk has no line of the form '" + form + "': " + report);
  }
  return match;
}

double percentile_ms(const std::string& report, const std::string& percentile) {
  const std::smatch match = found_in(report, percentile + "%\\s+([0-9.]+)(us|ms|s|m)");
  return milliseconds_of(match[1], match[2]);
}

}  // namespace

LocalUrl parse_local_url(const std::string& url) {
  std::smatch match;
  if (!std::regex_match(url, match, std::regex("http://127\\.0\\.0\\.1:([0-9]{1,5})(/.*)"))) {
    throw Error(ErrorKind::usage,
                "found '" + url + "'; a URL http://127.0.0.1:<port>/<path> is expected");
  }
  return {static_cast<std::uint16_t>(std::stoul(match[1])), match[2]};
}

HttpLoad parse_wrk(const std::string& report) {
  HttpLoad load;
  load.requests_per_s = std::stod(found_in(report, "Requests/sec:\\s+([0-9.]+)")[1]);
  load.p50_ms = percentile_ms(report, "50");
  load.p99_ms = percentile_ms(report, "99");
  std::smatch match;
  if (std::regex_search(report, match, std::regex("Non-2xx or 3xx responses: ([0-9]+)"))) {
    load.bad_answers = std::stoull(match[1]);
  }
  const std::regex errors(
      "Socket errors: connect ([0-9]+), read ([0-9]+), write ([0-9]+), timeout ([0-9]+)");
  if (std::regex_search(report, match, errors)) {
    for (std::size_t i = 1; i < match.size(); ++i) load.socket_errors += std::stoull(match[i]);
  }
  return load;
}

std::optional<HttpLoad> load_with_wrk(const std::string& url, int seconds) {
  const ChildCost wrk =
      timed_child({"wrk", "-t1", "-c16", "-d" + std::to_string(seconds) + "s", "--latency", url});
  if (wrk.exit_code == 127) return std::nullopt;
  return parse_wrk(wrk.out);
}

}  // namespace slackwater::bench
