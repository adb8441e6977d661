#include "tests/support/lossy_link.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/if_tun.h>
#include <net/if.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <deque>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace slackwater::tests {
namespace {

using SteadyClock = std::chrono::steady_clock;

void expect_done(bool is_done, const std::string& what) {
  if (is_done) return;
  throw std::runtime_error(what + ": " + std::strerror(errno) +
                           "; run this as root, or under `unshare --user --map-root-user`");
}

ifreq interface(const char* name) {
  ifreq request{};
  std::strncpy(request.ifr_name, name, IFNAMSIZ - 1);
  return request;
}

void set_address(int socket, unsigned long what, ifreq request, const char* address) {
  sockaddr_in to{};
  to.sin_family = AF_INET;
  ::inet_pton(AF_INET, address, &to.sin_addr);
  std::memcpy(&request.ifr_addr, &to, sizeof to);
  expect_done(::ioctl(socket, what, &request) == 0, std::string("the address ") + address);
}

void bring_up(int socket, ifreq request) {
  request.ifr_flags = IFF_UP | IFF_RUNNING | IFF_MULTICAST;
  expect_done(::ioctl(socket, SIOCSIFFLAGS, &request) == 0,
              std::string("the interface ") + request.ifr_name);
}

/// Runs it on a thread of its own; what is thrown there is thrown here.
void on_a_thread(const std::function<void()>& work) {
  std::exception_ptr failure;
  std::thread([&] {
    try {
      work();
    } catch (...) {
      failure = std::current_exception();
    }
  }).join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace

LossyLink::Handle::~Handle() {
  if (value >= 0) ::close(value);
}

LossyLink::LossyLink(std::chrono::milliseconds delay) : delay_(delay) {
  for (const End end : {End::near, End::far}) on_a_thread([&] { make(end); });
  thread_ = std::thread([this] { carry_all(); });
}

LossyLink::~LossyLink() {
  is_over_ = true;
  thread_.join();
}

const char* LossyLink::address(End end) noexcept {
  return end == End::near ? "10.77.0.1" : "10.77.0.2";
}

/// On a thread, which is in the new network from there on, and goes with it.
void LossyLink::make(End end) {
  Side& side = sides_[static_cast<int>(end)];
  expect_done(::unshare(CLONE_NEWNET) == 0, "a network namespace");
  side.network.value = ::open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC);
  expect_done(side.network.value >= 0, "/proc/thread-self/ns/net");
  side.tunnel.value = ::open("/dev/net/tun", O_RDWR | O_CLOEXEC | O_NONBLOCK);
  expect_done(side.tunnel.value >= 0, "/dev/net/tun");
  ifreq tunnel = interface("link0");
  tunnel.ifr_flags = IFF_TUN | IFF_NO_PI;
  expect_done(::ioctl(side.tunnel.value, TUNSETIFF, &tunnel) == 0, "a tunnel");
  const Handle socket{::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)};
  expect_done(socket.value >= 0, "a socket");
  bring_up(socket.value, interface("lo"));
  set_address(socket.value, SIOCSIFADDR, interface("link0"), address(end));
  set_address(socket.value, SIOCSIFNETMASK, interface("link0"), "255.255.255.0");
  bring_up(socket.value, interface("link0"));
}

void LossyLink::at(End end, const std::function<void()>& work) const {
  const int network = sides_[static_cast<int>(end)].network.value;
  on_a_thread([&] {
    expect_done(::setns(network, CLONE_NEWNET) == 0, "entering a network namespace");
    work();
  });
}

void LossyLink::carry_all() {
  struct Packet {
    SteadyClock::time_point due;
    int to;
    std::vector<char> bytes;
  };
  std::deque<Packet> under_way;  // all take as long: the first in is the first out
  std::array<char, 65536> buffer;
  while (!is_over_) {
    pollfd readable[2];
    for (int i = 0; i < 2; ++i) readable[i] = {sides_[i].tunnel.value, POLLIN, 0};
    ::poll(readable, 2, under_way.empty() ? 20 : 1);
    const auto now = SteadyClock::now();
    for (int i = 0; i < 2; ++i) {
      for (;;) {
        const ssize_t size = ::read(sides_[i].tunnel.value, buffer.data(), buffer.size());
        if (size <= 0) break;
        if (chance_.uniform() < loss_)
          ++lost_;
        else
          under_way.push_back({now + delay_, sides_[1 - i].tunnel.value,
                               std::vector<char>(buffer.data(), buffer.data() + size)});
      }
    }
    for (; !under_way.empty() && under_way.front().due <= now; under_way.pop_front()) {
      const Packet& packet = under_way.front();
      const bool is_through =
          loss_ < 1 && ::write(packet.to, packet.bytes.data(), packet.bytes.size()) >= 0;
      ++(is_through ? carried_ : lost_);
    }
  }
}

}  // namespace slackwater::tests
