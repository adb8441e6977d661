#include "api/door/http/websocket_handshake.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "api/door/http/field_list.h"
#include "api/door/http/problem.h"
#include "api/door/http/response_head.h"
#include "fields/base/encode/sha1.h"
#include "fields/base/text.h"

namespace slackwater::api::http {
namespace {

constexpr std::string_view key_suffix = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";  // RFC 6455 §1.3
constexpr std::size_t longest_named = 200;  ///< of what a client sent, in a text for it

/// 16 bytes in base64.
bool is_key(std::string_view key) {
  return key.size() == 24 && key.ends_with("==") &&
         std::all_of(key.begin(), key.end() - 2,
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '+' || c == '/'; });
}

/// The first of the client's list that is known.
std::optional<std::string> first_known(const std::string& offered,
                                       const std::vector<std::string>& known) {
  std::optional<std::string> chosen;
  for_each_item(offered, [&](std::string_view name) {
    if (!chosen && std::find(known.begin(), known.end(), name) != known.end()) {
      chosen = std::string(name);
    }
  });
  return chosen;
}

Response upgrade_required(const std::string& detail, const std::string& instance) {
  Response response = problem(426, detail, instance);
  response.headers.emplace_back("Upgrade", "websocket");
  response.headers.emplace_back("Connection", "Upgrade");
  response.headers.emplace_back("Sec-WebSocket-Version", "13");
  return response;
}

std::string switching_head(const std::string& key, const std::string& protocol) {
  std::string head = "HTTP/1.1 101 " + std::string(reason_of(101)) + "\r\n";
  head += "Date: " + http_date(std::time(nullptr)) + "\r\nServer: slackwater\r\n";
  head += "Upgrade: websocket\r\nConnection: Upgrade\r\n";
  head += "Sec-WebSocket-Accept: " + sha1_base64(key + std::string(key_suffix)) + "\r\n";
  if (!protocol.empty()) head += "Sec-WebSocket-Protocol: " + protocol + "\r\n";
  return head + "\r\n";
}

}  // namespace

std::variant<Agreement, Response> agree(const Arrival& arrival, const WebSocketHandler& handler) {
  const UpgradeFields& upgrade = arrival.upgrade;
  const std::string& path = arrival.request.path;
  if (upgrade.version != "13") {
    return upgrade_required("Sec-WebSocket-Version: found '" +
                                upgrade.version.substr(0, longest_named) +
                                "'; this server speaks 13 (RFC 6455).",
                            path);
  }
  if (!is_key(upgrade.key)) {
    return problem(400,
                   "Sec-WebSocket-Key: expected one field with 16 bytes in base64, as a WebSocket "
                   "client makes them.",
                   path);
  }
  if (!arrival.request.body.empty()) {
    return problem(400, "A request for a WebSocket has no body.", path);
  }
  if (auto refused = handler.refusal(arrival.request)) return *std::move(refused);
  const std::vector<std::string> known = handler.protocols();
  const auto protocol =
      known.empty() ? std::string() : first_known(arrival.request.protocols, known);
  if (!protocol) {
    return problem(400,
                   "Sec-WebSocket-Protocol: found '" +
                       arrival.request.protocols.substr(0, longest_named) +
                       "'; at this path one of these is spoken: " + joined(known, ", ") + ".",
                   path);
  }
  return Agreement{*protocol, switching_head(upgrade.key, *protocol)};
}

Handler websocket_route(std::shared_ptr<WebSocketHandler> handler) {
  return [handler = std::move(handler)](const Request& request) {
    const std::vector<std::string> known = handler->protocols();
    Response response = upgrade_required(
        "This path speaks WebSocket" +
            (known.empty() ? "" : ", sub-protocol " + joined(known, " or ")) +
            ": connect to ws://" + request.host + request.path + " with a client of that.",
        request.path);
    response.websocket = handler;
    return response;
  };
}

}  // namespace slackwater::api::http
