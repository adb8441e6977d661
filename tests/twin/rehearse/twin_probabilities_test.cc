// The twin's probability of success, `next_success` of flights in a fixed number of futures, beside
// what came: the same flight in one future more, exchangeable with them. A few days in tests; `make
// soak` flies three hundred. (A rehearsal stops when it knows enough: its interval is built for
// that, see success_interval_test.cc.)
#include <array>

#include "tests/support/asked_number.h"
#include "tests/support/shared_data.h"
#include "tests/twin/mission/mission_for_tests.h"
#include "tests/twin/rehearse/eye_task.h"
#include "tests/twin/rehearse/water_of_members.h"
#include "tests/twin/risk/said_and_came.h"
#include "twin/chance/success_interval.h"
#include "twin/rehearse/by_the_limits.h"
#include "twin/rehearse/flight.h"

namespace slackwater::tests::twin_probabilities_test {
namespace {

constexpr std::size_t flown_futures = 18;
constexpr std::size_t cases_a_day = 8;
constexpr std::size_t hours = 10;
const UtcTime midnight = parse_utc("2025-06-02T00:00:00Z");

/// A few minutes at a pile: in a stream beyond its limit it holds, until the reserve calls it home.
std::string look() {
  return eye_task("look", 0.5, 0.5, R"(    work:
      - {pattern: verticals, stand_off_m: 3, from: {depth_m: 4}, to: {depth_m: 8}, bearings: 2}
)");
}

twin::Scenario mission_of(std::uint64_t seed) {
  twin::MissionParts parts = small_farm_parts();
  parts.task = [](const std::string&) { return Config::parse(look(), "look.yaml"); };
  const std::string yaml =
      "name: look\nseed: " + std::to_string(seed) +
      "\nduration: 10min\nstep_s: 0.05\nlog_every_s: 10\nwater: {made_up: {depth_m: 35, current: "
      "[{depth_m: 0, east_m_s: 0.4, north_m_s: 0}], wind: {speed_m_s: 3, from_deg: 270}}}\nwaves: "
      "{from: calm}\ntasks: [look]\nturbines: [A01]\nagents: {eye: {state_of_charge: 0.25}}\n";
  return twin::expand_mission(Config::parse(yaml, "mission.yaml"), parts).scenario;
}

/// The speed of the current hour by hour: the forecast, then the futures about it, all drawn alike,
/// and with the last of them what comes.
using Speeds = HourlySpeeds;
Speeds speeds_of(Rng& random) {
  Speeds speeds(flown_futures + 2);
  const double mean = random.uniform(0.25, 0.55), phase = random.uniform(0, 6.283185307179586);
  for (std::size_t i = 0; i <= hours; ++i)
    speeds[0].push_back(std::max(0.0, mean + 0.2 * std::sin(phase + static_cast<double>(i))));
  const double kept = std::exp(-1.0 / 8), fresh = std::sqrt(1 - kept * kept);
  for (std::size_t f = 1; f < speeds.size(); ++f) {
    double z = random.normal();
    for (std::size_t i = 0; i <= hours; ++i) {
      speeds[f].push_back(std::max(0.0, speeds[0][i] + 0.07 * z));
      z = kept * z + fresh * random.normal();
    }
  }
  return speeds;
}

Case case_of(twin::Scenario mission, const twin::Surround& surround, UtcTime start) {
  mission.water = twin::ForecastWater{};  // whose futures are members, not seeds alone
  std::vector<twin::FlightCase> cases;
  for (std::size_t f = 1; f <= flown_futures + 1; ++f) cases.push_back({start, f});
  const std::vector<twin::Flight> flights = twin::fly(mission, surround, cases, {});
  std::size_t done = 0;
  for (std::size_t f = 0; f < flown_futures; ++f) done += flights[f].is_done ? 1 : 0;
  const twin::LimitsSay say = twin::by_the_limits(mission, surround, start, {});
  // Practice has no factor for currents: a margin like that of its waves stands for one.
  return {twin::next_success(done, flown_futures), say.allows, say.share <= 0.7,
          flights.back().is_done};
}

/// Starts that come near the limit oversampled.
Day day_of(std::size_t number, std::size_t wanted) {
  Rng random(2025, "twin_probabilities/" + std::to_string(number));
  const twin::Scenario mission = mission_of(number + 1);
  const Speeds speeds = speeds_of(random);
  const twin::Surround surround = water_of_members(mission, speeds, midnight);
  std::vector<int> near;
  const auto minutes = static_cast<int>(60 * (hours - 1));
  for (int minute = 0; minute < minutes; minute += 10) {
    const double share = speeds[0][static_cast<std::size_t>(minute / 60)] / 0.5;
    if (share > 0.75 && share < 1.25) near.push_back(minute);
  }
  Day day;
  const auto add = [&](int minute) {
    std::erase(near, minute);  // a start is a case once
    day.push_back(case_of(mission, surround, midnight + std::chrono::minutes(minute)));
  };
  add(10 * static_cast<int>(random.bits() % static_cast<unsigned>(minutes / 10)));
  while (day.size() < wanted && !near.empty()) add(near[random.bits() % near.size()]);
  return day;
}

std::vector<Day> days_of(std::size_t wanted, std::size_t cases) {
  std::vector<Day> days;
  for (std::size_t i = 0; i < wanted; ++i) days.push_back(day_of(i, cases));
  return days;
}

TEST(TwinProbabilities, ComeTrueAsOftenAsTheySayWithABetterScoreThanARule) {
  const auto wanted = static_cast<std::size_t>(asked_number("SLACKWATER_TWIN_DAYS", 0));
  if (wanted < 300) GTEST_SKIP() << "SLACKWATER_TWIN_DAYS=300 flies them (make soak)";
  const std::vector<Day> days = days_of(wanted, cases_a_day);
  EXPECT_GE(expect_true_as_said(days), 6U);
  expect_better_than("threshold", days, [](const Case& one) { return one.by_threshold; });
  expect_better_than("margin", days, [](const Case& one) { return one.by_alpha; });
  std::printf("cost/loss   value by P, by threshold, by margin\n");
  for (const double ratio : {0.1, 0.3, 0.5, 0.7, 0.9})
    std::printf("  %.2f      %.3f  %6.3f  %6.3f\n", ratio,
                value_of(days, ratio, [&](const Case& one) { return 1 - one.probability > ratio; }),
                value_of(days, ratio, [](const Case& one) { return !one.by_threshold; }),
                value_of(days, ratio, [](const Case& one) { return !one.by_alpha; }));
  const auto rates = [&](const char* name, const auto& goes) {
    const auto [go, stay] = false_go_and_no_go(days, goes);
    std::printf("  %-10s into a broken task %.3f of those who go, stayed for nothing %.3f\n", name,
                go, stay);
    return go;
  };
  const double ours = rates("P >= 0.9", [](const Case& one) { return one.probability >= 0.9; });
  EXPECT_LT(ours, rates("threshold", [](const Case& one) { return one.by_threshold; }));
  rates("margin", [](const Case& one) { return one.by_alpha; });
}

/// Of a few starts of a few days no more come to nothing, and no fewer, than their probabilities
/// add up to: within four of the deviations that independent cases would have.
TEST(TwinProbabilities, ComeTrueOverAFewDays) {
  double off = 0, variance = 0, most = 0, least = 1;
  for (const Day& day : days_of(6, 3))
    for (const Case& one : day) {
      off += (one.held ? 1 : 0) - one.probability;
      variance += one.probability * (1 - one.probability);
      most = std::max(most, one.probability);
      least = std::min(least, one.probability);
    }
  EXPECT_LT(std::abs(off), 4 * std::sqrt(variance));
  EXPECT_GT(most, 0.8);
  EXPECT_LT(least, 0.2);
}

/// In a stream that all futures agree on, it is sure either way, and says it.
TEST(TwinProbabilities, AreSureWhereAllFuturesAgree) {
  const twin::Scenario mission = mission_of(1);
  const Speeds slow(flown_futures + 2, std::vector<double>(hours + 1, 0.1));
  const Case calm = case_of(mission, water_of_members(mission, slow, midnight), midnight);
  EXPECT_NEAR(calm.probability, 18.5 / 19, 1e-9);
  EXPECT_TRUE(calm.held && calm.by_threshold && calm.by_alpha);
  const Speeds fast(flown_futures + 2, std::vector<double>(hours + 1, 0.7));
  const Case wild = case_of(mission, water_of_members(mission, fast, midnight), midnight);
  EXPECT_NEAR(wild.probability, 0.5 / 19, 1e-9);
  EXPECT_FALSE(wild.held || wild.by_threshold || wild.by_alpha);
}

}  // namespace
}  // namespace slackwater::tests::twin_probabilities_test
