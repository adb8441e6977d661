#include "api/http/session.h"

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <optional>

#include "api/http/metrics.h"

namespace slackwater::api::http {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using ErrorCode = boost::system::error_code;
using Parser = beast::http::request_parser<beast::http::string_body>;

constexpr std::size_t read_bytes = 16 * 1024;
/// What a client must take in within `Limits::write_time`.
constexpr std::size_t write_stride_bytes = 256 * 1024;
constexpr std::chrono::milliseconds linger_time{1000};
/// The same while the server is stopping.
constexpr std::chrono::milliseconds short_linger_time{100};

std::string text_of(boost::string_view text) { return {text.data(), text.size()}; }

/// All fields of a name, joined as a list (RFC 9110 §5.3).
std::string list_of(const beast::http::fields& fields, beast::http::field name) {
  std::string list;
  const auto range = fields.equal_range(name);
  for (auto field = range.first; field != range.second; ++field) {
    list += (list.empty() ? "" : ", ") + text_of(field->value());
  }
  return list;
}

Arrival arrival_of(Parser& parser, bool peer_is_loopback) {
  using beast::http::field;
  Arrival arrival;
  auto message = parser.release();
  Request& request = arrival.request;
  request.method = text_of(message.method_string());
  const std::string target = text_of(message.target());
  const std::size_t question = target.find('?');
  request.path = target.substr(0, question);
  if (question != std::string::npos) request.query = target.substr(question + 1);
  request.host = text_of(message[field::host]);
  request.accept = list_of(message, field::accept);
  request.body = std::move(message.body());
  arrival.is_http_1_1 = message.version() >= 11;
  arrival.keep_alive = message.keep_alive();
  arrival.peer_is_loopback = peer_is_loopback;
  arrival.is_forwarded = message.count(field::forwarded) + message.count("X-Forwarded-For") > 0;
  arrival.host_fields = message.count(field::host);
  arrival.accept_encoding = list_of(message, field::accept_encoding);
  arrival.if_none_match = list_of(message, field::if_none_match);
  arrival.authorization = text_of(message[field::authorization]);
  arrival.origin = text_of(message[field::origin]);
  return arrival;
}

struct Refusal {
  int status;
  std::string detail;
};

/// What to tell the sender of bytes that are no request.
Refusal refusal_of(const ErrorCode& problem, const Limits& limits) {
  using beast::http::error;
  if (problem == error::header_limit || problem == error::buffer_overflow) {
    return {431, "The header of a request holds at most " + std::to_string(limits.header_bytes) +
                     " bytes."};
  }
  if (problem == error::body_limit) {
    return {413,
            "The body of a request holds at most " + std::to_string(limits.body_bytes) + " bytes."};
  }
  if (problem == error::bad_version) return {505, "This server speaks HTTP/1.1 and HTTP/1.0."};
  return {400, "This is not an HTTP/1.1 request: " + problem.message() + "."};
}

enum class State { idle, reading, handling, writing, lingering, closed };

class SocketSession final : public Session, public std::enable_shared_from_this<SocketSession> {
 public:
  SocketSession(SessionSite& site, int descriptor, bool peer_is_loopback, bool is_ipv6)
      : site_(site),
        socket_(site.io, is_ipv6 ? asio::ip::tcp::v6() : asio::ip::tcp::v4(), descriptor),
        peer_is_loopback_(peer_is_loopback),
        buffer_(2 * read_bytes + site.limits.url_bytes + site.limits.header_bytes) {
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
                     " connections of the server are taken; come back in a moment."});
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
    const std::size_t space = std::min(read_bytes, buffer_.max_size() - buffer_.size());
    socket_.async_read_some(buffer_.prepare(space),
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
    buffer_.commit(n);
    feed();
  }

