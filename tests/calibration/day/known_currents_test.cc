#include "calibration/day/given/known_currents.h"
#include "calibration/day/truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "calibration/fuse/fusion_settings.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::known_currents_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using std::chrono::minutes;
using namespace tests;

const UtcDay day = parse_day("2024-06-11");
const UtcTime end_of_day = UtcTime(day) + days(1);
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::vector<double> product_depth_m{1, 5, 10, 20};

/// The plan of a day that was run at 05:00 of the next.
ForecastPlan plan_of(const std::string& dataset) {
  ForecastPlan plan;
  plan.day = day;
  plan.issued = end_of_day + hours(5);
  plan.dataset = dataset;
  plan.depth_m = product_depth_m;
  return plan;
}

/// A tide over a drift that changes with depth: no two values alike. Linear in depth, so that it is
/// brought to other depths exactly.
Horizontal water(UtcTime time, double depth_m) {
  const double hour = hours_between(UtcTime(day), time);
  return std::polar(0.4, 0.506 * hour) + Horizontal(0.1 - 0.004 * depth_m, 0.003 * depth_m);
}

std::vector<TimeCell> hourly_around_the_day() {
  return instants(UtcTime(day) - days(3), end_of_day + days(2));
}

KnownSeriesForTests product_alone() {
  KnownSeriesForTests sea;
  sea.current(analysis_of("model"), hourly_around_the_day(), product_depth_m, water);
  return sea;
}

/// A product, and an instrument that says the same plus `more`.
KnownSeriesForTests product_and_station(Horizontal more, double distance_m = 2100,
                                        const std::vector<double>& depth_m = {8, 12}) {
  KnownSeriesForTests sea = product_alone();
  sea.current(
      station_of("Buoy"), hourly_around_the_day(), depth_m,
      [more](UtcTime time, double depth) { return water(time, depth) + more; }, distance_m);
  return sea;
}

void expect_same(const Chosen<Horizontal>& a, const Chosen<Horizontal>& b) {
  EXPECT_EQ(a.column.time, b.column.time);
  EXPECT_EQ(a.column.levels_m, b.column.levels_m);
  EXPECT_EQ(a.column.value, b.column.value);
  EXPECT_EQ(a.column.status, b.column.status);
  EXPECT_EQ(a.origin, b.origin);
}

TEST(KnownCurrents, AProductAloneIsReturnedAsItIsUpToTheEndOfTheDay) {
  const KnownSeriesForTests sea = product_alone();
  const Chosen<Horizontal> known = known_currents(sea.data, plan_of("model")).record;
  ASSERT_EQ(known.column.times(), 4 * 24 + 1u) << "24:00 belongs to the day";
  ASSERT_EQ(known.origin.size(), known.column.times());
  for (std::size_t t = 0; t < known.column.times(); ++t) {
    for (std::size_t k = 0; k < product_depth_m.size(); ++k) {
      EXPECT_EQ(known.column.value[known.column.offset(t, k)],
                water(known.column.time[t].centre(), product_depth_m[k]));
    }
  }
  EXPECT_TRUE(known_currents(sea.data, plan_of("model")).remarks.notes.empty());
  EXPECT_TRUE(known_currents(sea.data, plan_of("unheard of")).record.empty());
}

TEST(KnownCurrents, NothingAfterTheEndOfTheDayIsUsed) {
  for (const std::string dataset : {"model", "Buoy"}) {
    const KnownSeriesForTests sea = product_and_station({0.1, 0.05});
    const Chosen<Horizontal> known = known_currents(sea.data, plan_of(dataset)).record;
    ColumnData spoilt = sea.data;
    spoil_all_after(spoilt, end_of_day);
    expect_same(known_currents(spoilt, plan_of(dataset)).record, known);
    spoil_all_after(spoilt, end_of_day - Duration(1));
    EXPECT_NE(known_currents(spoilt, plan_of(dataset)).record.column.value, known.column.value)
        << "24:00 is used";
  }
}

