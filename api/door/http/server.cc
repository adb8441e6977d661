#include "api/door/http/server.h"

#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cerrno>
#include <new>
#include <thread>
#include <unordered_map>
#include <vector>

#include "api/door/http/client_address.h"
#include "api/door/http/metrics.h"
#include "api/door/http/session.h"
#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::api::http {
namespace {

namespace asio = boost::asio;
using ErrorCode = boost::system::error_code;

/// Connections taken from the queue before others are looked after again.
constexpr int accepts_at_once = 64;
/// Newcomers that are being told to come back, beyond `Limits::connections`; more are just closed.
constexpr std::size_t refusals_at_once = 64;

asio::ip::address address_of(const ServerOptions& options) {
  ErrorCode problem;
  auto address = asio::ip::make_address(options.address, problem);
  if (problem) {
    throw Error(ErrorKind::usage, "the address to listen on is '" + options.address +
                                      "'; a numeric one is expected, e.g. 127.0.0.1 or ::1");
  }
  return address;
}

/// With no more connections than the system lets us open files, but for those that everything else
/// needs.
Limits within_system(Limits limits) {
  constexpr rlim_t for_all_else = 128;
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) != 0) return limits;
  const rlim_t wanted = std::min<rlim_t>(limits.connections + for_all_else, files.rlim_max);
  if (files.rlim_cur < wanted) {
    files.rlim_cur = wanted;
    ::setrlimit(RLIMIT_NOFILE, &files);
  }
  const rlim_t room =
      files.rlim_cur > 2 * for_all_else ? files.rlim_cur - for_all_else : files.rlim_cur / 2;
  limits.connections = std::min<std::size_t>(limits.connections, room);
  return limits;
}

bool is_loopback(const sockaddr_storage& peer) {
  if (peer.ss_family == AF_INET) {
    const auto& v4 = reinterpret_cast<const sockaddr_in&>(peer);
    return (ntohl(v4.sin_addr.s_addr) >> 24U) == 127;
  }
  const in6_addr& v6 = reinterpret_cast<const sockaddr_in6&>(peer).sin6_addr;
  return IN6_IS_ADDR_LOOPBACK(&v6) || (IN6_IS_ADDR_V4MAPPED(&v6) && v6.s6_addr[12] == 127);
}

Peer peer_of(const sockaddr_storage& address) {
  Peer peer;
  peer.is_loopback = is_loopback(address);
  peer.is_ipv6 = address.ss_family == AF_INET6;
  peer.address = client_address(address);
  return peer;
}

/// Often enough that no deadline is missed by more than an eighth, seldom enough to cost nothing.
std::chrono::milliseconds tick_of(const Limits& limits) {
  const auto shortest = std::min({limits.read_time, limits.handler_time, limits.write_time,
                                  limits.idle_time, limits.ping_time, limits.stop_grace});
  return std::clamp(shortest / 8, std::chrono::milliseconds(5), std::chrono::milliseconds(100));
}

}  // namespace

class Server::Running {
 public:
  Running(const ServerOptions& options, const Handler& handler)
      : limits_(within_system(options.limits)),
        metrics_(options.metrics),
        exchange_(options, handler),
        short_work_(options.threads),
        long_work_(options.threads),
        site_{io_,
              exchange_,
              short_work_,
              long_work_,
              limits_,
              metrics_.get(),
              [this](Session& s) { forget(s); },
              [this](Session& s, std::shared_ptr<Session> next) { succeed(s, std::move(next)); },
              [this](const std::string& client, std::size_t bytes) {
                close(those_to_cut_off(all_sessions(), client, bytes, limits_,
                                       std::chrono::steady_clock::now()));
              }},
        acceptor_(io_),
        ticker_(io_) {
    listen({address_of(options), options.port});
    accept();
    tick();
    thread_ = std::thread([this] { run(); });
  }

  ~Running() {
    asio::post(io_, [this] { drain(); });
    thread_.join();
    short_work_.stop();  // first: it hands work on to the other
    long_work_.stop();
  }

  std::uint16_t port() const noexcept { return port_; }

 private:
  /// What is thrown here is a want of memory: the session it hit is closed by its deadline.
  void run() {
    for (;;) {
      try {
        io_.run();
        return;
      } catch (const std::exception&) {
        continue;
      }
    }
  }

  void listen(const asio::ip::tcp::endpoint& endpoint) {
    try {
      acceptor_.open(endpoint.protocol());
      acceptor_.set_option(asio::socket_base::reuse_address(true));
      acceptor_.bind(endpoint);
      acceptor_.listen();
      acceptor_.native_non_blocking(true);
      port_ = acceptor_.local_endpoint().port();
    } catch (const boost::system::system_error& problem) {
      throw Error(ErrorKind::unavailable,
                  "cannot listen on " + endpoint.address().to_string() + " port " +
                      std::to_string(endpoint.port()) + ": " + problem.code().message() +
                      "; choose another address or port, or stop what listens there");
    }
  }

  // --- accepting ---

