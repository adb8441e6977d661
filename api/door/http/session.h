#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "api/door/http/crowd.h"
#include "api/door/http/exchange.h"
#include "api/door/http/server_options.h"
#include "api/door/http/worker_pool.h"

namespace boost::asio {
class io_context;
}

namespace slackwater::api::http {

using Moment = std::chrono::steady_clock::time_point;

class Session;

/// Who is at the other end of a connection.
struct Peer {
  std::string address;  ///< its bytes
  bool is_loopback = false;
  bool is_ipv6 = false;
};

/// Where sessions live: what they share. Outlives them.
struct SessionSite {
  boost::asio::io_context& io;
  const Exchange& exchange;
  WorkerPool& short_work;  ///< all begin here
  WorkerPool& long_work;   ///< `LongWork` goes on here (message.h)
  const Limits& limits;
  Metrics* metrics;                         ///< may be null
  std::function<void(Session&)> on_closed;  ///< called once, with the session still alive
  /// Another session has taken a connection over; called instead of `on_closed`.
  std::function<void(Session&, std::shared_ptr<Session> successor)> on_succeeded;
  /// Closes sessions that hold answers, where one of so many bytes for `client` is worth more.
  std::function<void(const std::string& client, std::size_t bytes)> make_room;
  std::size_t websockets = 0;    ///< open
  std::size_t answer_bytes = 0;  ///< of bodies that clients are taking in
  bool is_stopping = false;      ///< answers close their connection from now on
};

/// One connection, in one of these states:
///
///   idle -> reading -> handling -> writing -> idle ...          keep-alive, pipelined or not
///                 \________________/  \-> lingering -> closed   the last answer of a connection
///
/// or handed on to another session, where the answer is an upgrade (websocket_session.h).
/// Every state has a deadline, kept by `tick`. All members are called on the site's one thread.
/// Lingering (RFC 9112 §9.6): after the last answer what the client still sends is read and thrown
/// away for a moment, else the kernel resets the connection and the client loses the answer.
class Session {
 public:
  virtual ~Session() = default;
  /// Starts reading.
  virtual void begin() = 0;
  /// Acts on a deadline that has passed: 408, 503 or the end of the connection.
  virtual void tick(Moment now) = 0;
  /// How it waits for its client; nothing while it has work in hand for one that may say more.
  [[nodiscard]] virtual std::optional<Standing> standing(Moment now) const = 0;
  /// Of the answer that its client takes in; 0: none.
  [[nodiscard]] virtual std::size_t answer_bytes() const { return 0; }
  /// The address of its client, whatever the port.
  [[nodiscard]] virtual const std::string& client() const = 0;
  /// Answers 503 instead of reading.
  virtual void refuse_newcomer() = 0;
  /// Closes what waits; what is being answered may finish.
  virtual void drain() = 0;
  virtual void close() = 0;
};

/// Takes over a connected, non-blocking socket; where it throws, it does not. Call `begin`
/// or `refuse_newcomer` next.
[[nodiscard]] std::shared_ptr<Session> open_session(SessionSite& site, int descriptor, Peer peer);

}  // namespace slackwater::api::http
