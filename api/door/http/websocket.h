#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "api/door/http/message.h"

// WebSockets (RFC 6455) as our handlers see them, whatever carries them.
//
//   router.add("GET", "/live", websocket_route(handler));
//
// A request for an upgrade at that path becomes a socket in the first of the client's sub-protocols
// that the handler knows; other requests are told what the path is for.

namespace slackwater::api::http {

/// What goes first where a client is slow and its queue full.
enum class Worth {
  best_effort,  ///< the oldest of these
  reliable,     ///< then the oldest of these
  essential     ///< never: without it the rest makes no sense
};

/// A message to one client: `head`, then `body`, which several clients may share.
struct Frame {
  bool is_text = false;  ///< UTF-8
  std::string head;
  std::shared_ptr<const std::vector<std::uint8_t>> body;  ///< may be null
  Worth worth = Worth::reliable;

  [[nodiscard]] std::size_t size() const noexcept {
    return head.size() + (body == nullptr ? 0 : body->size());
  }
};

/// One client, to be written to from any thread. Outlives its connection and its server: what is
/// said to a client that has gone is forgotten.
class WebSocket {
 public:
  virtual ~WebSocket() = default;
  /// Queues the frame and returns at once (`Limits::websocket_queue_bytes`).
  /// @return how many frames, this one perhaps among them, were dropped to keep the queue bounded
  virtual std::size_t send(Frame frame) = 0;
  /// Sends what waits, then says farewell.
  /// @param code    1000 to 4999, RFC 6455 §7.4
  /// @param reason  for people, UTF-8, at most 123 bytes (the rest is cut off)
  virtual void close(std::uint16_t code, std::string reason) = 0;
};

/// What a path does with its clients. Called on the server's one thread of sockets, for one client
/// after the other: be quick and wait for nothing. What it throws ends the socket with 1011 and is
/// told to `ServerOptions::on_failure`.
class WebSocketHandler {
 public:
  virtual ~WebSocketHandler() = default;
  /// The sub-protocols it speaks; none: whatever the client names, no protocol is agreed on.
  /// Called from any thread.
  [[nodiscard]] virtual std::vector<std::string> protocols() const = 0;
  /// What a client is told instead of being let in; nothing: it may. Called from any thread, before
  /// the upgrade.
  [[nodiscard]] virtual std::optional<Response> refusal(const Request&) const { return {}; }
  /// @param request   the one that asked for the upgrade; a page of any origin may ask, and what
  ///                  writes looks at `is_trusted`, as everywhere
  /// @param protocol  agreed on; "" where `protocols` has none
  virtual void opened(const std::shared_ptr<WebSocket>& socket, const Request& request,
                      const std::string& protocol) = 0;
  virtual void received_text(WebSocket& socket, std::string_view text) = 0;
  virtual void received_bytes(WebSocket& socket, std::span<const std::uint8_t> bytes) = 0;
  /// The last call for a socket that was opened, whoever ended it.
  virtual void closed(WebSocket& socket) = 0;
};

/// For a router: an upgrade becomes a socket of the handler, any other request is a 426.
[[nodiscard]] Handler websocket_route(std::shared_ptr<WebSocketHandler> handler);

}  // namespace slackwater::api::http
