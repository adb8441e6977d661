#include "calibration/day/column/tide_of_record.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "calibration/day/column/methods.h"
#include "calibration/day/daily_forecast.h"
#include "calibration/day/given/known_currents.h"
#include "fields/current/astronomy.h"
#include "tests/support/known_series_for_tests.h"

// Who of a record holds the tide, and what is made of it.

namespace slackwater::calibration::tide_of_record_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcDay day = parse_day("2024-06-11");
const UtcTime midnight(day);
const UtcTime end_of_day = midnight + days(1);
const UtcTime first = end_of_day - days(24);
const std::vector<double> depth_m{2, 10, 20};
/// With the equilibrium ratios, so that a short record's inference is right.
Horizontal tide(UtcTime time) {
  Horizontal sum{};
  for (const auto& [name, ratio] :
       {std::pair("M2", 1.0), std::pair("S2", 0.465), std::pair("N2", 0.191)}) {
    const double v = astronomical_argument_rad(tidal_constituent(name), time);
    sum += ratio * (0.35 * std::polar(1.0, v) + 0.15 * std::polar(1.0, -v));
  }
  return sum;
}

/// A slow turn that no constituent of a fortnight is near.
Horizontal drift(UtcTime time) {
  return std::polar(0.08, 2 * std::numbers::pi * hours_between(midnight, time) / 190);
}

Origin detided() {
  Origin origin = analysis_of("model");
  origin.rank.has_tide = false;
  return origin;
}

/// A detided product by the hour; a meter at the place, if any, sees all motion.
KnownSeriesForTests sea(std::optional<std::pair<UtcTime, UtcTime>> meter,
                        Duration step = hours(1)) {
  KnownSeriesForTests made;
  made.current(detided(), instants(first, end_of_day, step), depth_m,
               [](UtcTime time, double) { return drift(time); });
  if (meter)
    made.current(
        station_of("Meter"), instants(meter->first, meter->second), {5, 15},
        [](UtcTime time, double) { return drift(time) + tide(time); }, 500);
  return made;
}

ForecastPlan plan_of(const std::string& dataset) {
  ForecastPlan plan;
  plan.day = day;
  plan.issued = end_of_day + hours(5);
  plan.dataset = dataset;
  plan.depth_m = depth_m;
  return plan;
}

/// Root mean square of what is carried on at the middle level less the true tide, over that of the
/// tide, on the next three days.
double miss(const FittedTide& fitted) {
  double squares = 0;
  double power = 0;
  for (int h = 1; h <= 72; ++h) {
    const UtcTime time = end_of_day + hours(h);
    squares += std::norm(fitted.at(1, TimeCell::instant(time)) - tide(time));
    power += std::norm(tide(time));
  }
  return std::sqrt(squares / power);
}

TEST(TideOfRecord, WhatNobodySaysAnythingOfHoldsIt) {
  KnownSeriesForTests made;
  made.current(analysis_of("model"), instants(first, end_of_day), depth_m,
               [](UtcTime time, double) { return drift(time) + tide(time); });
  const auto known = known_currents(made.data, plan_of("model")).record;
  EXPECT_EQ(tide_since(known, day), UtcTime::min());
  EXPECT_LT(miss(tide_of_record(known, day, made.data.point.latitude)), 0.2)
      << "the drift is no noise to the fit";
}

TEST(TideOfRecord, ADetidedProductHasNoneHoweverMuchItLooksLikeOne) {
  KnownSeriesForTests made;
  made.current(detided(), instants(first, end_of_day), depth_m,
               [](UtcTime time, double) { return drift(time) + tide(time); });
  const auto known = known_currents(made.data, plan_of("model")).record;
  EXPECT_EQ(tide_since(known, day), std::nullopt);
  const FittedTide fitted = tide_of_record(known, day, made.data.point.latitude);
  EXPECT_TRUE(fitted.levels.empty());
  ASSERT_EQ(fitted.notes.size(), 1U);
  EXPECT_EQ(fitted.notes[0], "no tide is fitted or carried on: the currents of model are detided");
}

