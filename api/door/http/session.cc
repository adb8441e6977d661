#include "api/door/http/session.h"

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <cerrno>
#include <optional>
#include <stop_token>

#include "api/door/http/metrics.h"
#include "api/door/http/request_reader.h"
#include "api/door/http/websocket_session.h"

namespace slackwater::api::http {
namespace {

namespace asio = boost::asio;
using ErrorCode = boost::system::error_code;

/// What a client must take in within `Limits::write_time`; who takes longer than the second for it
/// goes first where there is no room.
constexpr std::size_t write_stride_bytes = std::size_t{256} * 1024;
constexpr std::chrono::milliseconds time_for_a_stride{2000};
/// Answers so small are not refused for the memory that others hold.
constexpr std::size_t small_answer_bytes = std::size_t{64} * 1024;
constexpr std::chrono::milliseconds linger_time{1000};
/// The same while the server is stopping.
constexpr std::chrono::milliseconds short_linger_time{100};

enum class State { idle, reading, handling, writing, lingering, closed };

class SocketSession final : public Session, public std::enable_shared_from_this<SocketSession> {
 public:
  SocketSession(SessionSite& site, int descriptor, Peer peer)
      : site_(site),
        peer_(std::move(peer)),
        descriptor_(descriptor),
        reader_(site.limits),
        socket_(site.io, peer_.is_ipv6 ? asio::ip::tcp::v6() : asio::ip::tcp::v4(), descriptor) {
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
    const bool is_endless =
        state_ == State::writing && now > answer_begun_ + site_.limits.answer_time;
    if (state_ == State::closed || (now < deadline_ && !is_endless)) return;
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

  std::optional<Standing> standing(Moment now) const override {
    if (state_ == State::writing) {
      if (now - since_ < time_for_a_stride) return std::nullopt;
      return Standing{Wait::reads_slowly, since_};
    }
    if (state_ == State::handling && has_said_all()) return Standing{Wait::has_said_all, since_};
    if (state_ != State::idle && state_ != State::reading) return std::nullopt;
    // Half a request is half a request, however many were answered before it.
    const bool is_proven = answered_ > 0 && state_ == State::idle;
    return Standing{is_proven ? Wait::at_rest : Wait::says_nothing, since_};
  }

  std::size_t answer_bytes() const override { return reply_.body.size(); }

  const std::string& client() const override { return peer_.address; }

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
    stop_.request_stop();
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
    // A crowd resets faster than its requests are read: nothing is begun for who is gone already.
    if (is_reset()) return close();
    enter(State::handling, site_.limits.handler_time);
    begin_request_count();
    Arrival arrival = reader_.take();
    arrival.peer_is_loopback = peer_.is_loopback;
    stop_ = {};
    arrival.request.stop = stop_.get_token();
    watch_for_reset();
    submit(site_.short_work,
           [&exchange = site_.exchange, arrival = std::move(arrival)]() mutable {
             return exchange.answer(std::move(arrival));
           },
           {++serial_, deadline_, stop_.get_token()});
  }

  /// A client that resets the connection waits for nothing any more: its work is not begun, or ends
  /// where it is asked about (`Request::stop`). One that only has no more to say waits.
  void watch_for_reset() {
    if (is_watched_) return;
    is_watched_ = true;
    socket_.async_wait(
        asio::ip::tcp::socket::wait_error, [self = shared_from_this()](const ErrorCode& problem) {
          self->is_watched_ = false;
          if (problem) return;
          const bool is_at_work = self->state_ == State::handling || self->state_ == State::writing;
          if (is_at_work && self->is_reset()) self->close();
        });
  }

  /// A client that has closed its side looks like one that is gone: TCP tells no difference until
  /// it is answered.
  bool has_said_all() const {
    char byte = 0;
    return ::recv(descriptor_, &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
  }

  bool is_reset() const {
    char byte = 0;
    return ::recv(descriptor_, &byte, 1, MSG_PEEK | MSG_DONTWAIT) < 0 && errno != EAGAIN &&
           errno != EWOULDBLOCK && errno != EINTR;
  }

  /// A request as the threads of the pools know it.
  struct Asked {
    std::uint64_t serial = 0;
    Moment deadline;
    std::stop_token stop;
  };

  /// What a thread does for a request: to the end, or to where it takes long.
  using Step = std::function<std::variant<Reply, LongReply>()>;

  /// Touches nothing of the session but what never changes: it is called on
  /// the threads of a pool too.
  void submit(WorkerPool& pool, Step step, Asked asked) {
    auto job = [self = shared_from_this(), asked = std::move(asked),
                step = std::move(step)]() mutable {
      SessionSite& site = self->site_;
      std::optional<Reply> reply;
      // Where all threads were busy for too long the client has been told already, or is gone.
      if (std::chrono::steady_clock::now() < asked.deadline && !asked.stop.stop_requested()) {
        auto done = step();
        if (auto* rest = std::get_if<LongReply>(&done)) {
          self->submit(site.long_work, std::move(*rest), asked);
        } else {
          reply = std::get<Reply>(std::move(done));
        }
      }
      // The session goes back with the answer: it is never let go of on this thread.
      asio::post(site.io, [self = std::move(self), serial = asked.serial,
                           reply = std::move(reply)]() mutable {
        const bool is_awaited = self->state_ == State::handling && serial == self->serial_;
        if (reply && is_awaited) self->deliver(std::move(*reply));
      });
    };
    pool.submit(peer_.address, std::move(job));
  }

  void refuse(const Refusal& refusal) {
    if (state_ != State::handling) begin_request_count();
    ++serial_;  // an answer that comes later is not for this connection any more
    stop_.request_stop();
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
      successor = open_websocket(site_, descriptor, peer_, std::move(reply));
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
    const auto is_too_much = [&] {
      return site_.answer_bytes > 0 && site_.answer_bytes + bytes > site_.limits.answer_bytes;
    };
    if (is_too_much()) site_.make_room(peer_.address, bytes);
    if (is_too_much() && bytes > small_answer_bytes) {
      return refuse({503, "Found " + std::to_string(site_.answer_bytes >> 20U) +
                              " MB of answers on their way to clients, expected room for this one "
                              "in the client's share of " +
                              std::to_string(site_.limits.answer_bytes >> 20U) +
                              " MB; take in those that you asked for, ask for less, or again in a "
                              "moment."});
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
    answer_begun_ = since_;
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
    ++answered_;
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
  const Peer peer_;
  const int descriptor_;  ///< of `socket_`
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
  Moment answer_begun_;
  std::size_t answered_ = 0;  ///< requests
  std::stop_source stop_;     ///< of the work for the request in hand
  bool is_watched_ = false;   ///< for a reset
};

}  // namespace

std::shared_ptr<Session> open_session(SessionSite& site, int descriptor, Peer peer) {
  return std::make_shared<SocketSession>(site, descriptor, std::move(peer));
}

}  // namespace slackwater::api::http
