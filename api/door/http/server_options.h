#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/door/http/message.h"

namespace slackwater::api::http {

class Metrics;

/// What a client may ask of the server before it is refused with a reason, or cut off.
struct Limits {
  std::size_t url_bytes = std::size_t{16} * 1024;     ///< longer: 414
  std::size_t header_fields = 100;                    ///< more: 431
  std::size_t header_bytes = std::size_t{64} * 1024;  ///< all fields together; more: 431
  std::size_t field_bytes = std::size_t{16} * 1024;   ///< one field, name and value; longer: 431
  std::size_t body_bytes = 1 << 20;                   ///< longer: 413
  /// At once, where the system lets a process open so many files; beyond: see `patience`.
  std::size_t connections = 2048;
  /// From the first byte of a request (or the connection) to its last; longer: 408.
  std::chrono::milliseconds read_time{10'000};
  /// From the last byte of a request to its answer; longer: 503, and the answer is thrown away.
  std::chrono::milliseconds handler_time{30'000};
  /// A client must take in a quarter of a megabyte, or the rest, within this time ...
  std::chrono::milliseconds write_time{10'000};
  std::chrono::milliseconds answer_time{600'000};  ///< ... and all of its answer within this one
  /// Of all answers that clients are taking in at once, together. Beyond it the slowest readers are
  /// closed (crowd.h); where that makes no room a large answer is thrown away for a 503.
  std::size_t answer_bytes = std::size_t{256} << 20U;
  /// Silence between two requests of one connection.
  std::chrono::milliseconds idle_time{60'000};
  /// With all connections taken newcomers displace those that have kept us waiting longest, if that
  /// is at least this long, or a tenth of it for who never said a whole request (crowd.h); else a
  /// newcomer is answered 503.
  std::chrono::milliseconds patience{1'000};
  std::size_t websockets = 64;  ///< of the connections, at once; beyond: 503
  std::size_t websocket_message_bytes = std::size_t{64} * 1024;  ///< from a client; longer: 1009
  /// Of frames that wait for one client; beyond, the least worthy are dropped (websocket.h).
  std::size_t websocket_queue_bytes = std::size_t{4} << 20U;
  /// A WebSocket that has been silent so long is pinged, and closed after as long again.
  std::chrono::milliseconds ping_time{20'000};
  /// How long `stop` waits for requests that are being answered.
  std::chrono::milliseconds stop_grace{5'000};
};

struct ServerOptions {
  std::string address = "127.0.0.1";  ///< numeric, IPv4 or IPv6
  std::uint16_t port = 0;             ///< 0: any that is free
  /// That run handlers, and as many more for what takes long (message.h);
  /// one more carries the bytes.
  std::size_t threads = 2;
  std::optional<std::string> token;  ///< `Authorization: Bearer <token>` may write from afar
  bool read_only = false;            ///< POST is refused too, but where `methods_at` names it
  /// Requests whose handler decides by itself who may write, by tokens of its own: `token` is not
  /// asked about them. Empty: none. Called from any thread, must not throw.
  std::function<bool(const Request&)> guards_itself;
  /// The methods of a path, as the Allow field has them (`Router::methods_at`); empty, or where it
  /// says nothing: those that the server knows. Called from any thread, must not throw.
  std::function<std::string(const std::string& path)> methods_at;
  /// Fields of the handlers' own that scripts of other origins may read, beside the usual ones.
  std::vector<std::string> exposed_fields;
  Limits limits;
  std::shared_ptr<Metrics> metrics;  ///< may be null
  /// Told of every exception that the client sees as 500 only; may be empty, called from any
  /// thread, must not throw.
  std::function<void(const Request&, const std::string& what)> on_failure;
};

}  // namespace slackwater::api::http
