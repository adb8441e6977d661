// rtps_attacker PROCESS WAY SECONDS SEED CORPUS: sends what no peer sends, as fast as one core can,
// to each UDP port of a process of this machine that is on DDS, and to the group that it listens
// to. It joins as a participant first, and hears what it is told. On loopback alone: what it makes
// up says that it listens where the attacker does. CORPUS is a folder of datagrams that ended Fast
// DDS once (found_*), with the names "attackerpref" and "targetprefix" in them. Prints how much it
// sent. Exit 3: it met nobody.
#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "fields/base/numbers/random.h"
#include "tests/api/door/dds/forged_rtps.h"
#include "tests/support/udp_sockets.h"

namespace slackwater::tests {
namespace {

using dds::Bytes;
using dds::Payload;
using dds::Prefix;
using Clock = std::chrono::steady_clock;

class Socket {
 public:
  Socket() : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    const sockaddr_in any = at(0, "127.0.0.1");
    (void)::bind(socket_, reinterpret_cast<const sockaddr*>(&any), sizeof any);
    ::setsockopt(socket_, IPPROTO_IP, IP_MULTICAST_IF, &any.sin_addr, sizeof any.sin_addr);
    const timeval wait{0, 20'000};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &wait, sizeof wait);
  }
  ~Socket() { ::close(socket_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  static sockaddr_in at(std::uint16_t port, const char* address) {
    sockaddr_in made{};
    made.sin_family = AF_INET;
    made.sin_port = htons(port);
    ::inet_pton(AF_INET, address, &made.sin_addr);
    return made;
  }
  [[nodiscard]] std::uint16_t port() const {
    sockaddr_in own{};
    socklen_t size = sizeof own;
    ::getsockname(socket_, reinterpret_cast<sockaddr*>(&own), &size);
    return ntohs(own.sin_port);
  }
  /// Each to each place.
  void send(std::span<const Bytes> all, std::span<sockaddr_in> to) {
    std::vector<mmsghdr> messages;
    std::vector<iovec> parts(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      parts[i] = {const_cast<std::uint8_t*>(all[i].data()), all[i].size()};
      for (sockaddr_in& place : to) {
        mmsghdr message{};
        message.msg_hdr.msg_name = &place;
        message.msg_hdr.msg_namelen = sizeof place;
        message.msg_hdr.msg_iov = &parts[i];
        message.msg_hdr.msg_iovlen = 1;
        messages.push_back(message);
      }
    }
    for (std::size_t at = 0; at < messages.size();) {
      const int sent =
          ::sendmmsg(socket_, &messages[at], static_cast<unsigned>(messages.size() - at), 0);
      // Port 0 of a socket that was closed, a buffer that is full: on with the next.
      at += sent > 0 ? static_cast<std::size_t>(sent) : 1U;
      sent_ += sent > 0 ? static_cast<std::uint64_t>(sent) : 0U;
    }
  }
  [[nodiscard]] Bytes receive(std::uint16_t& from) {
    Bytes bytes(65'536);
    sockaddr_in sender{};
    socklen_t size = sizeof sender;
    const auto got = ::recvfrom(socket_, bytes.data(), bytes.size(), 0,
                                reinterpret_cast<sockaddr*>(&sender), &size);
    from = ntohs(sender.sin_port);
    bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return bytes;
  }
  [[nodiscard]] std::uint64_t sent() const noexcept { return sent_; }

 private:
  int socket_;
  std::uint64_t sent_ = 0;
};

class Attacker {
 public:
  Attacker(const std::string& process, std::uint64_t seed) : random_(seed, "rtps attacker") {
    own_ = made_up();
    for (const UdpSocket& socket : udp_sockets_of(process)) ports_.insert(socket.port);
    for (const std::uint16_t port : ports_) {
      to_.push_back(Socket::at(port, "127.0.0.1"));
      if (port < 32'768) to_.push_back(Socket::at(port, "239.255.0.1"));
    }
  }

  /// Joins, and keeps what the other says of itself, of its topics and of samples.
  bool meet() {
    const auto until = Clock::now() + std::chrono::seconds(3);
    for (int i = 0; Clock::now() < until && heard_.size() < 60; ++i) {
      introduce(static_cast<std::uint32_t>(i + 1));
      std::uint16_t from = 0;
      Bytes got = socket_.receive(from);
      if (got.size() < 20 || !ports_.contains(from)) continue;
      std::copy_n(got.begin() + 8, target_.size(), target_.begin());
      heard_.push_back(std::move(got));
    }
    // From then on we say it of ourselves.
    for (Bytes& bytes : heard_)
      put_in(bytes, {reinterpret_cast<const char*>(target_.data()), target_.size()}, own_);
    return !heard_.empty();
  }

  /// Datagrams of which one, or two in their order, ended the library.
  void learn(const std::filesystem::path& corpus) {
    std::set<std::filesystem::path> files;
    for (const auto& file : std::filesystem::directory_iterator(corpus))
      if (file.path().filename().string().starts_with("found_")) files.insert(file.path());
    for (const auto& path : files) {
      std::ifstream file(path, std::ios::binary);
      Bytes bytes{std::istreambuf_iterator<char>(file), {}};
      put_in(bytes, "attackerpref", own_);
      put_in(bytes, "targetprefix", target_);
      known_.push_back(std::move(bytes));
    }
  }

  int attack(const std::string& way, double seconds, const std::filesystem::path& corpus) {
    const std::map<std::string, Bytes (Attacker::*)()> ways{
        {"random", &Attacker::random_bytes}, {"mutated", &Attacker::mutated},
        {"claims", &Attacker::claims},       {"announcements", &Attacker::announcement},
        {"known", &Attacker::known},         {"small", &Attacker::small},
        {"readers", &Attacker::reader}};
    const auto known = ways.find(way);
    if (known == ways.end()) return 2;
    if (!meet()) return 3;
    learn(corpus);
    const auto until = Clock::now() + std::chrono::duration<double>(seconds);
    std::uint32_t rounds = 0;
    for (; Clock::now() < until; ++rounds) {
      if (rounds % 1000 == 0) introduce(1'000'000 + rounds);  // its lease
      std::vector<Bytes> batch(32);
      for (Bytes& bytes : batch) bytes = (this->*known->second)();
      socket_.send(batch, to_);
    }
    std::printf("%s: %llu datagrams in %g s, %zu heard before\n", way.c_str(),
                static_cast<unsigned long long>(socket_.sent()), seconds, heard_.size());
    return 0;
  }

 private:
  static void put_in(Bytes& bytes, std::string_view name, const Prefix& participant) {
    for (auto at = bytes.begin();;) {
      at = std::search(at, bytes.end(), name.begin(), name.end(),
                       [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); });
      if (at == bytes.end()) return;
      at = std::copy(participant.begin(), participant.end(), at);
    }
  }
  std::size_t index(std::size_t size) { return random_.bits() % size; }
  template <typename T>
  T one_of(std::initializer_list<T> values) {
    return *(values.begin() + index(values.size()));
  }
  Prefix made_up() {
    Prefix made;
    std::generate(made.begin(), made.end(),
                  [&] { return static_cast<std::uint8_t>(random_.bits()); });
    return made;
  }
  ForgedPlace place(std::uint32_t lease_s) const { return {socket_.port(), lease_s}; }

  /// Joins, or stays; and asks for what the other tells of one of its writers and of its readers.
  void introduce(std::uint32_t count) {
    std::vector<Bytes> said{ForgedRtps(own_).announce(own_, place(20), count).bytes()};
    const std::array<std::uint8_t, 4> the_first_of_them{0, 0, 0, 0x80};
    const std::int64_t which = 1 + count % 24;
    for (const Ends& ends : {publications, subscriptions})
      said.push_back(
          ForgedRtps(own_).to(target_).acknack(ends, which, 1, the_first_of_them, count).bytes());
    socket_.send(said, to_);
  }

  Bytes known() { return known_[static_cast<std::size_t>(count_++) % known_.size()]; }

  Bytes random_bytes() {
    Bytes bytes(1 + index(1472));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random_.bits());
    if (random_.uniform() < 0.5) {
      const Bytes head = ForgedRtps(random_.uniform() < 0.5 ? own_ : made_up()).bytes();
      bytes.insert(bytes.begin(), head.begin(), head.end());
    }
    return bytes;
  }

  Bytes mutated() {
    Bytes bytes = heard_[index(heard_.size())];
    for (std::size_t n = 1 + index(3); n > 0 && bytes.size() > 24; --n) {
      const std::size_t at = 20 + index(bytes.size() - 20);
      switch (index(4)) {
        case 0:
          bytes[at] ^= static_cast<std::uint8_t>(1U << index(8));
          break;
        case 1:
          bytes[at] = one_of<std::uint8_t>({0, 1, 0x7F, 0x80, 0xFE, 0xFF});
          break;
        case 2: {
          const auto word = bytes_of(
              one_of({0U, 1U, 0xFFU, 0xFFFFU, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFFF0U, 0xFFFFFFFFU}),
              Order::little);
          std::copy_n(word.begin(), std::min<std::size_t>(4, bytes.size() - at),
                      bytes.begin() + static_cast<std::ptrdiff_t>(at));
          break;
        }
        default:
          bytes.resize(at);
      }
    }
    return bytes;
  }

  Bytes claims() {
    const Ends ends = one_of({participants, publications, subscriptions, liveliness, of_a_topic});
    const auto far = [&] { return one_of<std::int64_t>({0, -1, 1, 1LL << 33, 1LL << 62, 1000}); };
    const std::uint32_t count = static_cast<std::uint32_t>(++count_);
    ForgedRtps made(own_);
    if (random_.uniform() < 0.7) made.to(target_);
    const Bytes set(4 * index(10), 0xFF);
    switch (index(7)) {
      case 0:
        return made.heartbeat(ends, far(), far(), count).bytes();
      case 1:
        return made.gap(ends, far(), far(), one_of({0U, 256U, 257U, 0xFFFFFFFFU}), index(9))
            .bytes();
      case 2:
        return made.acknack(ends, far(), one_of({0U, 256U, 0x80000000U}), set, count).bytes();
      case 3: {
        ForgedRtps::PieceOf of{count_,
                               one_of({0U, 1U, 2U, 0xFFFFFFFFU}),
                               one_of<std::uint16_t>({0, 1, 4, 0xFFFF}),
                               one_of<std::uint16_t>({0, 1, 16, 1024, 0xFFFF}),
                               one_of({0U, 16U, 4096U, 1U << 22U, 0xFFFFFFFFU}),
                               index(2000)};
        return made.piece(ends, of).bytes();
      }
      case 4: {
        const auto to = one_of<std::uint16_t>({0, 8, 16, 60, 200, 0x7FFF, 0xFFF8, 0xFFFF});
        const auto flags = one_of<std::uint8_t>({1, 3, 5, 7, 9, 0x0D});
        const Bytes sample = forged_announcement(own_, place(20));
        return made.data(ends, count_, Payload(sample).first(index(sample.size())), to, flags)
            .part(0x01, 1, Fields().zeros(400))
            .bytes();
      }
      case 5:
        return made
            .part(one_of<std::uint8_t>({0x06, 0x07, 0x08, 0x09, 0x0C, 0x0D, 0x0E, 0x12, 0x13, 0x15,
                                        0x16, 0x30, 0x31, 0x33, 0x80}),
                  static_cast<std::uint8_t>(random_.bits()), Fields().zeros(index(60)),
                  one_of<std::uint16_t>({0, 4, 20, 0xFFFF}))
            .bytes();
      default:
        // A sample far away, of one that exists.
        return made.data(ends, far(), forged_announcement(own_, place(20))).bytes();
    }
  }

  Bytes announcement() {
    const Prefix who = made_up();
    return ForgedRtps(who)
        .announce(who, place(one_of({0U, 1U, 20U, 3600U, 0x7FFFFFFFU, 0xFFFFFFFFU})))
        .bytes();
  }

  Bytes small() {
    switch (index(3)) {
      case 0:
        return {0};
      case 1:
        return {'R', 'T', 'P', 'S', 2, 3};
      default:
        return ForgedRtps(made_up()).bytes();
    }
  }

  /// One more reader of what a vehicle of the run tells most often.
  Bytes reader() {
    const auto key = (static_cast<std::uint32_t>(++count_) << 8U) | 0x04U;
    const Fields guid = Fields().raw(own_).entity(key);
    const auto text = [](std::string_view words) {
      const auto* const bytes = reinterpret_cast<const std::uint8_t*>(words.data());
      return Fields()
          .put(static_cast<std::uint32_t>(words.size() + 1))
          .raw({bytes, words.size()})
          .zeros(1);
    };
    constexpr std::uint32_t reliable = 2;
    const Bytes sample =
        Fields()
            .raw(std::array<std::uint8_t, 4>{0, 3, 0, 0})
            .parameter(0x5A, guid)
            .parameter(0x05, text("rt/rov/odometry"))
            .parameter(0x07, text("nav_msgs::msg::dds_::Odometry_"))
            .parameter(0x1A, Fields().put(reliable).put(0U).put(0U))
            .parameter(0x2F, Fields()
                                 .put(1U)
                                 .put(1024 + static_cast<std::uint32_t>(count_) % 60'000)
                                 .zeros(12)
                                 .raw(std::array<std::uint8_t, 4>{127, 0, 0, 1}))
            .parameter(0x70, guid)
            .end()
            .bytes();
    return ForgedRtps(own_).to(target_).data(subscriptions, count_, sample).bytes();
  }

  Rng random_;
  Socket socket_;
  Prefix own_{};
  Prefix target_{};
  std::set<std::uint16_t> ports_;
  std::vector<sockaddr_in> to_;
  std::vector<Bytes> heard_;
  std::vector<Bytes> known_;
  std::int64_t count_ = 0;
};

}  // namespace
}  // namespace slackwater::tests

int main(int argc, char** argv) {
  if (argc != 6 || ::nice(5) < 0) return 2;  // what it attacks shall find a core
  slackwater::tests::Attacker attacker(argv[1], std::strtoull(argv[4], nullptr, 10));
  return attacker.attack(argv[2], std::atof(argv[3]), argv[5]);
}
