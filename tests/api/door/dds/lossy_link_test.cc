// A vehicle and its client, with a bad link between them.
#include "tests/support/lossy_link.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>

#include "api/door/dds/message/orders.h"
#include "api/door/dds/participant.h"
#include "tests/api/door/dds/cdr_by_hand.h"
#include "tests/api/door/dds/inbox.h"
#include "tests/api/door/dds/own_domain.h"
#include "tests/api/door/live/live_records.h"
#include "tests/support/started_program.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::lossy_link_test {
namespace {

using namespace std::chrono_literals;
using SteadyClock = std::chrono::steady_clock;
using End = LossyLink::End;

/// Nothing, and why, where the system does not permit it.
std::unique_ptr<LossyLink> made(std::chrono::milliseconds delay, std::string& why) {
  try {
    return std::make_unique<LossyLink>(delay);
  } catch (const std::runtime_error& e) {
    why = e.what();
    return nullptr;
  }
}

/// Of UDP, at one end.
class Socket {
 public:
  Socket(const LossyLink& link, End end) {
    link.at(end, [&] { socket_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0); });
    const sockaddr_in here = place(end);
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&here), sizeof here), 0);
  }
  ~Socket() { ::close(socket_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  void send(SteadyClock::time_point value, End to) const {
    const sockaddr_in there = place(to);
    ::sendto(socket_, &value, sizeof value, 0, reinterpret_cast<const sockaddr*>(&there),
             sizeof there);
  }
  /// Nothing where none came within the time.
  [[nodiscard]] std::optional<SteadyClock::time_point> receive(std::chrono::milliseconds most) {
    const timeval wait{most.count() / 1000, most.count() % 1000 * 1000};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &wait, sizeof wait);
    SteadyClock::time_point value;
    if (::recv(socket_, &value, sizeof value, 0) != ssize_t{sizeof value}) return std::nullopt;
    return value;
  }

 private:
  static sockaddr_in place(End end) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(7777);
    ::inet_pton(AF_INET, LossyLink::address(end), &place.sin_addr);
    return place;
  }
  int socket_ = -1;
};

/// What is seen of a vehicle beside it: at its end of the link.
class Observer {
 public:
  Observer(const LossyLink& link, int domain, const std::string& vehicle) {
    dds::DomainSettings settings;
    settings.domain = domain;
    settings.is_udp_only = true;
    link.at(End::near, [&] { participant_.emplace(settings); });
    participant_->subscribe(
        {"/" + vehicle + "/mission_state", "std_msgs/msg/String", "", {true, true, 1}},
        [this](dds::Payload message, const std::string&) {
          const auto json =
              nlohmann::json::parse(HandReader({message.begin(), message.end()}).string());
          doings_.put(std::string(json.at("doing")) + " " + std::string(json.value("cause", "")));
        });
    participant_->subscribe(
        {"/" + vehicle + "/pose", "geometry_msgs/msg/PoseStamped", "", {true, false, 10}},
        [this](dds::Payload message, const std::string&) {
          const auto at = dds::place_in_pose(message).position_m;
          if (!start_) start_ = at;
          away_m_ = std::hypot(at.x - start_->x, at.y - start_->y);
        });
  }
  /// Whether it gets to do that; what it did instead is told.
  testing::AssertionResult does(const std::string& doing) {
    if (comes_true([&] { return doings_.size() > 0 && doings_.wait().back() == doing; }, 90s))
      return testing::AssertionSuccess();
    auto told = testing::AssertionFailure() << "not '" << doing << "' but";
    for (const std::string& other : doings_.wait(0)) told << " '" << other << "'";
    return told;
  }
  /// From where it was seen first, horizontally.
  [[nodiscard]] double away_m() const { return away_m_; }

 private:
  Inbox<std::string> doings_;
  std::optional<twin::Triple<double>> start_;
  std::atomic<double> away_m_ = 0;
  std::optional<dds::Participant> participant_;  ///< goes first
};

bool has_line(const std::filesystem::path& file, const std::string& line) {
  std::ifstream lines(file);
  for (std::string one; std::getline(lines, one);)
    if (one == line) return true;
  return false;
}

