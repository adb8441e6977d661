#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <thread>

#include "fields/base/numbers/random.h"

namespace slackwater::tests {

/// Two networks of their own and a link between them that loses some packets and delays all others:
/// an IP tunnel in each, and a thread that carries packets from one to the other. Of the kernel it
/// needs network namespaces and tunnels (/dev/net/tun), no netem.
class LossyLink {
 public:
  enum class End { near, far };

  /// @throws std::runtime_error where the system does not permit it: what, and how it would
  explicit LossyLink(std::chrono::milliseconds delay);
  ~LossyLink();
  LossyLink(const LossyLink&) = delete;
  LossyLink& operator=(const LossyLink&) = delete;

  /// Of an end, IPv4.
  [[nodiscard]] static const char* address(End end) noexcept;
  /// Does work in the network of an end, and waits for it: the sockets that it opens, the threads
  /// and processes that it starts are there, and stay there.
  void at(End end, const std::function<void()>& work) const;

  /// The share of packets that are lost from now on, each by itself. 0 at first; 1: it is cut, and
  /// what is under way is lost too.
  void lose(double share) noexcept { loss_ = share; }
  [[nodiscard]] std::uint64_t carried() const noexcept { return carried_; }
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }

 private:
  /// A descriptor, closed with it.
  struct Handle {
    int value = -1;
    ~Handle();
  };
  struct Side {
    Handle network;
    Handle tunnel;
  };
  void make(End end);
  void carry_all();

  std::chrono::milliseconds delay_;
  std::atomic<double> loss_ = 0;
  Rng chance_{1, "a lossy link"};
  Side sides_[2];
  std::atomic<bool> is_over_ = false;
  std::atomic<std::uint64_t> carried_ = 0, lost_ = 0;
  std::thread thread_;
};

}  // namespace slackwater::tests
