#include "calibration/day/rehearsal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::rehearsal_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcDay day = parse_day("2024-06-11");
const UtcTime end_of_day = UtcTime(day) + days(1);
const std::vector<double> depth_m{2, 8};

ForecastPlan plan_of(UtcDay last, WindPolicy wind = WindPolicy::forecast) {
  ForecastPlan plan;
  plan.day = last;
  plan.issued = plan.end_of_day() + hours(5);
  plan.wind = wind;
  plan.dataset = "model";
  plan.depth_m = depth_m;
  for (int h = 0; h <= 24; ++h) plan.stamps.push_back(plan.end_of_day() + hours(h));
  return plan;
}

/// A tide, a drift that wanders, and what the wind makes; a little noise, drawn by the hour.
Horizontal water(UtcTime time, double depth) {
  const double hour = hours_between(UtcTime(day), time);
  Rng rng(static_cast<std::uint64_t>(hour + 10000), "tests/rehearsal/noise");
  return std::polar(0.3, 0.506 * hour) + std::polar(0.15, 0.03 * hour) +
         Horizontal(0.02 * rng.normal(), 0.02 * rng.normal()) * std::exp(-depth / 20);
}

KnownSeriesForTests sea_of(int past_days, const FlowForTests& flow = water) {
  KnownSeriesForTests sea;
  sea.current(analysis_of("model"), instants(end_of_day - days(past_days), end_of_day + days(3)),
              depth_m, flow);
  sea.wind(analysis_of("wind"), instants(end_of_day - days(past_days), end_of_day + days(3)),
           [](UtcTime time, double) {
             const double hour = hours_between(UtcTime(day), time);
             return std::polar(7 + 2 * std::sin(0.07 * hour), 0.02 * hour);
           });
  return sea;
}

/// No provider's own forecast is stored, and nothing to merge ours with.
std::vector<bool> available_here() {
  std::vector<bool> available(candidate_methods().size(), true);
  available[1] = false;
  available.back() = false;
  return available;
}

Earned earned(const SiteData& data, const ForecastPlan& plan, int threads = 1) {
  return RehearsedDays(data).earned(plan, available_here(), threads);
}

void expect_same(const Earned& a, const Earned& b) {
  ASSERT_EQ(a.blend.share.size(), b.blend.share.size());
  for (std::size_t c = 0; c < a.blend.share.size(); ++c) {
    EXPECT_EQ(a.blend.share[c].method, b.blend.share[c].method);
    EXPECT_EQ(a.blend.share[c].weight, b.blend.share[c].weight);
    EXPECT_EQ(a.blend.share[c].pairs, b.blend.share[c].pairs);
    EXPECT_EQ(a.blend.share[c].past_rmse_m_s, b.blend.share[c].past_rmse_m_s);
  }
  EXPECT_EQ(a.blend.pairs, b.blend.pairs);
  EXPECT_EQ(a.blend.provenance, b.blend.provenance);
  EXPECT_EQ(a.spread.scale, b.spread.scale);
  EXPECT_EQ(a.spread.pairs, b.spread.pairs);
  EXPECT_EQ(a.spread.past_coverage_80, b.spread.past_coverage_80);
}

double weight_of(const Earned& earned, Method method) {
  for (const auto& share : earned.blend.share)
    if (share.method == method) return share.weight;
  ADD_FAILURE() << name_of(method);
  return 0;
}

TEST(RehearsedDays, SeeNothingLaterThanTheDay) {
  for (const WindPolicy wind : {WindPolicy::forecast, WindPolicy::persist}) {
    const KnownSeriesForTests sea = sea_of(7);
    ColumnData spoilt = sea.data;
    spoil_all_after(spoilt, end_of_day);
    const Earned made = earned(site_of({sea.data}), plan_of(day, wind));
    EXPECT_GE(made.blend.pairs, 5u) << "enough that the past decides";
    expect_same(earned(site_of({spoilt}), plan_of(day, wind)), made);
  }
}

