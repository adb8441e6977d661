#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "api/door/http/message.h"
#include "api/door/http/server_options.h"
#include "api/door/http/websocket.h"

namespace slackwater::api::http {

/// The fields of a request that wants to go on as a WebSocket (RFC 6455 §4.1).
struct UpgradeFields {
  bool is_to_websocket = false;  ///< `Upgrade: websocket`, and `Connection` says so too
  std::string version;
  std::string key;
};

/// A request as it came in, with what only the server needs to know of it.
struct Arrival {
  Request request;  ///< `is_trusted` is not yet decided
  bool is_http_1_1 = true;
  bool keep_alive = true;
  bool peer_is_loopback = false;
  bool is_forwarded = false;  ///< a proxy passed it on: the peer is not the sender
  std::size_t host_fields = 1;
  std::string accept_encoding;
  std::string if_none_match;
  UpgradeFields upgrade;
};

/// Who takes a connection over once the head of its answer, a 101, is written.
struct Successor {
  std::shared_ptr<WebSocketHandler> handler;
  Request request;
  std::string protocol;
};

/// An answer as it goes out.
struct Reply {
  int status = 200;
  std::string head;  ///< status line and fields, with the empty line
  std::string body;  ///< empty after HEAD and with 304
  bool keep_alive = true;
  std::string method;  ///< of the request, for the metrics
  std::string route;   ///< ... and the label of its route
  std::optional<Successor> successor{};
};

/// What is left to do for an answer that takes long; called once, never throws.
using LongReply = std::function<Reply()>;

/// What happens between a parsed request and the bytes of its answer: which methods are served, who
/// may write, the handler, HEAD and OPTIONS, validators, content coding, the fields every answer
/// carries. Knows nothing of sockets; thread-safe where the handler is.
class Exchange {
 public:
  Exchange(const ServerOptions& options, const Handler& handler);

  /// The answer, or the work that leads to it where that takes long. Never throws for what a
  /// request or a handler does.
  [[nodiscard]] std::variant<Reply, LongReply> answer(Arrival arrival) const;
  /// The last answer on a connection whose request could not be read.
  [[nodiscard]] Reply refusal(int status, const std::string& detail) const;
  /// Tells the log what went wrong with a request, or with the WebSocket that it became.
  void log_failure(const Request& request, const std::string& what) const;

 private:
  [[nodiscard]] Outcome respond(Arrival& arrival) const;
  [[nodiscard]] Reply reply_to(const Arrival& arrival, Response response) const;
  [[nodiscard]] Reply finish(Response response, const Arrival& arrival) const;
  [[nodiscard]] Reply reply_to_upgrade(const Arrival& arrival, const Response& response) const;
  [[nodiscard]] bool may_be_written_to(const Request& request) const;
  [[nodiscard]] std::string allowed_methods(const Request& request) const;
  [[nodiscard]] Response options_response(const Request& request) const;
  void log(const Response& response, const Request& request) const;

  const ServerOptions& options_;
  const Handler& handler_;
  std::string exposed_fields_;  ///< for CORS
};

}  // namespace slackwater::api::http
