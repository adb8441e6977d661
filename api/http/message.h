#pragma once
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// A request and its response as our handlers see them, whatever library carries them.

namespace slackwater::api::http {

struct Request {
  std::string method;  ///< "GET", upper case
  std::string path;    ///< as sent, percent-encoded, without the query
  std::string query;   ///< as sent, without the '?'
  std::string host;    ///< Host header, "" where absent
  std::string accept;  ///< Accept header
  std::string body;
  bool is_trusted = false;  ///< from loopback, or carries the token
  /// Where it is false a handler that finds long work to do throws `TakesLong` before it begins.
  bool may_take_long = true;
};

/// Thrown by a handler that may not take long, and would: it is handed the request again, with
/// `may_take_long`, as soon as one of the threads for long work is free. Short answers pass by.
struct TakesLong {};

struct Response {
  int status = 200;
  std::string media_type;
  std::string body;
  std::vector<std::pair<std::string, std::string>> headers;
  /// Seconds that caches may keep it; nothing: no-store.
  std::optional<int> max_age_s;
};

/// Called from several threads at once; what it throws becomes a problem document (problem.h).
using Handler = std::function<Response(const Request&)>;

}  // namespace slackwater::api::http