TEST(RehearsedDays, TheDayItselfIsTheTruthOfTheLastOfThem) {
  const KnownSeriesForTests sea = sea_of(7);
  ColumnData spoilt = sea.data;
  spoil_all_after(spoilt, end_of_day - hours(2));
  const Earned made = earned(site_of({sea.data}), plan_of(day));
  const Earned other = earned(site_of({spoilt}), plan_of(day));
  EXPECT_EQ(other.blend.pairs, made.blend.pairs);
  EXPECT_GT(*other.blend.share[0].past_rmse_m_s, *made.blend.share[0].past_rmse_m_s);
}

TEST(RehearsedDays, EachWeightIsAShareOfOne) {
  const KnownSeriesForTests sea = sea_of(8);
  const Earned made = earned(site_of({sea.data}), plan_of(day));
  double sum = 0;
  for (const auto& share : made.blend.share) {
    EXPECT_GE(share.weight, 0) << name_of(share.method);
    sum += share.weight;
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_EQ(weight_of(made, Method::provider), 0) << "it cannot be made for this day";
  EXPECT_TRUE(made.blend.earned);
  EXPECT_EQ(made.spread.pairs, made.blend.pairs);
}

TEST(RehearsedDays, DoNotDependOnTheNumberOfThreads) {
  const KnownSeriesForTests sea = sea_of(8);
  const SiteData data = site_of({sea.data, sea.data});
  expect_same(earned(data, plan_of(day), 1), earned(data, plan_of(day), 2));
}

TEST(RehearsedDays, GoBackSoManyDaysAndNoFurther) {
  const KnownSeriesForTests sea = sea_of(RehearsedDays::longest_days + 6);
  const Earned made = earned(site_of({sea.data}), plan_of(day));
  EXPECT_EQ(made.blend.pairs, static_cast<std::size_t>(RehearsedDays::longest_days));
}

TEST(RehearsedDays, OfAShortRecordEveryWholeDayButTheLastIsOne) {
  // Of six whole days five have a next one; the first of them needs no history.
  const KnownSeriesForTests sea = sea_of(6);
  EXPECT_EQ(earned(site_of({sea.data}), plan_of(day)).blend.pairs, 5u);
}

TEST(RehearsedDays, ADayWithAGapIsPassedOver) {
  KnownSeriesForTests sea = sea_of(6);
  VectorColumn& column = sea.data.current.pieces[0].column;
  const UtcTime third_day = end_of_day - days(3);
  for (std::size_t t = 0; t < column.times(); ++t) {
    const double hour = hours_between(third_day, column.time[t].centre());
    if (hour > 6 && hour < 18)
      for (std::size_t k = 0; k < column.levels(); ++k)
        column.status[column.offset(t, k)] = SampleStatus::missing;
  }
  // It cannot be forecast from; what is left of it still is the truth of the day before.
  EXPECT_EQ(earned(site_of({sea.data}), plan_of(day)).blend.pairs, 4u);
}

TEST(RehearsedDays, WithoutAPastThePriorStands) {
  const KnownSeriesForTests sea = sea_of(1);
  const Earned made = earned(site_of({sea.data}), plan_of(day));
  EXPECT_EQ(made.blend.pairs, 0u);
  EXPECT_FALSE(made.blend.earned);
  EXPECT_EQ(weight_of(made, Method::forecast), 1)
      << "with the provider absent, all that has a prior";
  EXPECT_EQ(made.spread.scale, 1);
}

TEST(RehearsedDays, WhatNeverErredEarnsTheWeight) {
  // Every day is the day before, hour by hour, and no hour is like the next.
  const KnownSeriesForTests sea = sea_of(11, [](UtcTime time, double) {
    const auto hour = std::chrono::floor<hours>(time).time_since_epoch().count() % 24;
    Rng rng(static_cast<std::uint64_t>(hour), "tests/rehearsal/hour_of_day");
    return Horizontal(0.4 * rng.normal(), 0.4 * rng.normal());
  });
  const Earned made = earned(site_of({sea.data}), plan_of(day));
  EXPECT_GT(weight_of(made, Method::same_hour), 0.95);
  for (const auto& share : made.blend.share) {
    if (share.method != Method::same_hour) continue;
    EXPECT_LT(*share.past_rmse_m_s, 1e-12) << "rounding";
  }
}

TEST(RehearsedDays, ADayOnceRehearsedIsRemembered) {
  const KnownSeriesForTests sea = sea_of(4);
  const SiteData data = site_of({sea.data});
  int calibrated = 0;
  ColumnParts parts;
  parts.calibration = [&](auto&&... arguments) {
    ++calibrated;
    return calibrate_column(arguments...);
  };
  RehearsedDays rehearsals(data, parts);
  const std::vector<bool> available = available_here();
  const Earned first = rehearsals.earned(plan_of(day), available, 1);
  EXPECT_EQ(calibrated, 3);
  expect_same(rehearsals.earned(plan_of(day), available, 1), first);
  EXPECT_EQ(calibrated, 3);
}

/// What a rehearsal took for the wind after the end of a day.
struct SeenWind {
  UtcTime end_of_day{};
  HorizonWind wind;
};

std::vector<SeenWind> winds_seen(const SiteData& data, const ForecastPlan& plan, Earned& made) {
  std::vector<SeenWind> seen;
  ColumnParts parts;
  parts.wind = [&](const VectorRecord& wind, WindPolicy policy, UtcTime end,
                   std::span<const UtcTime> stamps, const BestInputs& best) {
    seen.push_back({end, horizon_wind(wind, policy, end, stamps, best)});
    return seen.back().wind;
  };
  const std::vector<bool> available = available_here();
  made = RehearsedDays(data, parts).earned(plan, available, 1);
  std::erase_if(seen, [&](const SeenWind& one) { return one.end_of_day >= plan.end_of_day(); });
  return seen;
}

ForecastPlan live_plan() {
  ForecastPlan plan = plan_of(day, WindPolicy::best);
  plan.best.issued = plan.issued;
  plan.best.known_by = plan.issued;
  return plan;
}

constexpr Horizontal said_by_runs(5, 0);
constexpr Horizontal analysed(9, 0);

/// Winds analysed until now, and the runs of the last days, each of three days.
KnownSeriesForTests sea_with_runs(int days_of_runs) {
  KnownSeriesForTests sea;
  sea.current(analysis_of("model"), instants(end_of_day - days(8), end_of_day), depth_m, water);
  sea.wind(analysis_of("wind"), instants(end_of_day - days(8), end_of_day + hours(5)),
           steady(analysed));
  for (int back = 0; back < days_of_runs; ++back) {
    const UtcTime issued = end_of_day - days(back);
    sea.wind(forecast_of("wind", issued, 50 + back), instants(issued, issued + days(3)),
             steady(said_by_runs));
  }
  return sea;
}

TEST(RehearsedDays, ForecastAPastDayWithTheRunOfThatDay) {
  const KnownSeriesForTests sea = sea_with_runs(9);
  Earned made;
  const std::vector<SeenWind> seen = winds_seen(site_of({sea.data}), live_plan(), made);
  ASSERT_GE(seen.size(), 7u);
  for (const SeenWind& one : seen) {
    // From six hours on nothing of that morning's analysis is left in the join.
    for (std::size_t h = 12; h <= 24; ++h) {
      EXPECT_EQ(one.wind.wind_m_s[h], said_by_runs) << format_utc(one.end_of_day) << " +" << h;
      EXPECT_EQ(one.wind.source[h], DataStatus::forecast);
    }
    EXPECT_FALSE(one.wind.simulated);
  }
  EXPECT_EQ(made.simulated_days, 0u);
}

TEST(RehearsedDays, SimulateTheRunsThatNobodyKept) {
  const KnownSeriesForTests sea = sea_with_runs(1);
  Earned made;
  const std::vector<SeenWind> seen = winds_seen(site_of({sea.data}), live_plan(), made);
  ASSERT_GE(seen.size(), 7u);
  double square = 0;
  double count = 0;
  for (const SeenWind& one : seen) {
    EXPECT_TRUE(one.wind.simulated) << format_utc(one.end_of_day);
    for (std::size_t h = 1; h <= 24; ++h) {
      square += std::norm(one.wind.wind_m_s[h] - analysed) / 2;
      ++count;
    }
  }
  // Between an analysis' error and that of a forecast of a day and a half; few are independent.
  EXPECT_GT(std::sqrt(square / count), 0.5);
  EXPECT_LT(std::sqrt(square / count), 2.2);
  EXPECT_GE(made.simulated_days, 7u);
}

TEST(RehearsedDays, WithoutARunNowNoneIsSimulatedForThen) {
  const KnownSeriesForTests sea = sea_with_runs(0);
  Earned made;
  const std::vector<SeenWind> seen = winds_seen(site_of({sea.data}), live_plan(), made);
  ASSERT_GE(seen.size(), 7u);
  for (const SeenWind& one : seen) {
    EXPECT_FALSE(one.wind.simulated);
    EXPECT_EQ(one.wind.source[20], DataStatus::persisted) << "as it will be tomorrow";
  }
  EXPECT_EQ(made.simulated_days, 0u);
}

TEST(RehearsedDays, ALaterDayOfLeadNeedsATruthThatEndsByThen) {
  const KnownSeriesForTests sea = sea_of(12);
  ForecastPlan plan = plan_of(day);
  for (int h = 25; h <= 72; ++h) plan.stamps.push_back(plan.end_of_day() + hours(h));
  const Earned made = earned(site_of({sea.data}), plan);
  ASSERT_EQ(made.later.size(), 2u);
  EXPECT_EQ(made.blend.pairs, 11u);
  EXPECT_EQ(made.later[0].pairs, 10u);
  EXPECT_EQ(made.later[1].pairs, 9u);
  ColumnData spoilt = sea.data;
  spoil_all_after(spoilt, end_of_day);
  const Earned other = earned(site_of({spoilt}), plan);
  for (std::size_t l = 0; l < 2; ++l)
    EXPECT_EQ(other.later[l].provenance, made.later[l].provenance);
}

/// When a file came in, by the end of the day that it holds.
using Arrival = std::function<UtcTime(UtcTime)>;

/// Days that came in wrong by so much, and once more, put right.
KnownSeriesForTests revised_sea(Horizontal wrong_by, const Arrival& first, const Arrival& again) {
  KnownSeriesForTests sea;
  for (int back = 8; back >= 0; --back) {
    const UtcTime end = end_of_day - days(back);
    const auto cells = instants(end - days(1) + hours(1), end);
    sea.current(received(analysis_of("model", 10 + back), first(end)), cells, depth_m,
                [=](UtcTime time, double depth) { return water(time, depth) + wrong_by; });
    sea.current(received(analysis_of("model", 110 + back), again(end)), cells, depth_m, water);
  }
  return sea;
}

/// The first at five in the morning after the day or so much later, the second two days after it.
KnownSeriesForTests revised_sea(Horizontal wrong_by, Duration late = {}) {
  return revised_sea(
      wrong_by, [=](UtcTime end) { return end + hours(5) + late; },
      [](UtcTime end) { return end + days(2) + hours(5); });
}

ForecastPlan plan_seen_now() {
  ForecastPlan plan = plan_of(day, WindPolicy::persist);
  plan.seen_by = plan.best.seen_by = plan.issued;
  return plan;
}

double past_error_of(const Earned& earned, Method method) {
  for (const auto& share : earned.blend.share)
    if (share.method == method) return share.past_rmse_m_s.value_or(NAN);
  return NAN;
}

TEST(RehearsedDays, StartFromTheEditionsThatStoodThen) {
  const Horizontal wrong_by(0.5, 0);
  const KnownSeriesForTests right = revised_sea({});
  const KnownSeriesForTests revised = revised_sea(wrong_by);
  const double of_right =
      past_error_of(earned(site_of({right.data}), plan_seen_now()), Method::same_hour);
  const double of_revised =
      past_error_of(earned(site_of({revised.data}), plan_seen_now()), Method::same_hour);
  // Yesterday's hour, wrong then, against what was put right since; the last pair's truth is not.
  EXPECT_LT(of_right, 0.25);
  EXPECT_GT(of_revised, 0.4);
  EXPECT_LT(of_revised, 0.7);
}

TEST(RehearsedDays, TakeTheEditionsOfNowWhereADayCameLate) {
  const Horizontal wrong_by(0.5, 0);
  const KnownSeriesForTests late = revised_sea(wrong_by, std::chrono::minutes(1));
  // Of each day but the last two the second edition counts now, and nothing stood there then.
  const Earned made = earned(site_of({late.data}), plan_seen_now());
  EXPECT_GE(made.blend.pairs, 5u);
  EXPECT_LT(past_error_of(made, Method::same_hour), 0.35);
}

TEST(RehearsedDays, OfARecordLengthenedBackwardsSinceTakeItWhole) {
  // Days before the first that came in by itself are read in today.
  KnownSeriesForTests lengthened = revised_sea({0.5, 0});
  lengthened.current(received(analysis_of("model", 500), end_of_day + hours(4)),
                     instants(end_of_day - days(12) + hours(1), end_of_day - days(9)), depth_m,
                     water);
  EXPECT_LT(past_error_of(earned(site_of({lengthened.data}), plan_seen_now()), Method::same_hour),
            0.35);
}

TEST(RehearsedDays, OfAnArchiveReadLaterSeeItsNewestEditions) {
  KnownSeriesForTests archive = revised_sea({0.5, 0});
  ForecastPlan plan = plan_seen_now();
  plan.seen_by = plan.best.seen_by = UtcTime::max();
  EXPECT_LT(past_error_of(earned(site_of({archive.data}), plan), Method::same_hour), 0.25);
  // The same live, of an archive that was read in on the morning of the forecast.
  const Arrival this_morning = [](UtcTime) { return end_of_day + hours(4); };
  const KnownSeriesForTests read_now = revised_sea({0.5, 0}, this_morning, this_morning);
  const Earned made = earned(site_of({read_now.data}), plan_seen_now());
  EXPECT_EQ(made.blend.pairs, 8u);
  EXPECT_LT(past_error_of(made, Method::same_hour), 0.25);
}

TEST(RehearsedDays, ADayThatFailsIsCountedAndTheOthersDecideAsIfItWereNotThere) {
  const KnownSeriesForTests sea = sea_of(8);
  const SiteData data = site_of({sea.data});
  const UtcDay bad = day - days(3);
  const std::vector<bool> available = available_here();
  ColumnParts parts;
  parts.record = [&](const ColumnData& column, const ForecastPlan& plan) {
    expects(plan.day != bad, "a broken part");
    return known_currents(column, plan);
  };
  const Earned made = RehearsedDays(data, parts).earned(plan_of(day), available, 2);
  EXPECT_EQ(made.failed_days, 1u);
  ASSERT_TRUE(made.first_failure);
  EXPECT_NE(made.first_failure->why.find("a broken part"), std::string::npos);
  const Earned whole = RehearsedDays(data).earned(plan_of(day), available, 2);
  EXPECT_EQ(made.blend.pairs, whole.blend.pairs - 1);
  EXPECT_EQ(whole.failed_days, 0u);
}

TEST(RehearsedDays, DoNotAskForWaves) {
  const KnownSeriesForTests sea = sea_of(4);
  const SiteData data = site_of({sea.data});
  ColumnParts parts;
  parts.waves = [](auto&&...) -> HorizonSea { throw Error(ErrorKind::internal, "asked"); };
  const std::vector<bool> available = available_here();
  EXPECT_EQ(RehearsedDays(data, parts).earned(plan_of(day), available, 1).failed_days, 0u);
}

TEST(RehearsedDays, AreTheSameWhicheverDayOfAHindcastAsksFirst) {
  const KnownSeriesForTests sea = sea_of(8);
  const SiteData data = site_of({sea.data});
  const std::vector<bool> available = available_here();
  RehearsedDays shared(data);
  (void)shared.earned(plan_of(day), available, 1);
  const UtcDay before = day - days(2);
  expect_same(shared.earned(plan_of(before), available, 1),
              RehearsedDays(data).earned(plan_of(before), available, 1));
}

TEST(RehearsedDays, TheirTruthIsThatOfTheirDayWhoeverAsks) {
  // A station that begins later is fused with what is asked for after it began, and with nothing
  // of the days before: they were over.
  KnownSeriesForTests sea = sea_of(8);
  sea.current(
      station_of("late", 9), instants(end_of_day - days(2), end_of_day), {2, 8},
      [](UtcTime time, double depth) { return water(time, depth) + 0.2; }, 500);
  const SiteData data = site_of({sea.data});
  const std::vector<bool> available = available_here();
  RehearsedDays shared(data);
  (void)shared.earned(plan_of(day), available, 1);
  const UtcDay before = day - days(3);
  expect_same(shared.earned(plan_of(before), available, 1), earned(data, plan_of(before)));
}

TEST(RehearsedDays, ARehearsedDayBelongsToAllOfThePlanThatItRestsOn) {
  const KnownSeriesForTests sea = sea_of(7);
  const SiteData data = site_of({sea.data});
  const std::vector<bool> available = available_here();
  RehearsedDays shared(data);
  (void)shared.earned(plan_of(day), available, 1);
  ForecastPlan shallow = plan_of(day);
  shallow.depth_m = {2};
  expect_same(shared.earned(shallow, available, 1), earned(data, shallow));
  ForecastPlan late = plan_of(day);
  late.issued += days(1);
  expect_same(shared.earned(late, available, 1), earned(data, late));
  ForecastPlan honest = plan_of(day, WindPolicy::best);
  (void)shared.earned(honest, available, 1);
  honest.best = {honest.issued, false};
  expect_same(shared.earned(honest, available, 1), earned(data, honest));
}

TEST(RehearsedDays, UnderBestWindTheySeeNothingThatCameAfterTheIssueTime) {
  const KnownSeriesForTests sea = sea_of(7);
  ForecastPlan plan = plan_of(day, WindPolicy::best);
  plan.best = {plan.issued, false};
  ColumnData spoilt = sea.data;
  spoil_all_after(spoilt, plan.issued);
  expect_same(earned(site_of({spoilt}), plan), earned(site_of({sea.data}), plan));
}

TEST(RehearsedDays, ARehearsedDayBelongsToItsWindPolicy) {
  const KnownSeriesForTests sea = sea_of(7);
  const SiteData data = site_of({sea.data});
  const std::vector<bool> available = available_here();
  RehearsedDays shared(data);
  for (const WindPolicy wind : {WindPolicy::best, WindPolicy::forecast, WindPolicy::persist}) {
    expect_same(shared.earned(plan_of(day, wind), available, 1), earned(data, plan_of(day, wind)));
  }
}

TEST(RehearsedDays, PassOverColumnsWithoutCurrents) {
  const KnownSeriesForTests sea = sea_of(7);
  ColumnData dry = sea.data;
  dry.current = {};
  expect_same(earned(site_of({dry, sea.data}), plan_of(day)),
              earned(site_of({sea.data}), plan_of(day)));
  EXPECT_EQ(earned(site_of({dry}), plan_of(day)).blend.pairs, 0u);
}

}  // namespace
}  // namespace slackwater::calibration::rehearsal_test
