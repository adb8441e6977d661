#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// A request and its response as our handlers see them, whatever library carries them.

namespace slackwater::api::http {

class WebSocketHandler;

struct Request {
  std::string method;         ///< "GET", upper case
  std::string path;           ///< as sent, percent-encoded, without the query
  std::string query;          ///< as sent, without the '?'
  std::string host;           ///< Host header, "" where absent
  std::string accept;         ///< Accept header
  std::string content_type;   ///< Content-Type header: of the body
  std::string authorization;  ///< Authorization header
  std::string origin;         ///< Origin header: of the page that sent it; "" of what is no page
  std::string protocols;      ///< Sec-WebSocket-Protocol: those that are offered, as sent
  std::string body;
  bool is_trusted = false;  ///< from loopback, or carries the token
  std::stop_token stop{};   ///< asked for where nobody waits any more: long work may ask
};

struct Response {
  int status = 200;
  std::string media_type;
  std::string body;
  std::vector<std::pair<std::string, std::string>> headers;
  /// Seconds that caches may keep it; nothing: no-store.
  std::optional<int> max_age_s;

  // For the server alone, never sent.
  std::string route{};        ///< label of the route that answered, for the metrics
  std::string for_the_log{};  ///< what went wrong that the client is not told; mostly ""
  /// Where a request asks for an upgrade, this takes the connection instead of the response
  /// (websocket.h); mostly null.
  std::shared_ptr<WebSocketHandler> websocket{};
};

/// Work that would keep short answers waiting: what is left of it, to be run once. It holds the
/// request, and as little else as it can while it waits.
struct LongWork {
  std::function<Response()> run;
};

/// What a handler makes of a request: the response, or, where that would take long, the work that
/// leads to it. The server runs it when one of the threads for long work is free.
using Outcome = std::variant<Response, LongWork>;

/// Called from several threads at once; what it throws becomes a problem document (problem.h).
using Handler = std::function<Outcome(const Request&)>;

/// The response, worked out here and now.
[[nodiscard]] inline Response completed(Outcome outcome) {
  if (const auto* work = std::get_if<LongWork>(&outcome)) return work->run();
  return std::get<Response>(std::move(outcome));
}

}  // namespace slackwater::api::http