TEST(KnownCurrents, ADayThatIsOnlyForecastIsTheNewestForecastThatWasIssued) {
  KnownSeriesForTests sea;
  const auto whole_day = instants(UtcTime(day), end_of_day + days(2));
  const auto run = [&](UtcTime issued, double mark) {
    sea.current(forecast_of("model", issued), whole_day, {5}, steady({mark, 0}));
  };
  run(UtcTime(day) - hours(12), 1);
  run(UtcTime(day), 2);
  run(end_of_day + hours(6), 3);
  const Chosen<Horizontal> known = known_currents(sea.data, plan_of("model")).record;
  ASSERT_EQ(known.column.times(), 25u) << "the sea is known up to the end of D, forecast or not";
  EXPECT_EQ(known.column.value, std::vector<Horizontal>(25, Horizontal(2, 0)));
  EXPECT_EQ(known.column.source.front(), DataStatus::forecast);
}

TEST(KnownCurrents, ASurfaceProductWithoutADepthSpeaksOfTheSurface) {
  KnownSeriesForTests sea;
  sea.current(analysis_of("radar"), hourly_around_the_day(), {}, water);
  const Chosen<Horizontal> known = known_currents(sea.data, plan_of("radar")).record;
  EXPECT_EQ(known.column.levels_m, std::vector<double>{0.0});
  EXPECT_EQ(known.column.vertical, VerticalKind::depth_m);
}

/// What share of the instrument's constant difference the fused value has taken up. The instrument
/// hangs at a level of the product: between levels its word would overshoot at them by a hair.
std::vector<double> shares(double distance_m) {
  const Horizontal more(0.12, -0.07);
  const KnownSeriesForTests alone = product_alone();
  const KnownSeriesForTests both = product_and_station(more, distance_m, {10});
  const VectorColumn product = known_currents(alone.data, plan_of("model")).record.column;
  const VectorColumn fused = known_currents(both.data, plan_of("model")).record.column;
  EXPECT_EQ(fused.time, product.time);
  EXPECT_EQ(fused.levels_m, product.levels_m);
  std::vector<double> share;
  for (std::size_t i = 0; i < fused.value.size(); ++i) {
    const Horizontal taken = (fused.value[i] - product.value[i]) / more;
    EXPECT_NEAR(taken.imag(), 0, 1e-9) << "rounding of sums of a few hundred terms";
    share.push_back(taken.real());
  }
  return share;
}

TEST(KnownCurrents, FusedLiesBetweenTheProductAndTheInstrument) {
  for (const double distance : {100.0, 2000.0, 9999.0}) {
    for (const double share : shares(distance)) {
      EXPECT_GT(share, 0) << distance;
      EXPECT_LT(share, 1) << distance;
    }
  }
}

TEST(KnownCurrents, TheNearerTheInstrumentTheMoreItCounts) {
  const std::vector<double> near = shares(500);
  const std::vector<double> middle = shares(3000);
  const std::vector<double> far = shares(9000);
  for (std::size_t i = 0; i < near.size(); ++i) {
    EXPECT_GT(near[i], middle[i]);
    EXPECT_GT(middle[i], far[i]);
  }
}

TEST(KnownCurrents, AnInstrumentOutOfReachChangesNothing) {
  const KnownSeriesForTests alone = product_alone();
  const KnownSeriesForTests both = product_and_station({0.1, 0}, FusionSettings{}.farthest_m + 1);
  EXPECT_EQ(known_currents(both.data, plan_of("model")).record.column.value,
            known_currents(alone.data, plan_of("model")).record.column.value);
  EXPECT_TRUE(known_currents(both.data, plan_of("model")).remarks.notes.empty());
}

TEST(KnownCurrents, AllInstrumentsInReachAreFusedAndNamedTheNearestFirst) {
  KnownSeriesForTests sea = product_and_station({0.1, 0}, 3000);
  sea.current(station_of("Nearer"), hourly_around_the_day(), {8}, water, 1200);
  EXPECT_EQ(known_currents(sea.data, plan_of("model")).remarks.notes,
            (std::vector<std::string>{"fused with station Nearer at 1.2 km",
                                      "fused with station Buoy at 3.0 km"}));
  std::set<std::string> used;
  for (const Origin* origin : known_currents(sea.data, plan_of("model")).record.origin)
    used.insert(origin->dataset);
  EXPECT_EQ(used, (std::set<std::string>{"model", "Nearer", "Buoy"}))
      << "a number that is served can name its source";
  EXPECT_TRUE(known_currents(sea.data, plan_of("model")).remarks.troubles.empty());
}

