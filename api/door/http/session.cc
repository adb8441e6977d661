#include "api/door/http/session.h"

#include <unistd.h>

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <optional>

#include "api/door/http/metrics.h"
#include "api/door/http/request_reader.h"
#include "api/door/http/websocket_session.h"

namespace slackwater::api::http {
namespace {

namespace asio = boost::asio;
using ErrorCode = boost::system::error_code;

/// What a client must take in within `Limits::write_time`.
constexpr std::size_t write_stride_bytes = std::size_t{256} * 1024;
/// Answers so small are not refused for the memory that others hold.
constexpr std::size_t small_answer_bytes = std::size_t{64} * 1024;
constexpr std::chrono::milliseconds linger_time{1000};
/// The same while the server is stopping.
constexpr std::chrono::milliseconds short_linger_time{100};

enum class State { idle, reading, handling, writing, lingering, closed };

class SocketSession final : public Session, public std::enable_shared_from_this<SocketSession> {
 public:
  SocketSession(SessionSite& site, int descriptor, bool peer_is_loopback, bool is_ipv6)
      : site_(site),
        peer_is_loopback_(peer_is_loopback),
        is_ipv6_(is_ipv6),
        reader_(site.limits),
        socket_(site.io, is_ipv6 ? asio::ip::tcp::v6() : asio::ip::tcp::v4(), descriptor) {
    ErrorCode ignored;  // reset in the meantime: the first read tells
    socket_.set_option(asio::ip::tcp::no_delay(true), ignored);
    if (site_.metrics != nullptr) site_.metrics->connection_opened();
  }

  void begin() override {
    // A connection that never says a word is as slow as one that says its request slowly.
    enter(State::idle, site_.limits.read_time);
    read();
  }

  void tick(Moment now) override {
    if (state_ == State::closed || now < deadline_) return;
    if (state_ == State::reading) {
      refuse({408, "The request was not complete " + milliseconds(site_.limits.read_time) +
                       " after it began."});
    } else if (state_ == State::handling) {
      refuse({503, "The answer was not ready " + milliseconds(site_.limits.handler_time) +
                       " after the request; ask for less, or later."});
    } else {
      close();
    }
  }

  std::optional<Moment> waiting_since() const override {
    if (state_ != State::idle && state_ != State::reading) return std::nullopt;
    return since_;
  }

  void refuse_newcomer() override {
    refuse({503, "All " + std::to_string(site_.limits.connections) +
                     " connections of the server are in use; try again in a moment."});
  }

  void drain() override {
    if (state_ == State::idle || state_ == State::reading) close();
    if (state_ == State::lingering) enter(State::lingering, short_linger_time);
  }

  void close() override {
    if (state_ == State::closed) return;
    if (state_ == State::handling || state_ == State::writing) end_request();
    state_ = State::closed;
    ErrorCode ignored;
    socket_.close(ignored);
    let_go_of_answer();
    if (site_.metrics != nullptr) site_.metrics->connection_closed();
    site_.on_closed(*this);
  }

 private:
  static std::string milliseconds(std::chrono::milliseconds time) {
    return std::to_string(time.count()) + " ms";
  }

  void enter(State state, std::chrono::milliseconds time) {
    state_ = state;
    since_ = std::chrono::steady_clock::now();
    deadline_ = since_ + time;
  }

  // --- reading ---

  void read() {
    if (is_read_pending_) return;
    is_read_pending_ = true;
    const std::span<char> room = reader_.room();
    socket_.async_read_some(asio::buffer(room.data(), room.size()),
                            [self = shared_from_this()](const ErrorCode& problem, std::size_t n) {
                              self->on_read(problem, n);
                            });
  }

  void on_read(const ErrorCode& problem, std::size_t n) {
    is_read_pending_ = false;
    if (state_ == State::lingering) return problem ? close() : read();
    // Refused while the read was under way: the answer is being written, then it lingers.
    if (state_ != State::idle && state_ != State::reading) return;
    if (problem == asio::error::eof && state_ == State::reading) {
      return refuse({400, "The connection was closed for writing in the middle of a request."});
    }
    if (problem) return close();
    reader_.received(n);
    feed();
  }

  /// Parses what has come, then reads more or hands the request on.
  void feed() {
    if (state_ == State::idle) enter(State::reading, site_.limits.read_time);
    const RequestReader::Progress progress = reader_.advance();
    if (progress == RequestReader::Progress::refused) return refuse(reader_.refusal());
    if (progress == RequestReader::Progress::complete) return dispatch();
    if (reader_.wants_continue()) send_continue();
    read();
  }

  void send_continue() {
    ErrorCode ignored;  // a client that does not get it sends the body all the same
    socket_.non_blocking(true, ignored);
    socket_.write_some(asio::buffer("HTTP/1.1 100 Continue\r\n\r\n", 25), ignored);
  }

  // --- handling ---

  void dispatch() {
    enter(State::handling, site_.limits.handler_time);
    begin_request_count();
    Arrival arrival = reader_.take();
    arrival.peer_is_loopback = peer_is_loopback_;
    submit(
        site_.short_work,
        [&exchange = site_.exchange, arrival = std::move(arrival)]() mutable {
          return exchange.answer(std::move(arrival));
        },
        ++serial_, deadline_);
  }

  /// What a thread does for a request: to the end, or to where it takes long.
  using Step = std::function<std::variant<Reply, LongReply>()>;

