#pragma once
#include <string>
#include <variant>

#include "api/door/http/exchange.h"
#include "api/door/http/websocket.h"

namespace slackwater::api::http {

/// What the client and the handler have agreed on.
struct Agreement {
  std::string protocol;  ///< "" where the handler has none
  std::string head;      ///< of the 101 that says so, with the empty line
};

/// The server's side of the opening handshake (RFC 6455 §4.2): the agreement, or the problem that
/// the client is told instead. Versions other than 13 are a 426, all else that is wrong a 400.
[[nodiscard]] std::variant<Agreement, Response> agree(const Arrival& arrival,
                                                      const WebSocketHandler& handler);

}  // namespace slackwater::api::http