/// The root mean square error of the record on D against the water.
double error_on_the_day(const KnownSeriesForTests& sea) {
  const VectorColumn known = known_currents(sea.data, plan_of("model")).record.column;
  double squares = 0;
  double count = 0;
  for (std::size_t t = 0; t < known.times(); ++t) {
    if (known.time[t].centre() < UtcTime(day)) continue;
    for (std::size_t k = 0; k < known.levels(); ++k) {
      squares += std::norm(known.value[known.offset(t, k)] -
                           water(known.time[t].centre(), known.levels_m[k]));
      ++count;
    }
  }
  return std::sqrt(squares / count);
}

TEST(KnownCurrents, TwoInstrumentsAreBetterThanEitherAndTheFarOneDoesNotDrownTheNear) {
  // A product that errs by 12 cm/s; each place differs from the site by a few.
  const auto sea_with = [](bool near, bool far) {
    KnownSeriesForTests sea;
    sea.current(analysis_of("model"), hourly_around_the_day(), product_depth_m,
                [](UtcTime time, double depth) {
                  return water(time, depth) + Horizontal{0.12, 0};
                });
    const auto away = [](Horizontal by) {
      return [by](UtcTime time, double depth) { return water(time, depth) + by; };
    };
    if (near) sea.current(station_of("Near"), hourly_around_the_day(), {8}, away({0, 0.02}), 500);
    if (far) sea.current(station_of("Far"), hourly_around_the_day(), {8}, away({0, -0.06}), 8000);
    return error_on_the_day(sea);
  };
  const double both = sea_with(true, true);
  EXPECT_LT(sea_with(true, false), sea_with(false, true));
  EXPECT_LT(both, sea_with(true, false));
}

TEST(KnownCurrents, AnInstrumentThatLiesIsLeftOutNamedAndATrouble) {
  const KnownSeriesForTests alone = product_alone();
  KnownSeriesForTests sea = product_and_station({1, 0});
  EXPECT_EQ(known_currents(sea.data, plan_of("model")).record.column.value,
            known_currents(alone.data, plan_of("model")).record.column.value);
  const auto notes = known_currents(sea.data, plan_of("model")).remarks.notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].find("station Buoy at 2.1 km is not used: it differs from the product by 1.00 "
                          "m/s on average over 4.0 days; expected at most "),
            0U)
      << notes[0];
  const auto troubles = known_currents(sea.data, plan_of("model")).remarks.troubles;
  ASSERT_EQ(troubles.size(), 1U);
  EXPECT_EQ(troubles[0].station, "Buoy");
  EXPECT_EQ(troubles[0].clause, notes[0]);
  // An honest one beside it is used all the same.
  sea.current(station_of("Honest"), hourly_around_the_day(), {8}, water, 3000);
  EXPECT_EQ(known_currents(sea.data, plan_of("model")).remarks.notes.back(),
            "fused with station Honest at 3.0 km");
}

TEST(KnownCurrents, OneThatEndedLongBeforeIsNotSaidToBeFused) {
  for (const auto& [hours_before, is_used] : {std::pair{96, false}, std::pair{30, true}}) {
    KnownSeriesForTests sea;
    sea.current(analysis_of("model"), instants(UtcTime(day) - days(9), end_of_day), product_depth_m,
                water);
    sea.current(station_of("Buoy"),
                instants(UtcTime(day) - days(9), end_of_day - hours(hours_before)), {8, 12}, water,
                2100);
    const auto notes = known_currents(sea.data, plan_of("model")).remarks.notes;
    const auto expected =
        is_used ? std::vector<std::string>{"fused with station Buoy at 2.1 km",
                                           "station Buoy at 2.1 km: its last good value is 30 h "
                                           "before the end of the day"}
                : std::vector<std::string>{
                      "station Buoy at 2.1 km is not used: it ended 4.0 days before"};
    EXPECT_EQ(notes, expected);
    EXPECT_TRUE(known_currents(sea.data, plan_of("model")).remarks.troubles.empty())
        << "late, not lying";
    std::set<std::string> used;
    for (const Origin* origin : known_currents(sea.data, plan_of("model")).record.origin)
      used.insert(origin->dataset);
    EXPECT_EQ(used.contains("Buoy"), is_used);
  }
}