  /// Touches nothing of the session but what never changes: it is called on
  /// the threads of a pool too.
  void submit(WorkerPool& pool, Step step, std::uint64_t serial, Moment deadline) {
    auto job = [self = shared_from_this(), serial, deadline, step = std::move(step)]() mutable {
      SessionSite& site = self->site_;
      std::optional<Reply> reply;
      // Where all threads were busy for too long the client has been told already.
      if (std::chrono::steady_clock::now() < deadline) {
        auto done = step();
        if (auto* rest = std::get_if<LongReply>(&done)) {
          self->submit(site.long_work, std::move(*rest), serial, deadline);
        } else {
          reply = std::get<Reply>(std::move(done));
        }
      }
      // The session goes back with the answer: it is never let go of on this thread.
      asio::post(site.io, [self = std::move(self), serial, reply = std::move(reply)]() mutable {
        const bool is_awaited = self->state_ == State::handling && serial == self->serial_;
        if (reply && is_awaited) self->deliver(std::move(*reply));
      });
    };
    pool.submit(std::move(job));
  }

  void refuse(const Refusal& refusal) {
    if (state_ != State::handling) begin_request_count();
    ++serial_;  // an answer that comes later is not for this connection any more
    write(site_.exchange.refusal(refusal.status, refusal.detail));
  }

  void begin_request_count() {
    begun_ = std::chrono::steady_clock::now();
    if (site_.metrics != nullptr) site_.metrics->request_begun();
  }

  void end_request() {
    if (site_.metrics != nullptr) site_.metrics->request_ended();
  }

  // --- writing ---

  /// Hands the connection on to a WebSocket, where there is room for one.
  void upgrade(Reply reply) {
    if (site_.is_stopping) return refuse({503, "The server is stopping."});
    if (site_.websockets >= site_.limits.websockets) {
      return refuse({503, "All " + std::to_string(site_.limits.websockets) +
                              " WebSockets of the server are in use; try again later."});
    }
    if (reader_.has_bytes()) {
      return refuse({400, "A client waits for the answer to its handshake before it sends more."});
    }
    if (site_.metrics != nullptr) {
      site_.metrics->served({reply.route, reply.method, reply.status,
                             std::chrono::steady_clock::now() - begun_, reply.head.size()});
    }
    const int descriptor = socket_.release();
    std::shared_ptr<Session> successor;
    try {
      successor = open_websocket(site_, descriptor, is_ipv6_, std::move(reply));
    } catch (const std::exception&) {
      ::close(descriptor);  // no memory for it
      return close();
    }
    end_request();
    state_ = State::closed;
    site_.on_succeeded(*this, successor);
    successor->begin();
  }

  /// Writes an answer, or says that the server has too much to send already.
  void deliver(Reply reply) {
    if (reply.successor) return upgrade(std::move(reply));
    const std::size_t bytes = reply.body.size();
    const bool is_too_much = site_.answer_bytes + bytes > site_.limits.answer_bytes;
    if (is_too_much && site_.answer_bytes > 0 && bytes > small_answer_bytes) {
      return refuse({503, "Other clients are taking in " +
                              std::to_string(site_.answer_bytes >> 20U) +
                              " MB of answers; ask for less, or again in a moment."});
    }
    write(std::move(reply));
  }

  void let_go_of_answer() {
    site_.answer_bytes -= reply_.body.size();
    reply_ = {};
  }

  void write(Reply reply) {
    let_go_of_answer();
    reply_ = std::move(reply);
    site_.answer_bytes += reply_.body.size();
    written_ = 0;
    stride_ = 0;
    enter(State::writing, site_.limits.write_time);
    write_more();
  }

  void write_more() {
    const std::size_t in_head = std::min(written_, reply_.head.size());
    const std::array<asio::const_buffer, 2> rest{asio::buffer(reply_.head) + in_head,
                                                 asio::buffer(reply_.body) + (written_ - in_head)};
    socket_.async_write_some(rest,
                             [self = shared_from_this()](const ErrorCode& problem, std::size_t n) {
                               self->on_written(problem, n);
                             });
  }

  void on_written(const ErrorCode& problem, std::size_t n) {
    if (state_ != State::writing) return;
    if (problem) return close();
    written_ += n;
    stride_ += n;
    if (written_ < reply_.head.size() + reply_.body.size()) {
      if (stride_ >= write_stride_bytes) {
        stride_ = 0;
        enter(State::writing, site_.limits.write_time);
      }
      return write_more();
    }
    on_answered();
  }

  void on_answered() {
    if (site_.metrics != nullptr) {
      site_.metrics->served({reply_.route, reply_.method, reply_.status,
                             std::chrono::steady_clock::now() - begun_, written_});
    }
    end_request();
    const bool keep_alive = reply_.keep_alive && !site_.is_stopping;
    let_go_of_answer();
    if (!keep_alive) return linger();
    enter(State::idle, site_.limits.idle_time);
    if (reader_.has_bytes()) return feed();
    read();
  }

  void linger() {
    enter(State::lingering, site_.is_stopping ? short_linger_time : linger_time);
    ErrorCode problem;
    socket_.shutdown(asio::ip::tcp::socket::shutdown_send, problem);
    if (problem) return close();
    read();
  }

  SessionSite& site_;
  const bool peer_is_loopback_;
  const bool is_ipv6_;
  RequestReader reader_;
  asio::ip::tcp::socket socket_;  // last of what may throw: the descriptor is ours from here on
  bool is_read_pending_ = false;
  State state_ = State::idle;
  Moment since_;
  Moment deadline_;
  Moment begun_;              ///< when the request was complete
  std::uint64_t serial_ = 0;  ///< of the request whose answer is awaited
  Reply reply_;
  std::size_t written_ = 0;
  std::size_t stride_ = 0;  ///< written since the deadline was last put off
};

}  // namespace

std::shared_ptr<Session> open_session(SessionSite& site, int descriptor, bool peer_is_loopback,
                                      bool is_ipv6) {
  return std::make_shared<SocketSession>(site, descriptor, peer_is_loopback, is_ipv6);
}

}  // namespace slackwater::api::http
