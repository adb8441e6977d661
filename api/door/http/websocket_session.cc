#include "api/door/http/websocket_session.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <mutex>
#include <utility>
#include <vector>

#include "api/door/http/frame_reader.h"
#include "api/door/http/metrics.h"
#include "api/door/http/outgoing_frames.h"

namespace slackwater::api::http {
namespace {

namespace asio = boost::asio;
using ErrorCode = boost::system::error_code;

/// What a client must take in within `Limits::write_time`.
constexpr std::size_t frame_stride_bytes = std::size_t{256} * 1024;
/// Frames that go out at once: so many bytes, or one more.
constexpr std::size_t batch_bytes = std::size_t{64} * 1024;
constexpr std::size_t batch_frames = 32;
constexpr int kernel_queue_bytes = 128 * 1024;
/// For the other side's farewell, and then for its end of the connection.
constexpr std::chrono::milliseconds farewell_time{1000};

struct Farewell {
  std::uint16_t code = close_code::normal;
  std::string reason;
};

/// The queue between the threads that have something to say and the one that writes. Knows its
/// connection until that ends.
class Outbox final : public WebSocket {
 public:
  /// @param wake  called where something waits and nobody knows yet; with the lock held
  Outbox(const Limits& limits, Metrics* metrics, std::function<void()> wake)
      : metrics_(metrics), wake_(std::move(wake)), frames_(limits.websocket_queue_bytes) {}

  std::size_t send(Frame frame) override {
    const std::lock_guard lock(mutex_);
    if (!wake_ || farewell_) return 0;
    const auto pushed = frames_.push(std::move(frame));
    if (pushed.is_overrun) {
      frames_.clear();
      farewell_ = Farewell{close_code::policy_violation, "the client did not read what was sent"};
    }
    if (pushed.dropped > 0 && metrics_ != nullptr) metrics_->frames_dropped(pushed.dropped);
    wake();
    return pushed.dropped;
  }

  void close(std::uint16_t code, std::string reason) override {
    const std::lock_guard lock(mutex_);
    if (!wake_ || farewell_) return;
    farewell_ = Farewell{code, std::move(reason)};
    wake();
  }

  /// What is to be written next; nothing: the next to say something wakes the writer.
  std::vector<Frame> take() {
    const std::lock_guard lock(mutex_);
    std::vector<Frame> batch;
    std::size_t bytes = 0;
    while (batch.size() < batch_frames && bytes < batch_bytes) {
      auto frame = frames_.pop();
      if (!frame) break;
      bytes += frame->size();
      batch.push_back(std::move(*frame));
    }
    is_awake_ = !batch.empty();
    return batch;
  }

  /// Once all frames have gone.
  std::optional<Farewell> farewell() {
    const std::lock_guard lock(mutex_);
    return frames_.empty() ? farewell_ : std::nullopt;
  }

  /// The connection has ended, or writes no frames any more.
  void end() {
    const std::lock_guard lock(mutex_);
    frames_.clear();
    wake_ = {};
  }

 private:
  void wake() {
    if (!std::exchange(is_awake_, true)) wake_();
  }