TEST(KnownCurrents, AnInstrumentThatIsStuckToTheEndIsATroubleThoughItsPastIsUsed) {
  KnownSeriesForTests sea = product_alone();
  sea.current(
      station_of("Buoy"), hourly_around_the_day(), {8, 12},
      [](UtcTime time, double depth) {
        return water(std::min(time, UtcTime(end_of_day - hours(48))), depth);
      },
      2100);
  const auto notes = known_currents(sea.data, plan_of("model")).remarks.notes;
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0], "fused with station Buoy at 2.1 km");
  EXPECT_EQ(
      notes[1],
      "station Buoy at 2.1 km: 2.0 days left out because the value never changed; its last good "
      "value is 2.0 days before the end of the day");
  ASSERT_EQ(known_currents(sea.data, plan_of("model")).remarks.troubles.size(), 1U);
  EXPECT_LT(error_on_the_day(sea), 1e-9) << "the product is right, and nothing pulls it away";
}

TEST(KnownCurrents, AStatedErrorChangesTheWeight) {
  const Horizontal more(0.12, -0.07);
  const auto taken = [&](std::optional<double> stated) {
    KnownSeriesForTests sea = product_alone();
    Origin origin = station_of("Buoy");
    origin.stated_error_m_s = stated;
    sea.current(
        origin, hourly_around_the_day(), {10},
        [&](UtcTime time, double depth) { return water(time, depth) + more; }, 2100);
    const VectorColumn fused = known_currents(sea.data, plan_of("model")).record.column;
    const std::size_t o = fused.offset(fused.times() - 1, 2);
    return ((fused.value[o] - water(end_of_day, 10)) / more).real();
  };
  EXPECT_EQ(taken(0.01), taken(std::nullopt)) << "no better than profilers are";
  EXPECT_LT(taken(0.1), 0.7 * taken(std::nullopt));
  EXPECT_LT(taken(0.3), 0.3 * taken(std::nullopt));
}

TEST(KnownCurrents, ASeriesThatContradictsACoarserProductDoesNotLead) {
  const auto sea_with = [](Horizontal bias) {
    KnownSeriesForTests sea;
    sea.current(analysis_of("daily"), means(UtcTime(day) - days(6), end_of_day, hours(24)),
                product_depth_m, steady({0.1, 0}));
    sea.current(
        station_of("Buoy"), instants(UtcTime(day) - days(6), end_of_day, minutes(30)), {8, 12},
        [bias](UtcTime time, double depth) { return water(time, depth) + bias; }, 2100);
    return sea;
  };
  const UtcTime issued = end_of_day + hours(5);
  EXPECT_EQ(trusted_currents(sea_with({}).data, day, issued)->dataset, "Buoy");
  EXPECT_FALSE(known_currents(sea_with({}).data, plan_of("Buoy")).is_contradicted);
  const KnownSeriesForTests lying = sea_with({1, 0.5});
  EXPECT_EQ(trusted_currents(lying.data, day, issued)->dataset, "daily");
  EXPECT_EQ(known_currents(lying.data, plan_of("daily")).remarks.troubles.size(), 1U);
  EXPECT_TRUE(known_currents(lying.data, plan_of("Buoy")).is_contradicted);
  EXPECT_EQ(trusted_currents(lying.data, day, issued)->record.column.value,
            known_currents(lying.data, plan_of("daily")).record.column.value);
}

TEST(KnownCurrents, AStationBesideAnotherWithoutAProductIsNamedAsNotUsed) {
  KnownSeriesForTests sea;
  sea.current(station_of("Buoy"), hourly_around_the_day(), {8}, water, 400);
  sea.current(station_of("Other"), hourly_around_the_day(), {8}, water, 3000);
  EXPECT_EQ(
      known_currents(sea.data, plan_of("Buoy")).remarks.notes,
      (std::vector<std::string>{
          "currents of station Buoy at 0.4 km alone, no product",
          "station Other at 3.0 km is not used: no current product is stored to combine it with"}));
}