  /// Parses what is in the buffer, then reads more or hands the request on.
  void feed() {
    if (state_ == State::idle) begin_request();
    for (;;) {
      if (buffer_.size() == 0) return read();
      const bool had_header = parser_->is_header_done();
      ErrorCode problem;
      buffer_.consume(parser_->put(buffer_.data(), problem));
      if (problem == beast::http::error::need_more) return read();
      if (problem) return refuse(refusal_of_bytes(problem));
      if (!had_header && parser_->is_header_done() && !accept_header()) return;
      if (parser_->is_done()) return dispatch();
    }
  }

  void begin_request() {
    enter(State::reading, site_.limits.read_time);
    parser_.emplace();
    parser_->header_limit(
        static_cast<std::uint32_t>(site_.limits.header_bytes + site_.limits.url_bytes));
    parser_->body_limit(site_.limits.body_bytes);
    parser_->eager(true);
  }

  /// A header that is too long because its first line never ends is a URL that is too long.
  [[nodiscard]] Refusal refusal_of_bytes(const ErrorCode& problem) const {
    const auto* text = static_cast<const char*>(buffer_.data().data());
    const boost::string_view begun(text, std::min(buffer_.size(), site_.limits.url_bytes + 64));
    if (problem == beast::http::error::header_limit && parser_->get().target().empty() &&
        begun.find('\n') == boost::string_view::npos) {
      return url_refusal();
    }
    return refusal_of(problem, site_.limits);
  }

  [[nodiscard]] Refusal url_refusal() const {
    return {414, "The target of a request holds at most " + std::to_string(site_.limits.url_bytes) +
                     " bytes."};
  }

  /// Refuses, before the body is read, what is too much. @return whether to go on
  bool accept_header() {
    const auto& header = parser_->get();
    if (header.target().size() > site_.limits.url_bytes) return refuse(url_refusal()), false;
    const auto fields = static_cast<std::size_t>(std::distance(header.begin(), header.end()));
    if (fields > site_.limits.header_fields) {
      refuse({431, "A request has at most " + std::to_string(site_.limits.header_fields) +
                       " header fields; found " + std::to_string(fields) + "."});
      return false;
    }
    if (!parser_->is_done() && beast::iequals(header[beast::http::field::expect], "100-continue")) {
      ErrorCode ignored;  // a client that does not get it sends the body all the same
      socket_.non_blocking(true, ignored);
      socket_.write_some(asio::buffer("HTTP/1.1 100 Continue\r\n\r\n", 25), ignored);
    }
    return true;
  }

  // --- handling ---

  void dispatch() {
    enter(State::handling, site_.limits.handler_time);
    begin_request_count();
    auto job = [self = shared_from_this(), serial = ++serial_, deadline = deadline_,
                arrival = arrival_of(*parser_, peer_is_loopback_)]() mutable {
      SessionSite& site = self->site_;
      std::optional<Reply> reply;
      // Where all threads were busy for too long the client has been told already.
      if (std::chrono::steady_clock::now() < deadline) {
        reply = site.exchange.answer(std::move(arrival));
      }
      // The session goes back with the answer: it is never let go of on this thread.
      asio::post(site.io, [self = std::move(self), serial, reply = std::move(reply)]() mutable {
        const bool is_awaited = self->state_ == State::handling && serial == self->serial_;
        if (reply && is_awaited) self->write(std::move(*reply));
      });
    };
    parser_.reset();
    site_.pool.submit(std::move(job));
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

  void write(Reply reply) {
    reply_ = std::move(reply);
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
    reply_ = {};
    if (!keep_alive) return linger();
    enter(State::idle, site_.limits.idle_time);
    if (buffer_.size() == 0) {
      if (buffer_.capacity() > 4 * read_bytes) buffer_.shrink_to_fit();
      return read();
    }
    feed();
  }

  void linger() {
    enter(State::lingering, site_.is_stopping ? short_linger_time : linger_time);
    ErrorCode problem;
    socket_.shutdown(asio::ip::tcp::socket::shutdown_send, problem);
    if (problem) return close();
    buffer_.clear();
    read();
  }

  SessionSite& site_;
  asio::ip::tcp::socket socket_;
  const bool peer_is_loopback_;
  beast::flat_buffer buffer_;
  std::optional<Parser> parser_;
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
