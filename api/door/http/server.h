#pragma once
#include <cstdint>
#include <memory>

#include "api/door/http/message.h"
#include "api/door/http/server_options.h"

namespace slackwater::api::http {

/// An HTTP/1.1 server for handlers that are plain functions.
///
///   one thread    accepts, reads, keeps the deadlines, writes          (session.h)
///   n threads     method, trust, handler, validators, coding           (exchange.h)
///   n threads     the same for answers that take long, so that short ones pass them by
///
/// Sockets live on the one thread alone and handlers see values only: nothing is shared but
/// three queues. A handler that hangs costs its thread and nobody's bytes.
class Server {
 public:
  /// Throws Error(usage) for an address that is not numeric, and for one that is not loopback
  /// while there is neither a token nor `read_only`.
  Server(ServerOptions options, Handler handler);
  ~Server();  ///< stops
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Whether other machines may reach it: its address is not loopback.
  [[nodiscard]] bool lets_others_in() const;
  /// Listens when it returns. Throws Error(unavailable) where the port is taken.
  void start();
  /// The port listened on; 0 unless started.
  [[nodiscard]] std::uint16_t port() const noexcept;
  /// Accepts no more, lets requests in progress finish within `Limits::stop_grace`, waits for the
  /// handlers that still run, closes. May be started again.
  void stop();

 private:
  class Running;
  ServerOptions options_;
  Handler handler_;
  std::unique_ptr<Running> running_;
};

}  // namespace slackwater::api::http