TEST(KnownCurrents, WhereTheSeriesLeadsItsTimesAndDepthsAreKept) {
  KnownSeriesForTests sea;
  const Horizontal coarse(0.2, 0.1);
  const Horizontal fine(0.3, -0.1);
  const auto every_ten_minutes = instants(UtcTime(day) - days(2), end_of_day, minutes(10));
  sea.current(analysis_of("model"), means(UtcTime(day) - days(3), end_of_day, hours(24)), {1, 20},
              steady(coarse));
  sea.current(station_of("Buoy"), every_ten_minutes, {8, 30}, steady(fine), 2100);
  const VectorColumn fused = known_currents(sea.data, plan_of("Buoy")).record.column;
  ASSERT_EQ(fused.time, every_ten_minutes);
  ASSERT_EQ(fused.levels_m, (std::vector<double>{8, 30}));
  for (std::size_t t = 0; t < fused.times(); ++t) {
    const Horizontal share = (fused.value[fused.offset(t, 0)] - coarse) / (fine - coarse);
    EXPECT_GT(share.real(), 0);
    EXPECT_LT(share.real(), 1);
    EXPECT_NEAR(share.imag(), 0, 1e-9);
    EXPECT_EQ(fused.value[fused.offset(t, 1)], fine) << "below the product the series itself";
  }
  EXPECT_EQ(
      known_currents(sea.data, plan_of("Buoy")).remarks.notes,
      std::vector<std::string>{"currents of station Buoy at 2.1 km fused with a coarser product"});
}

TEST(KnownCurrents, ASeriesWithoutAProductStandsAlone) {
  KnownSeriesForTests sea;
  sea.current(station_of("Buoy"), hourly_around_the_day(), {8}, water, 400);
  const VectorColumn known = known_currents(sea.data, plan_of("Buoy")).record.column;
  ASSERT_EQ(known.times(), 4 * 24 + 1u);
  for (std::size_t t = 0; t < known.times(); ++t)
    EXPECT_EQ(known.value[t], water(known.time[t].centre(), 8));
  EXPECT_EQ(known_currents(sea.data, plan_of("Buoy")).remarks.notes,
            std::vector<std::string>{"currents of station Buoy at 0.4 km alone, no product"});
}

TEST(KnownCurrents, TurningTheSeaTurnsTheRecord) {
  const Horizontal by = std::polar(1.0, 0.7);
  for (const std::string dataset : {"model", "Buoy"}) {
    KnownSeriesForTests sea = product_and_station({0.1, 0.05});
    const VectorColumn straight = known_currents(sea.data, plan_of(dataset)).record.column;
    turn(sea.data.current, by);
    const VectorColumn turned = known_currents(sea.data, plan_of(dataset)).record.column;
    ASSERT_EQ(turned.value.size(), straight.value.size());
    for (std::size_t i = 0; i < turned.value.size(); ++i)
      EXPECT_NEAR(std::abs(turned.value[i] - by * straight.value[i]), 0, 1e-12) << "rounding";
  }
}

TEST(TruthOf, IsWhatWasAnalysedAfterTheInstantThatBelongsToTheDay) {
  const KnownSeriesForTests sea = product_alone();
  const Chosen<Horizontal> truth = truth_of(sea.data, "model", end_of_day, end_of_day + days(1));
  ASSERT_EQ(truth.column.times(), 24u);
  EXPECT_EQ(truth.column.time.front(), TimeCell::instant(end_of_day + hours(1)));
  EXPECT_EQ(truth.column.time.back(), TimeCell::instant(end_of_day + days(1)));
  EXPECT_EQ(truth.origin.size(), 24u);
  for (std::size_t t = 0; t < 24; ++t) {
    EXPECT_EQ(truth.column.value[truth.column.offset(t, 2)],
              water(truth.column.time[t].centre(), product_depth_m[2]));
  }
}

TEST(TruthOf, AForecastIsNeverTheTruth) {
  KnownSeriesForTests sea;
  sea.current(analysis_of("model"), instants(UtcTime(day), end_of_day + hours(3)), {5},
              steady({1, 0}));
  sea.current(forecast_of("model", end_of_day + hours(2)),
              instants(end_of_day, end_of_day + days(1)), {5}, steady({2, 0}));
  const Chosen<Horizontal> truth = truth_of(sea.data, "model", end_of_day, end_of_day + days(1));
  EXPECT_EQ(truth.column.value, std::vector<Horizontal>(3, Horizontal(1, 0)));
  EXPECT_TRUE(truth_of(sea.data, "model", end_of_day + days(1), end_of_day + days(2)).empty());
}

/// Who is the truth of the product's forecast where a station with these depths stands there.
std::string truth_beside(double distance_m, const std::vector<double>& depth_m,
                         const std::vector<TimeCell>& time, bool with_product = true) {
  KnownSeriesForTests sea;
  if (with_product) sea = product_alone();
  sea.current(station_of("Buoy"), time, depth_m, steady({1, 0}), distance_m);
  const Chosen<Horizontal> truth = truth_of(sea.data, "model", end_of_day, end_of_day + days(1));
  return truth.origin.empty() ? "" : truth.origin.front()->dataset;
}