TEST(TideOfRecord, AMeterThatLeadsHoldsItWhateverLiesBehind) {
  const KnownSeriesForTests made = sea(std::pair(first, end_of_day), hours(6));
  const auto known = known_currents(made.data, plan_of("Meter")).record;
  ASSERT_FALSE(known.empty());
  EXPECT_EQ(tide_since(known, day), UtcTime::min());
  EXPECT_LT(miss(tide_of_record(known, day, made.data.point.latitude)), 0.15);
}

TEST(TideOfRecord, FusedWithAMeterTheTideIsThatOfTheMetersTime) {
  const UtcTime began = end_of_day - days(8);
  const KnownSeriesForTests made = sea(std::pair(began, end_of_day));
  const auto known = known_currents(made.data, plan_of("model")).record;
  const auto since = tide_since(known, day);
  ASSERT_TRUE(since);
  EXPECT_NEAR(hours_between(began, *since), 0, 2.5);
  const FittedTide fitted = tide_of_record(known, day, made.data.point.latitude);
  EXPECT_LT(miss(fitted), 0.2) << "fusion leaves a little of it to the product";
  EXPECT_GT(miss(fit_column_tide(known.column, made.data.point.latitude)), 0.4)
      << "two thirds of the record have none";
  EXPECT_EQ(fitted.at(1, TimeCell::instant(began - days(1))), Horizontal{})
      << "nothing to take away where there is none";
}

TEST(TideOfRecord, OfAMeterThatHasGoneNothingIsCarriedOn) {
  for (const Duration silent : {Duration(days(3)), Duration(hours(9))}) {
    const KnownSeriesForTests made = sea(std::pair(first, end_of_day - silent));
    EXPECT_EQ(tide_since(known_currents(made.data, plan_of("model")).record, day), std::nullopt);
  }
}

TEST(TideOfRecord, ADayOfWhichPartLacksTheTideIsNoTidalDay) {
  const KnownSeriesForTests made = sea(std::pair(midnight + hours(10), end_of_day));
  EXPECT_EQ(tide_since(known_currents(made.data, plan_of("model")).record, day), std::nullopt);
}

TEST(TideOfRecord, BaselinesThatCarryATideOnAreNoCandidatesOfADetidedRecord) {
  const auto methods_of = [](const KnownSeriesForTests& made) {
    const ForecastPlan plan = plan_of("model");
    const auto known = known_currents(made.data, plan).record;
    Chosen<Horizontal> truth = known;
    truth.column.time.clear();
    for (std::size_t t = 0; t < known.column.times(); ++t)
      truth.column.time.push_back(TimeCell::instant(end_of_day + hours(1 + int(t) % 72)));
    Snapshot snapshot;
    snapshot.depth_m = depth_m;
    snapshot.columns.emplace_back();
    std::vector<Method> methods;
    for (const auto& method : current_methods(made.data, plan, snapshot, 0, truth, known, {}))
      methods.push_back(method.method);
    return methods;
  };
  const auto has = [](const std::vector<Method>& methods, Method wanted) {
    return std::find(methods.begin(), methods.end(), wanted) != methods.end();
  };
  const auto without = methods_of(sea(std::nullopt));
  EXPECT_FALSE(has(without, Method::tide_harmonic));
  EXPECT_FALSE(has(without, Method::tide_phase));
  EXPECT_TRUE(has(without, Method::day_mean));
  EXPECT_TRUE(has(without, Method::reference_slab));
  const auto ten_days = methods_of(sea(std::pair(end_of_day - days(10), end_of_day)));
  EXPECT_FALSE(has(ten_days, Method::tide_harmonic)) << "ten days of tide are not fifteen";
  EXPECT_TRUE(has(ten_days, Method::tide_phase));
  EXPECT_TRUE(has(methods_of(sea(std::pair(first, end_of_day))), Method::tide_harmonic));
}

}  // namespace
}  // namespace slackwater::calibration::tide_of_record_test
