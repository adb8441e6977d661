// The energy-aware planner beside the fixed plan: seeded missions in water whose current differs by
// seed, and whose truth is none of the members that the planner sees. A few in tests; `make soak`
// flies two hundred (SLACKWATER_PLANNED_MISSIONS).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <thread>

#include "fields/base/numbers/random.h"
#include "tests/support/asked_number.h"
#include "tests/twin/rehearse/pile_survey.h"

namespace slackwater::tests::fixed_and_adapted_test {
namespace {

using twin::ReserveFate;

constexpr std::size_t many = 50;  // missions from which on figures are held against each other
constexpr std::size_t hours = 3;
const UtcTime midnight = parse_utc("2025-06-02T00:00:00Z");

/// A forecast, and members about it with errors of 0.07 m/s that last for hours.
/// @param futures  that the planner sees; the one after them comes
HourlySpeeds speeds_of(std::size_t futures, Rng& random) {
  HourlySpeeds speeds(futures + 2);
  const double mean = random.uniform(0.05, 0.5), phase = random.uniform(0, 6.283185307179586);
  for (std::size_t i = 0; i < hours; ++i)
    speeds[0].push_back(
        std::max(0.0, mean + 0.05 * std::sin(phase + 0.5 * static_cast<double>(i))));
  const double kept = std::exp(-1.0 / 8), fresh = std::sqrt(1 - kept * kept);
  for (std::size_t f = 1; f < speeds.size(); ++f) {
    double z = random.normal();
    for (std::size_t i = 0; i < hours; ++i) {
      speeds[f].push_back(std::max(0.0, speeds[0][i] + 0.07 * z));
      z = kept * z + fresh * random.normal();
    }
  }
  return speeds;
}

/// What came of a plan in the truth.
struct Came {
  bool is_flown = false;
  ReserveFate fate = ReserveFate::kept;
  double coverage = 0;
  double time_s = 0;
  double hole_m = 22;  ///< tallest part of the pile between two levels that were looked at
  double charge = 0;
  bool violates() const { return is_flown && fate != ReserveFate::kept; }
};

/// The tallest part between 5 and 27 m where it did not go round, on one depth for half a minute.
double hole_of(const std::vector<twin::FlightSample>& samples) {
  std::vector<double> down_m{5, 27};
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (samples[i].phase == static_cast<std::uint8_t>(twin::Phase::work) &&
        samples[i].doing == static_cast<std::uint8_t>(twin::Doing::task) &&
        std::abs(samples[i].down_m - samples[i - 1].down_m) < 0.2)
      down_m.push_back(samples[i].down_m);
  std::sort(down_m.begin(), down_m.end());
  double hole_m = 0;
  for (std::size_t i = 1; i < down_m.size(); ++i)
    hole_m = std::max(hole_m, down_m[i] - down_m[i - 1]);
  return hole_m;
}

struct Compared {
  Came fixed, adapted;
  double density = 0;  ///< 0: not to be flown
};

Compared compared(std::size_t number, std::size_t futures) {
  Rng random(2025, "fixed_and_adapted/" + std::to_string(number));
  // Its battery has what the fixed plan takes in a current that somebody reckoned with.
  const double charge = 0.21 + 1.05 * charge_taken({}, random.uniform(0.15, 0.45));
  const twin::MissionThinned made_up = pile_survey(number + 1, charge);
  const twin::MissionThinned mission = in_a_forecast(made_up);
  const twin::Surround surround =
      water_of_members(made_up({}), speeds_of(futures, random), midnight);
  twin::IntensityQuestion question;
  question.start = midnight + std::chrono::minutes(random.bits() % 60);
  for (std::size_t member = 1; member <= futures; ++member) question.members.push_back(member);
  question.flights.workers = {"eye"};
  question.flights.sample_every_s = 30;
  question.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const twin::IntensityChoice choice = twin::adapt_intensity(mission, surround, question);
  const twin::Scenario fixed = mission({});
  const auto came = [&](const twin::Intensity& thinned_by) {
    const twin::Scenario flown = mission(thinned_by);
    const twin::FlightCase truth{question.start, futures + 1};
    const twin::Flight flight = twin::fly(flown, surround, {&truth, 1}, question.flights).front();
    Came out;
    out.is_flown = true;
    out.fate = twin::reserve_fate(flight, flown, question.flights);
    out.coverage = twin::coverage_of(flight, flown, fixed, question.flights);
    out.time_s = flight.ended_s;
    out.hole_m = hole_of(flight.samples[0]);
    out.charge = flight.vehicles[0].on_mission.charge;
    return out;
  };
  Compared out;
  out.fixed = came({});
  if (choice.chosen) {
    out.density = choice.tried[*choice.chosen].thinned_by.density;
    out.adapted = came(choice.tried[*choice.chosen].thinned_by);
  }
  return out;
}

struct Interval {
  double low = 0, high = 1;
};
/// Of a share, 95 %. Source: Wilson (1927), J. Am. Stat. Assoc. 22, 209.
Interval wilson(std::size_t of, std::size_t trials) {
  constexpr double z = 1.959964;
  const double n = static_cast<double>(trials), p = static_cast<double>(of) / n;
  const double middle = (p + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z / (1 + z * z / n) * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  return {middle - half, middle + half};
}
/// Mean, and its 95 % interval as of a normal.
struct Mean {
  double value = 0, half = 0;
};
Mean mean_of(const std::vector<double>& values) {
  const double n = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  for (const double value : values) squares += (value - sum / n) * (value - sum / n);
  return {sum / n, n > 1 ? 1.96 * std::sqrt(squares / (n - 1) / n) : 0};
}

TEST(Wilson, IsTheRootOfItsQuadratic) {
  // (p - 0.1)^2 = z^2 p (1 - p) / n at both ends.
  const Interval i = wilson(20, 200);
  for (const double p : {i.low, i.high})
    EXPECT_NEAR((p - 0.1) * (p - 0.1), 1.959964 * 1.959964 * p * (1 - p) / 200, 1e-12);
}

void print(const char* name, const std::vector<Compared>& all, Came Compared::*plan) {
  std::array<std::size_t, twin::reserve_fate_count> fates{};
  std::size_t flown = 0, violations = 0;
  std::vector<double> coverage, time, hole;
  for (const Compared& one : all) {
    const Came& came = one.*plan;
    flown += came.is_flown ? 1 : 0;
    violations += came.violates() ? 1 : 0;
    if (!came.is_flown) continue;
    ++fates[static_cast<std::size_t>(came.fate)];
    coverage.push_back(came.coverage);
    time.push_back(came.time_s / 60);
    hole.push_back(came.hole_m);
  }
  const Interval of_all = wilson(violations, all.size());
  std::printf(
      "%-8s %4zu flown; reserve not kept %4zu of %zu (%.1f %%, %.1f to %.1f): %zu called "
      "home, %zu broken, %zu not home\n",
      name, flown, violations, all.size(),
      100.0 * static_cast<double>(violations) / static_cast<double>(all.size()), 100 * of_all.low,
      100 * of_all.high, fates[1], fates[2], fates[3]);
  if (flown == 0) return;
  const Mean c = mean_of(coverage), t = mean_of(time), h = mean_of(hole);
  std::printf(
      "         coverage %.3f +- %.3f, time %.1f +- %.1f min, tallest hole %.1f +- %.1f m\n",
      c.value, c.half, t.value, t.half, h.value, h.half);
}

TEST(FixedAndAdapted, KeepTheReserveAsOftenAsTheySay) {
  const auto missions = static_cast<std::size_t>(asked_number("SLACKWATER_PLANNED_MISSIONS", 3));
  std::vector<Compared> all;
  for (std::size_t i = 0; i < missions; ++i) all.push_back(compared(i, missions < many ? 9 : 19));
  std::size_t fixed = 0, adapted = 0, only_fixed = 0, only_adapted = 0, same = 0;
  for (const Compared& one : all) {
    fixed += one.fixed.violates() ? 1 : 0;
    adapted += one.adapted.violates() ? 1 : 0;
    only_fixed += one.fixed.violates() && !one.adapted.violates() ? 1 : 0;
    only_adapted += one.adapted.violates() && !one.fixed.violates() ? 1 : 0;
    if (one.density < 1) continue;
    // Where energy suffices it is the fixed plan, to the last bit.
    ++same;
    EXPECT_EQ(one.adapted.coverage, one.fixed.coverage);
    EXPECT_EQ(one.adapted.time_s, one.fixed.time_s);
    EXPECT_EQ(one.adapted.charge, one.fixed.charge);
  }
  print("fixed", all, &Compared::fixed);
  print("adapted", all, &Compared::adapted);
  // Side by side: without the missions that the planner does not fly.
  std::vector<Compared> flown;
  for (const Compared& one : all)
    if (one.adapted.is_flown) flown.push_back(one);
  std::printf("of those that both fly:\n");
  if (!flown.empty()) {
    print("fixed", flown, &Compared::fixed);
    print("adapted", flown, &Compared::adapted);
  }
  std::printf(
      "the fixed plan taken in %zu; only the fixed plan failed in %zu, only the adapted in "
      "%zu\n",
      same, only_fixed, only_adapted);
  for (const double density : {1.0, 0.8, 0.65, 0.5, 0.35, 0.2, 0.0})
    std::printf("  density %.2f: %td\n", density,
                std::count_if(all.begin(), all.end(),
                              [&](const Compared& one) { return one.density == density; }));
  // The rank rule allows a tenth; what is above may be chance.
  EXPECT_LE(wilson(adapted, missions).low, 0.1);
  EXPECT_LE(adapted, fixed);
  EXPECT_EQ(only_adapted, 0U) << "sparser was harder";
  if (missions < many) return;
  EXPECT_GT(wilson(fixed, missions).low, wilson(adapted, missions).high);
  EXPECT_GT(same, missions / 10);
}

}  // namespace
}  // namespace slackwater::tests::fixed_and_adapted_test