TEST(TruthOf, IsTheInstrumentWhereItStandsNearAndSpeaksOfTheSameDepths) {
  const auto always = hourly_around_the_day();
  EXPECT_EQ(truth_beside(0, {8}, always), "Buoy");
  EXPECT_EQ(truth_beside(5000, {8}, always), "Buoy");
  EXPECT_EQ(truth_beside(5001, {8}, always), "model");
  EXPECT_EQ(truth_beside(5001, {8}, always, false), "Buoy") << "no current product is stored";
  EXPECT_EQ(truth_beside(0, {1}, always), "Buoy");
  EXPECT_EQ(truth_beside(0, {20, 40}, always), "Buoy") << "one depth within is enough";
  EXPECT_EQ(truth_beside(0, {0.5, 25}, always), "model") << "the product does not reach there";
  EXPECT_EQ(truth_beside(0, {8}, instants(UtcTime(day), end_of_day)), "model")
      << "silent after the day";
}

TEST(TruthOf, IsNotFused) {
  const KnownSeriesForTests sea = product_and_station({0.1, 0});
  const Chosen<Horizontal> truth = truth_of(sea.data, "model", end_of_day, end_of_day + days(1));
  ASSERT_EQ(truth.column.levels_m, (std::vector<double>{8, 12}));
  EXPECT_EQ(truth.column.value[0], water(end_of_day + hours(1), 8) + Horizontal(0.1, 0));
}

TEST(KnownBeside, IsTheTruthsOwnRecordUnfused) {
  const KnownSeriesForTests sea = product_and_station({0.1, 0});
  const Chosen<Horizontal> truth = truth_of(sea.data, "model", end_of_day, end_of_day + days(1));
  const Chosen<Horizontal> known = known_beside(truth, sea.data, plan_of("model"));
  EXPECT_EQ(known.column.levels_m, truth.column.levels_m);
  ASSERT_EQ(known.column.times(), 4 * 24 + 1u) << "nothing after the day";
  for (std::size_t t = 0; t < known.column.times(); ++t) {
    EXPECT_EQ(known.column.value[known.column.offset(t, 1)],
              water(known.column.time[t].centre(), 12) + Horizontal(0.1, 0));
  }
}

TEST(KnownBeside, IsTheProductBroughtToTheDepthsOfAStationThatWasSilentOnTheDay) {
  KnownSeriesForTests sea = product_alone();
  sea.current(station_of("Buoy"), instants(end_of_day + hours(1), end_of_day + days(1)), {8, 30},
              steady({1, 0}), 100);
  const Chosen<Horizontal> truth = truth_of(sea.data, "model", end_of_day, end_of_day + days(1));
  ASSERT_EQ(truth.origin.front()->dataset, "Buoy");
  const Chosen<Horizontal> known = known_beside(truth, sea.data, plan_of("model"));
  ASSERT_EQ(known.column.levels_m, truth.column.levels_m);
  ASSERT_EQ(known.column.times(), 4 * 24 + 1u);
  for (std::size_t t = 0; t < known.column.times(); ++t) {
    const Horizontal expected = water(known.column.time[t].centre(), 8);
    EXPECT_NEAR(std::abs(known.column.value[known.column.offset(t, 0)] - expected), 0, 1e-14);
    EXPECT_FALSE(known.column.has(t, 1)) << "below the product nothing is known";
  }
}

TEST(KnownCurrents, GapsStayGaps) {
  KnownSeriesForTests sea;
  sea.current(analysis_of("model"), instants(UtcTime(day), end_of_day), {5, 10},
              [](UtcTime time, double depth) {
                return time == UtcTime(day) + hours(3) && depth > 6 ? Horizontal(nan, nan)
                                                                    : Horizontal(1, 0);
              });
  const VectorColumn known = known_currents(sea.data, plan_of("model")).record.column;
  EXPECT_EQ(std::count(known.status.begin(), known.status.end(), SampleStatus::missing), 1);
  EXPECT_FALSE(known.has(3, 1));
}

}  // namespace
}  // namespace slackwater::calibration::known_currents_test