  std::mutex mutex_;
  Metrics* const metrics_;
  std::function<void()> wake_;  ///< empty at the end
  bool is_awake_ = false;       ///< the writer will ask
  OutgoingFrames frames_;
  std::optional<Farewell> farewell_;
};

enum class SocketState { open, closing, closed };

class WebSocketSession final : public Session,
                               public std::enable_shared_from_this<WebSocketSession> {
 public:
  WebSocketSession(SessionSite& site, int descriptor, Peer peer, Reply reply)
      : site_(site),
        peer_(std::move(peer)),
        handler_(std::move(reply.successor->handler)),
        request_(std::move(reply.successor->request)),
        protocol_(std::move(reply.successor->protocol)),
        reader_(site.limits.websocket_message_bytes),
        control_(std::move(reply.head)),
        socket_(site.io, peer_.is_ipv6 ? asio::ip::tcp::v6() : asio::ip::tcp::v4(), descriptor) {}

  void begin() override {
    ++site_.websockets;
    // Where a client is slow the queue that knows what to drop is to fill, not the kernel's.
    const int unsent_bytes = kernel_queue_bytes;  // unknown to the system: no harm
    ::setsockopt(socket_.native_handle(), IPPROTO_TCP, TCP_NOTSENT_LOWAT, &unsent_bytes,
                 sizeof unsent_bytes);
    if (site_.metrics != nullptr) site_.metrics->websocket_opened();
    heard();
    outbox_ = std::make_shared<Outbox>(site_.limits, site_.metrics,
                                       [weak = weak_from_this(), &io = site_.io] {
                                         asio::post(io, [weak] {
                                           if (const auto self = weak.lock()) self->write();
                                         });
                                       });
    is_opened_ = true;
    call([this] { handler_->opened(outbox_, request_, protocol_); });
    read();
    write();
  }

  void tick(Moment now) override {
    if (state_ == SocketState::closed) return;
    const auto silence = now - heard_;
    if ((state_ == SocketState::closing && now > deadline_) ||
        (is_writing_ && now > write_deadline_) || silence > 2 * site_.limits.ping_time) {
      close();
    } else if (state_ == SocketState::open && silence > site_.limits.ping_time && !is_pinged_) {
      is_pinged_ = true;
      control_ += control_frame(Opcode::ping, {});
      write();
    }
  }

  std::optional<Standing> standing(Moment /*now*/) const override { return std::nullopt; }
  const std::string& client() const override { return peer_.address; }
  void refuse_newcomer() override { close(); }
  void drain() override { bid_farewell({close_code::going_away, "the server is stopping"}); }

  void close() override {
    if (std::exchange(state_, SocketState::closed) == SocketState::closed) return;
    ErrorCode ignored;
    socket_.close(ignored);
    if (outbox_) outbox_->end();
    if (is_opened_) {
      call([this] { handler_->closed(*outbox_); });
      --site_.websockets;
      if (site_.metrics != nullptr) site_.metrics->websocket_closed();
    }
    if (site_.metrics != nullptr) site_.metrics->connection_closed();
    site_.on_closed(*this);
  }

 private:
  /// Calls the handler; what it throws ends the socket.
  template <typename Call>
  void call(const Call& call) {
    std::string what;
    try {
      return call();
    } catch (const std::exception& failure) {
      what = failure.what();
    } catch (...) {
      what = "an exception that is no std::exception";
    }
    site_.exchange.log_failure(request_, what);
    bid_farewell({close_code::internal_error, "the server failed on this; its log says why"});
  }

  void heard() {
    heard_ = std::chrono::steady_clock::now();
    is_pinged_ = false;
  }

  // --- reading ---

  void read() {
    if (state_ == SocketState::closed) return;
    const std::span<char> room = reader_.room();
    socket_.async_read_some(asio::buffer(room.data(), room.size()),
                            [self = shared_from_this()](const ErrorCode& problem, std::size_t n) {
                              self->on_read(problem, n);
                            });
  }

  void on_read(const ErrorCode& problem, std::size_t n) {
    if (state_ == SocketState::closed) return;
    if (problem) return close();
    if (!is_deaf_) {
      reader_.received(n);
      while (state_ != SocketState::closed && !is_deaf_) {
        auto incoming = reader_.next();
        if (!incoming) break;
        heard();
        take(*incoming);
      }
    }
    read();
  }

  void take(Incoming& incoming) {
    using Kind = Incoming::Kind;
    if (incoming.kind == Kind::close || incoming.kind == Kind::failed) {
      is_deaf_ = true;
      bid_farewell({incoming.code, incoming.kind == Kind::failed ? incoming.bytes : ""});
      return end_if_done();
    }
    if (state_ != SocketState::open) return;
    if (incoming.kind == Kind::ping) {
      pong_ = control_frame(Opcode::pong, incoming.bytes);  // the latest will do (§5.5.3)
      return write();
    }
    if (incoming.kind == Kind::text) {
      call([&] { handler_->received_text(*outbox_, incoming.bytes); });
    } else if (incoming.kind == Kind::binary) {
      const auto* bytes = reinterpret_cast<const std::uint8_t*>(incoming.bytes.data());
      call([&] { handler_->received_bytes(*outbox_, {bytes, incoming.bytes.size()}); });
    }
  }

  // --- writing ---

  /// Writes what waits, unless it is writing.
  void write() {
    if (state_ == SocketState::closed || is_writing_) return;
    control_ += std::exchange(pong_, {});
    if (state_ == SocketState::open) {
      batch_ = outbox_->take();
      const auto farewell = batch_.empty() ? outbox_->farewell() : std::nullopt;
      if (farewell) say_last(*farewell);
    }
    written_control_ = std::exchange(control_, {});
    if (written_control_.empty() && batch_.empty()) return;
    start_writing();
  }

  void start_writing() {
    heads_.clear();
    heads_.reserve(batch_.size());  // they are pointed to
    std::vector<asio::const_buffer> buffers{asio::buffer(written_control_)};
    std::size_t bytes = written_control_.size();
    for (const Frame& frame : batch_) {
      heads_.push_back(frame_head(frame.is_text ? Opcode::text : Opcode::binary, frame.size()));
      buffers.push_back(asio::buffer(heads_.back()));
      buffers.push_back(asio::buffer(frame.head));
      if (frame.body != nullptr) buffers.push_back(asio::buffer(*frame.body));
      bytes += frame.size();
    }
    is_writing_ = true;
    const auto strides = static_cast<int>(1 + bytes / frame_stride_bytes);
    write_deadline_ = std::chrono::steady_clock::now() + strides * site_.limits.write_time;
    asio::async_write(socket_, buffers,
                      [self = shared_from_this()](const ErrorCode& problem, std::size_t) {
                        self->on_written(problem);
                      });
  }

  void on_written(const ErrorCode& problem) {
    is_writing_ = false;
    if (state_ == SocketState::closed) return;
    if (problem) return close();
    if (site_.metrics != nullptr) site_.metrics->frames_sent(batch_.size());
    batch_.clear();  // what others share is let go of
    write();
    end_if_done();
  }

  // --- the end ---

  /// The farewell is the last that is written; messages that come are not heard any more.
  void say_last(const Farewell& farewell) {
    state_ = SocketState::closing;
    deadline_ = std::chrono::steady_clock::now() + farewell_time;
    pong_.clear();
    control_ += close_frame(farewell.code, farewell.reason);
    outbox_->end();
  }

  /// Says so at once, whatever else waits.
  void bid_farewell(const Farewell& farewell) {
    if (state_ != SocketState::open) return;
    say_last(farewell);
    write();
  }

  /// Both have said farewell: the server ends the connection first (§7.1.1), and reads on until the
  /// client does so too, lest the kernel take the farewell back.
  void end_if_done() {
    if (state_ != SocketState::closing || !is_deaf_ || is_writing_ || is_shut_) return;
    is_shut_ = true;
    ErrorCode problem;
    socket_.shutdown(asio::ip::tcp::socket::shutdown_send, problem);
    if (problem) close();
  }

  SessionSite& site_;
  const Peer peer_;
  const std::shared_ptr<WebSocketHandler> handler_;
  const Request request_;
  const std::string protocol_;
  std::shared_ptr<Outbox> outbox_;
  bool is_opened_ = false;
  FrameReader reader_;
  bool is_deaf_ = false;  ///< what still comes is thrown away
  Moment heard_;          ///< when the last whole frame came
  bool is_pinged_ = false;
  std::string control_;          ///< to be written before any message
  std::string pong_;             ///< ... and this after it
  std::string written_control_;  ///< being written, and then these
  std::vector<Frame> batch_;
  std::vector<std::string> heads_;
  bool is_writing_ = false;
  Moment write_deadline_;
  SocketState state_ = SocketState::open;
  Moment deadline_;  ///< of `closing`
  bool is_shut_ = false;
  asio::ip::tcp::socket socket_;  // last of what may throw: the descriptor is ours from here on
};

}  // namespace

std::shared_ptr<Session> open_websocket(SessionSite& site, int descriptor, Peer peer, Reply reply) {
  return std::make_shared<WebSocketSession>(site, descriptor, std::move(peer), std::move(reply));
}

}  // namespace slackwater::api::http