// Of the link itself, without which the test below it would prove nothing.
TEST(LossyLink, LosesAndDelaysAsItSaysAndIsCut) {
  std::string why;
  const auto link = made(200ms, why);
  if (!link) GTEST_SKIP() << why;
  link->lose(0.3);
  const Socket near(*link, End::near);
  Socket far(*link, End::far);
  constexpr int sent = 200;  // what a socket holds until it is read
  for (int i = 0; i < sent; ++i) near.send(SteadyClock::now(), End::far);
  int received = 0;
  while (const auto at = far.receive(1s)) {
    EXPECT_GE(SteadyClock::now() - *at, 200ms);
    ++received;
  }
  // Binomial: 140 of 200, standard deviation 6.5; four of them.
  EXPECT_NEAR(received, 0.7 * sent, 26);
  EXPECT_GE(link->lost(), static_cast<unsigned>(sent - received));
  link->lose(1);
  for (int i = 0; i < 20; ++i) near.send(SteadyClock::now(), End::far);
  EXPECT_FALSE(far.receive(500ms).has_value());
}

// As clients write `cmd_vel`: reliably, the last one alone. Where the reader has room for one
// alone too, some two of a hundred come through.
TEST(LossyLink, CommandsThatAreRenewedGetThrough) {
  std::string why;
  const auto link = made(50ms, why);
  if (!link) GTEST_SKIP() << why;
  const OwnDomain domain;
  dds::DomainSettings settings;
  settings.domain = domain.number();
  settings.is_udp_only = true;
  const bag::Channel command{"/rov/cmd_vel", "geometry_msgs/msg/Twist", "", {true, false, 1}};
  std::atomic<int> heard = 0;
  std::optional<dds::Participant> vehicle, client;
  link->at(End::near, [&] { vehicle.emplace(settings); });
  link->at(End::far, [&] { client.emplace(settings); });
  vehicle->subscribe(command, [&](dds::Payload, const std::string&) { ++heard; });
  const auto writer = client->publish_on(command);
  const dds::Bytes message = HandWriter().doubles({0.2, 0, 0, 0, 0, 0}).bytes();
  const auto send = [&] {
    client->send(writer, message);
    std::this_thread::sleep_for(50ms);
  };
  ASSERT_TRUE(comes_true([&] {
    send();
    return heard > 0;
  }));
  link->lose(0.3);
  const int before = heard;
  constexpr int sent = 80;
  for (int i = 0; i < sent; ++i) send();
  std::this_thread::sleep_for(500ms);
  EXPECT_GT(heard - before, sent * 4 / 10);
}

TEST(LossyLink, AVehicleThatIsCutOffFromItsClientHoldsAndGoesHome) {
  if (std::getenv("SLACKWATER_LOSSY_LINK") == nullptr)
    GTEST_SKIP() << "takes minutes; `make soak` sets SLACKWATER_LOSSY_LINK=1";
  std::string why;
  const auto link = made(200ms, why);
  if (!link) GTEST_SKIP() << why;
  link->lose(0.3);
  const OwnDomain domain;
  const TemporaryFolder folder;
  const std::string number = std::to_string(domain.number());
  std::optional<StartedProgram> run, pilot;
  link->at(End::near, [&] {
    run.emplace(start_program(
        {"live", live_scenario(), "--dds-domain", number, "--udp-only", "--real-time-factor", "4"},
        {}, "/dev/null", folder / "live.log"));
  });
  link->at(End::far, [&] {
    pilot.emplace(
        start_other_program(SLACKWATER_FAR_PILOT, {number, "rov", "100"}, folder / "pilot"));
  });
  {
    Observer observer(*link, domain.number(), "rov");
    for (const char* said : {"sent", "under way"})
      ASSERT_TRUE(comes_true([&] { return has_line(folder / "pilot", said); }, 180s)) << said;
    ASSERT_TRUE(observer.does("waypoints asked"));
    EXPECT_GT(link->lost(), link->carried() / 5) << "the link was too good";
    link->lose(1);
    // Fast DDS takes the client for lost after 20 s of silence.
    ASSERT_TRUE(observer.does("hold client_lost"));
    ASSERT_TRUE(observer.does("home held_too_long"));
    const double turned_m = observer.away_m();
    EXPECT_TRUE(comes_true([&] { return observer.away_m() < turned_m - 2; }, 60s))
        << turned_m << " m from where it began, then " << observer.away_m();
  }
  EXPECT_EQ(run->end(SIGINT), 0);
}

}  // namespace
}  // namespace slackwater::tests::lossy_link_test
