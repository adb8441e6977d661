// `slackwater live`, while its ports are flooded with what no peer sends.

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "api/door/dds/participant.h"
#include "tests/api/door/dds/own_domain.h"
#include "tests/api/door/dds/without_leaks.h"
#include "tests/api/door/live/live_records.h"
#include "tests/support/asked_number.h"
#include "tests/support/comes_true.h"
#include "tests/support/started_program.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::flooded_live_test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr double steps_a_second = 20;  // of the scenario
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double most_growth_mb = 400;  // theirs: shadows, and what was freed is kept for a while
// They compute for a multiple of the time, beside other tests: pace is asserted of what users run.
constexpr double least_pace = 0.5;
constexpr double most_gap_s = 5;
#else
constexpr double most_growth_mb = 100;
constexpr double least_pace = 0.9;
constexpr double most_gap_s = 1;
#endif

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

double resident_mb(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string word; status >> word;)
    if (word == "VmRSS:") {
      double kib = 0;
      status >> kib;
      return kib / 1024;
    }
  return 0;
}

/// A true subscriber to what a vehicle tells with each step.
class Subscriber {
 public:
  explicit Subscriber(int domain) : node_(settings(domain)) {
    node_.subscribe({"/rov/odometry", "nav_msgs/msg/Odometry", "", {true, false, 10}},
                    [this](dds::Payload, const std::string&) { heard(); });
  }
  [[nodiscard]] bool hears(std::chrono::seconds within = 20s) {
    const std::size_t before = count();
    return comes_true([&] { return count() > before + 5; }, within);
  }
  /// Since it was last asked: samples, and the longest time without one.
  struct Told {
    std::size_t samples = 0;
    double seconds = 0;
    double longest_gap_s = 0;
    [[nodiscard]] double rate() const { return static_cast<double>(samples) / seconds; }
  };
  Told take() {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    longest_ = std::max(longest_, now - last_);
    const Told told{count_ - told_, std::chrono::duration<double>(now - since_).count(),
                    std::chrono::duration<double>(longest_).count()};
    told_ = count_;
    since_ = last_ = now;
    longest_ = {};
    return told;
  }

 private:
  static dds::DomainSettings settings(int domain) {
    dds::DomainSettings made;
    made.domain = domain;
    made.node = "subscriber";
    made.is_loopback_only = made.is_udp_only = true;
    return made;
  }
  std::size_t count() {
    const std::lock_guard lock(mutex_);
    return count_;
  }
  void heard() {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    if (count_++ > 0) longest_ = std::max(longest_, now - last_);
    last_ = now;
  }

  std::mutex mutex_;
  std::size_t count_ = 0, told_ = 0;
  Clock::time_point since_ = Clock::now(), last_ = since_;
  Clock::duration longest_{};
  dds::Participant node_;  // last: it calls us
};

/// One way of attacking for so long.
void expect_undisturbed(const std::string& way, double seconds, pid_t run, Subscriber& subscriber,
                        const std::filesystem::path& said) {
  static std::uint64_t seed = 0;
  SCOPED_TRACE(way + ", seed " + std::to_string(++seed));
  (void)subscriber.take();
  const double before_mb = resident_mb(run);
  const int exit_code = wait_for_program(
      start_other_program(SLACKWATER_RTPS_ATTACKER,
                          {std::to_string(run), way, std::to_string(seconds), std::to_string(seed),
                           (source_folder() / "tests/fuzz/corpus/rtps").string()},
                          said));
  const Subscriber::Told told = subscriber.take();
  const double after_mb = resident_mb(run);
  EXPECT_EQ(exit_code, 0) << text_of(said);
  std::printf("%s%13s  %4.1f samples/s, at most %3.0f ms apart, %5.1f -> %5.1f MB\n",
              text_of(said).c_str(), "", told.rate(), 1000 * told.longest_gap_s, before_mb,
              after_mb);
  EXPECT_GT(told.rate(), least_pace * steps_a_second);
  EXPECT_LT(told.longest_gap_s, most_gap_s);
  EXPECT_LT(after_mb, before_mb + most_growth_mb);
}

TEST(FloodedLiveRun, KeepsItsPaceItsSizeAndItsSubscribersAndEndsWhenItIsTold) {
  const int asked_s = asked_number("SLACKWATER_FLOOD_SECONDS", 0);
  const double seconds = asked_s > 0 ? asked_s : 0.7;  // in each way
  const TemporaryFolder folder;
  const OwnDomain domain;
  const auto log = folder / "run.nc", mcap = folder / "run.mcap";
  StartedProgram run(
      start_program({"live", live_scenario(), "--dds-domain", std::to_string(domain.number()),
                     "--loopback", "--udp-only", "--record", mcap, "--out", log, "--json"},
                    without_leaks(":quarantine_size_mb=16"), folder / "out", folder / "err"));
  Subscriber subscriber(domain.number());
  ASSERT_TRUE(subscriber.hears()) << text_of(folder / "err");
  const auto begun = Clock::now();
  (void)subscriber.take();
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  const Subscriber::Told calm = subscriber.take();
  std::printf("undisturbed: %.1f samples/s, at most %.0f ms apart\n", calm.rate(),
              1000 * calm.longest_gap_s);

  for (const char* way :
       {"known", "random", "mutated", "claims", "small", "announcements", "readers"})
    expect_undisturbed(way, seconds, run.process(), subscriber, folder / "said");

  Subscriber late(domain.number());
  EXPECT_TRUE(late.hears()) << "who comes after the flood";
  const double lived_s = std::chrono::duration<double>(Clock::now() - begun).count();
  const auto told_to_end = Clock::now();
  ASSERT_EQ(run.end(SIGTERM), 0) << text_of(folder / "err");
  EXPECT_LT(Clock::now() - told_to_end, 20s);

  const std::string said = text_of(folder / "err");
  for (const char* named :
       {"no RTPS that a peer sends", "(256 participants are heard|More new participants)",
        "more readers and writers", "contradict each other"})
    EXPECT_TRUE(std::regex_search(said, std::regex(named))) << named << " is not in\n" << said;
  EXPECT_FALSE(std::regex_search(said, std::regex("Assertion|Sanitizer|terminate|rror]"))) << said;
  EXPECT_LT(said.size(), 100'000U);
  const auto result = nlohmann::json::parse(text_of(folder / "out"));
  const auto& punctuality = result.at("punctuality");
  std::printf("punctuality %s\n", punctuality.dump().c_str());
  EXPECT_GT(punctuality.at("steps").get<double>(), least_pace * steps_a_second * lived_s);
  EXPECT_LT(punctuality.at("worst_ms").get<double>(), 1000 * most_gap_s);
  // All of it is on record.
  EXPECT_GT(expect_even_clock(messages_of(mcap)), least_pace * steps_a_second * lived_s);
  EXPECT_EQ(run_program({"replay", log}).exit_code, 0);
}

}  // namespace
}  // namespace slackwater::tests::flooded_live_test