  /// `accept4` and not asio's: it gives the peer's address even of a connection that is reset
  /// already, and its errors (no descriptors left) must not end the accepting.
  void accept() {
    acceptor_.async_wait(asio::ip::tcp::acceptor::wait_read, [this](const ErrorCode& problem) {
      if (problem || !acceptor_.is_open()) return;
      try {
        if (accept_waiting()) return accept();
      } catch (const std::bad_alloc&) {
      }
      retry_at_ = std::chrono::steady_clock::now() + std::chrono::milliseconds(50);
    });
  }

  /// @return false where the process is out of descriptors or memory
  bool accept_waiting() {
    for (int i = 0; i < accepts_at_once; ++i) {
      sockaddr_storage peer{};
      socklen_t length = sizeof peer;
      const int descriptor =
          ::accept4(acceptor_.native_handle(), reinterpret_cast<sockaddr*>(&peer), &length,
                    SOCK_NONBLOCK | SOCK_CLOEXEC);
      if (descriptor >= 0) {
        welcome(descriptor, peer);
      } else if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM) {
        return false;
      } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
        return true;
      }
    }
    return true;
  }

  void welcome(int descriptor, const sockaddr_storage& peer) {
    if (sessions_.size() >= limits_.connections + refusals_at_once) {
      ::close(descriptor);
      return;
    }
    std::shared_ptr<Session> session;
    try {
      session = open_session(site_, descriptor, peer_of(peer));
    } catch (const std::exception&) {
      ::close(descriptor);  // no memory for it, or epoll would not have it
      return;
    }
    const bool has_room = sessions_.size() < limits_.connections || displace_some();
    sessions_.emplace(session.get(), session);
    if (has_room) {
      session->begin();
    } else {
      session->refuse_newcomer();
    }
  }

  /// Several at a time: looking for them takes longer than closing them.
  bool displace_some() {
    const std::size_t most = std::max<std::size_t>(1, limits_.connections / 32);
    const auto displaced =
        those_to_displace(all_sessions(), limits_, std::chrono::steady_clock::now(), most);
    close(displaced);
    return !displaced.empty();
  }

  static void close(const std::vector<std::shared_ptr<Session>>& sessions) {
    for (const auto& session : sessions) session->close();
  }

  void forget(Session& session) {
    sessions_.erase(&session);
    end_if_done();
  }

  void succeed(Session& session, std::shared_ptr<Session> successor) {
    sessions_.erase(&session);
    Session* const key = successor.get();
    sessions_.emplace(key, std::move(successor));
  }

  // --- deadlines and the end ---

  std::vector<std::shared_ptr<Session>> all_sessions() const {
    std::vector<std::shared_ptr<Session>> all;
    all.reserve(sessions_.size());
    for (const auto& [key, session] : sessions_) all.push_back(session);
    return all;
  }

  void tick() {
    ticker_.expires_after(tick_of(limits_));
    ticker_.async_wait([this](const ErrorCode& problem) {
      if (!problem) tick();
    });
    const Moment now = std::chrono::steady_clock::now();
    for (const auto& session : all_sessions()) {
      if (site_.is_stopping && now > stop_at_) {
        session->close();
      } else {
        session->tick(now);
      }
    }
    if (retry_at_ && now > *retry_at_ && acceptor_.is_open()) {
      retry_at_.reset();
      accept();
    }
    end_if_done();
  }

  /// Without the ticker nothing is left to wait for, and the thread ends.
  void end_if_done() {
    if (site_.is_stopping && sessions_.empty()) ticker_.cancel();
  }

  void drain() {
    site_.is_stopping = true;
    stop_at_ = std::chrono::steady_clock::now() + limits_.stop_grace;
    ErrorCode ignored;
    acceptor_.close(ignored);
    for (const auto& session : all_sessions()) session->drain();
    end_if_done();
  }

  // The io_context first: what lives in it goes before it.
  asio::io_context io_{1};
  const Limits limits_;
  std::shared_ptr<Metrics> metrics_;
  Exchange exchange_;
  WorkerPool short_work_;
  WorkerPool long_work_;
  SessionSite site_;
  asio::ip::tcp::acceptor acceptor_;
  asio::steady_timer ticker_;
  std::unordered_map<Session*, std::shared_ptr<Session>> sessions_;
  std::optional<Moment> retry_at_;
  Moment stop_at_;
  std::uint16_t port_ = 0;
  std::thread thread_;
};

Server::Server(ServerOptions options, Handler handler)
    : options_(std::move(options)), handler_(std::move(handler)) {
  const bool has_token = options_.token && !options_.token->empty();
  if (lets_others_in() && !has_token && !options_.read_only) {
    throw Error(ErrorKind::usage, "listening on " + options_.address +
                                      " lets other machines in: give a token for those that "
                                      "write, serve read-only, or listen on 127.0.0.1");
  }
}

Server::~Server() = default;

bool Server::lets_others_in() const { return !address_of(options_).is_loopback(); }

void Server::start() {
  expects(!running_, "a server is started once before it is stopped");
  running_ = std::make_unique<Running>(options_, handler_);
}

std::uint16_t Server::port() const noexcept { return running_ ? running_->port() : 0; }

void Server::stop() { running_.reset(); }

}  // namespace slackwater::api::http
