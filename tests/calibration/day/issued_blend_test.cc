#include "calibration/day/issued_blend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "calibration/day/column/methods.h"
#include "calibration/day/given/known_currents.h"
#include "tests/support/known_series_for_tests.h"
#include "tests/support/reference_profile.h"

namespace slackwater::calibration::issued_blend_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcDay day = parse_day("2024-06-11");
const UtcTime end_of_day = UtcTime(day) + days(1);
const std::vector<double> depth_m{2, 8};
const std::size_t levels = depth_m.size();
constexpr std::size_t members = 4;

ForecastPlan plan_to(int lead_h) {
  ForecastPlan plan;
  plan.day = day;
  plan.issued = end_of_day + hours(5);
  plan.dataset = "model";
  plan.depth_m = depth_m;
  for (int h = 0; h <= lead_h; ++h) plan.stamps.push_back(end_of_day + hours(h));
  return plan;
}

/// With a record that holds no tide.
KnownColumn known_column(const ColumnData& data, const ForecastPlan& plan) {
  return {known_currents(data, plan).record, {}, known_provider(data, plan)};
}

/// What the sea did: every hour and depth its own value.
Horizontal water(UtcTime time, double depth) {
  const double hour = hours_between(UtcTime(day), time);
  return std::polar(0.3, 0.4 * hour) + Horizontal(0.1, 0.01 * depth);
}

KnownSeriesForTests known_sea() {
  KnownSeriesForTests sea;
  sea.current(analysis_of("model"), instants(end_of_day - days(4), end_of_day), depth_m, water);
  return sea;
}

/// Our own forecast, made up: no two values alike; members spread evenly around it.
ForecastColumn own_forecast(const ForecastPlan& plan) {
  ForecastColumn column;
  column.point = GeoPoint::from_degrees(54.0, 6.5);
  column.water_depth_m = 30;
  const std::size_t size = plan.stamps.size() * levels;
  for (std::size_t i = 0; i < size; ++i) {
    column.current_m_s.emplace_back(0.01 * double(i), -0.02 * double(i));
    column.current_sigma_m_s.push_back(0.05 + 0.001 * double(i));
    column.current_status.push_back(SampleStatus::ok);
  }
  for (std::size_t m = 0; m < members; ++m) {
    for (std::size_t i = 0; i < size; ++i)
      column.member_m_s.push_back(column.current_m_s[i] + std::polar(0.05, 1.6 * double(m)));
  }
  return column;
}

/// Weights by method; all others are 0.
Earned earned(const std::map<Method, double>& weight, double scale = 1) {
  Earned result;
  for (const Method method : candidate_methods()) {
    const auto found = weight.find(method);
    result.blend.share.push_back({method, found == weight.end() ? 0 : found->second, 0, {}});
  }
  result.spread.scale = scale;
  return result;
}

ForecastColumn issued(const ColumnData& data, const std::map<Method, double>& weight,
                      double scale = 1, int lead_h = 24) {
  const ForecastPlan plan = plan_to(lead_h);
  ForecastColumn column = own_forecast(plan);
  issue_blend(column, data, known_column(data, plan), plan, earned(weight, scale));
  return column;
}

TEST(IssueBlend, OurOwnForecastAloneIsIssuedAsItIs) {
  const KnownSeriesForTests sea = known_sea();
  const ForecastColumn own = own_forecast(plan_to(24));
  const ForecastColumn column = issued(sea.data, {{Method::forecast, 1.0}});
  EXPECT_EQ(column.current_m_s, own.current_m_s);
  EXPECT_EQ(column.current_sigma_m_s, own.current_sigma_m_s);
  for (std::size_t i = 0; i < column.member_m_s.size(); ++i)
    EXPECT_LT(std::abs(column.member_m_s[i] - own.member_m_s[i]), 1e-15) << "rounding";
}

TEST(IssueBlend, ACandidateWithAllTheWeightIsIssued) {
  const KnownSeriesForTests sea = known_sea();
  const ForecastPlan plan = plan_to(24);
  const ForecastColumn persisted = issued(sea.data, {{Method::persistence, 1.0}});
  const ForecastColumn repeated = issued(sea.data, {{Method::same_hour, 1.0}});
  for (std::size_t t = 0; t < plan.stamps.size(); ++t) {
    for (std::size_t k = 0; k < levels; ++k) {
      EXPECT_EQ(persisted.current_m_s[t * levels + k], water(end_of_day, depth_m[k]));
      EXPECT_EQ(repeated.current_m_s[t * levels + k], water(plan.stamps[t] - days(1), depth_m[k]));
    }
  }
}

TEST(IssueBlend, IsTheWeightedMeanOfItsCandidates) {
  const KnownSeriesForTests sea = known_sea();
  const ForecastColumn own = own_forecast(plan_to(24));
  const ForecastColumn persisted = issued(sea.data, {{Method::persistence, 1.0}});
  const ForecastColumn repeated = issued(sea.data, {{Method::same_hour, 1.0}});
  const ForecastColumn blend = issued(
      sea.data, {{Method::forecast, 0.5}, {Method::persistence, 0.3}, {Method::same_hour, 0.2}});
  for (std::size_t i = 0; i < blend.current_m_s.size(); ++i) {
    const Horizontal expected =
        0.5 * own.current_m_s[i] + 0.3 * persisted.current_m_s[i] + 0.2 * repeated.current_m_s[i];
    EXPECT_LT(std::abs(blend.current_m_s[i] - expected), 1e-14) << i;
  }
}

TEST(IssueBlend, IdenticalCandidatesBlendToThemselves) {
  const Horizontal everywhere(0.3, -0.2);
  KnownSeriesForTests sea;
  sea.current(analysis_of("model"), instants(end_of_day - days(4), end_of_day), depth_m,
              steady(everywhere));
  const ForecastPlan plan = plan_to(24);
  ForecastColumn column = own_forecast(plan);
  std::fill(column.current_m_s.begin(), column.current_m_s.end(), everywhere);
  issue_blend(column, sea.data, known_column(sea.data, plan), plan,
              earned({{Method::forecast, 0.37},
                      {Method::persistence, 0.21},
                      {Method::day_mean, 0.13},
                      {Method::same_hour, 0.29}}));
  for (const Horizontal value : column.current_m_s)
    EXPECT_LT(std::abs(value - everywhere), 1e-15) << "weights sum to one up to rounding";
}

TEST(IssueBlend, TheWeightOfACandidateThatIsAbsentGoesToTheOthers) {
  const KnownSeriesForTests sea = known_sea();  // no provider's forecast in it
  const ForecastColumn with = issued(
      sea.data, {{Method::forecast, 0.3}, {Method::persistence, 0.2}, {Method::provider, 0.5}});
  const ForecastColumn without =
      issued(sea.data, {{Method::forecast, 0.6}, {Method::persistence, 0.4}});
  for (std::size_t i = 0; i < with.current_m_s.size(); ++i)
    EXPECT_LT(std::abs(with.current_m_s[i] - without.current_m_s[i]), 1e-14);
  const ForecastColumn alone = issued(sea.data, {{Method::provider, 1.0}});
  EXPECT_EQ(alone.current_m_s, own_forecast(plan_to(24)).current_m_s)
      << "where no candidate has a value our own stays";
}

TEST(IssueBlend, TheProvidersForecastFadesWhereItEnds) {
  KnownSeriesForTests sea = known_sea();
  const Horizontal provided(0.6, 0.6);
  sea.current(forecast_of("model", end_of_day - hours(6)),
              instants(end_of_day - hours(6), end_of_day + hours(12)), depth_m, steady(provided));
  sea.current(forecast_of("model", end_of_day + hours(6)),
              instants(end_of_day + hours(6), end_of_day + hours(24)), depth_m,
              steady({9, 9}));  // issued an hour after the forecast: never seen
  const ForecastColumn column =
      issued(sea.data, {{Method::forecast, 0.5}, {Method::provider, 0.5}});
  const ForecastColumn own = own_forecast(plan_to(24));
  for (std::size_t i = 0; i < column.current_m_s.size(); ++i) {
    const double presence = std::clamp((13.0 - static_cast<double>(i / levels)) / 6, 0.0, 1.0);
    const Horizontal expected = (own.current_m_s[i] + presence * provided) / (1 + presence);
    EXPECT_LT(std::abs(column.current_m_s[i] - expected), 1e-14) << i;
  }
}

TEST(IssueBlend, ARunOfTheIssueMorningIsUsed) {
  KnownSeriesForTests sea = known_sea();
  const Horizontal provided(0.6, 0.6);
  sea.current(forecast_of("model", end_of_day), instants(end_of_day, end_of_day + hours(24)),
              depth_m, steady(provided));
  const ForecastColumn column = issued(sea.data, {{Method::provider, 1.0}});
  for (const Horizontal value : column.current_m_s) EXPECT_LT(std::abs(value - provided), 1e-14);
}

TEST(IssueBlend, ARunIsUsedFromItsPublicationOrFromWhenItCameIn) {
  const Horizontal provided(0.6, 0.6);
  const auto issued_with = [&](Duration published_after, std::optional<UtcTime> received) {
    KnownSeriesForTests sea = known_sea();
    Origin run = forecast_of("model", end_of_day);
    run.published_after = published_after;
    run.received = received;
    sea.current(run, instants(end_of_day, end_of_day + hours(24)), depth_m, steady(provided));
    return issued(sea.data, {{Method::forecast, 0.5}, {Method::provider, 0.5}}).current_m_s;
  };
  const std::vector<Horizontal> own = own_forecast(plan_to(24)).current_m_s;
  EXPECT_NE(issued_with(hours(5), {}), own) << "at the hour of issue";
  EXPECT_EQ(issued_with(hours(12), {}), own) << "at noon, seven hours late";
  EXPECT_NE(issued_with(hours(12), end_of_day + hours(4)), own) << "early, and in hand";
  EXPECT_EQ(issued_with(hours(12), end_of_day + days(30)), own) << "from an archive";
}

TEST(IssueBlend, WeightsPassSmoothlyFromOneDayOfLeadToTheNext) {
  const KnownSeriesForTests sea = known_sea();
  const ForecastPlan plan = plan_to(72);
  Earned weights = earned({{Method::forecast, 1.0}});
  weights.later = {earned({{Method::persistence, 1.0}}).blend,
                   earned({{Method::forecast, 0.5}, {Method::persistence, 0.5}}).blend};
  const ForecastColumn own = own_forecast(plan);
  ForecastColumn column = own;
  issue_blend(column, sea.data, known_column(sea.data, plan), plan, weights);
  const std::map<int, double> of_persistence{{0, 0},     {12, 0},   {24, 0.5}, {36, 1},
                                             {48, 0.75}, {60, 0.5}, {72, 0.5}};
  for (const auto& [h, weight] : of_persistence) {
    for (std::size_t k = 0; k < levels; ++k) {
      const std::size_t o = static_cast<std::size_t>(h) * levels + k;
      const Horizontal expected =
          (1 - weight) * own.current_m_s[o] + weight * water(end_of_day, depth_m[k]);
      EXPECT_LT(std::abs(column.current_m_s[o] - expected), 1e-13) << h;
    }
  }
}

TEST(IssueBlend, MembersKeepTheirDeparturesScaledAsTheBandIs) {
  const KnownSeriesForTests sea = known_sea();
  const double scale = 1.7;
  const ForecastColumn own = own_forecast(plan_to(24));
  const ForecastColumn column =
      issued(sea.data, {{Method::forecast, 0.5}, {Method::persistence, 0.5}}, scale);
  const std::size_t size = own.current_m_s.size();
  ASSERT_EQ(column.member_m_s.size(), members * size);
  for (std::size_t i = 0; i < column.member_m_s.size(); ++i) {
    const std::size_t o = i % size;
    const Horizontal before = own.member_m_s[i] - own.current_m_s[o];
    EXPECT_LT(std::abs(column.member_m_s[i] - column.current_m_s[o] - scale * before), 1e-14);
  }
  for (std::size_t o = 0; o < size; ++o)
    EXPECT_DOUBLE_EQ(column.current_sigma_m_s[o], scale * own.current_sigma_m_s[o]);
}

TEST(IssueBlend, EachDayOfLeadHasItsOwnFactorWithoutAJump) {
  const KnownSeriesForTests sea = known_sea();
  const ForecastPlan plan = plan_to(72);
  const ForecastColumn own = own_forecast(plan);
  Earned past = earned({{Method::forecast, 1.0}}, 0.9);
  past.spread.later = {{1.3, 5, 0.7}, {1.1, 5, 0.75}};
  ForecastColumn column = own;
  issue_blend(column, sea.data, known_column(sea.data, plan), plan, past);
  const auto factor = [&](std::size_t hour) {
    return column.current_sigma_m_s[hour * levels] / own.current_sigma_m_s[hour * levels];
  };
  EXPECT_NEAR(factor(12), 0.9, 1e-12);
  EXPECT_NEAR(factor(36), 1.3, 1e-12);
  EXPECT_NEAR(factor(60), 1.1, 1e-12);
  for (std::size_t h = 1; h <= 72; ++h) EXPECT_LT(std::abs(factor(h) - factor(h - 1)), 0.07);
  const std::size_t size = own.current_m_s.size();
  for (std::size_t i = 0; i < own.member_m_s.size(); ++i) {
    const std::size_t o = i % size;
    const Horizontal expected = factor(o / levels) * (own.member_m_s[i] - own.current_m_s[o]);
    EXPECT_LT(std::abs(column.member_m_s[i] - column.current_m_s[o] - expected), 1e-12);
  }
}

TEST(IssueBlend, QuantilesStandInOrderAboutTheIssuedCentre) {
  const KnownSeriesForTests sea = known_sea();
  Snapshot snapshot;
  const ForecastPlan plan = plan_to(24);
  snapshot.time = plan.stamps;
  snapshot.depth_m = plan.depth_m;
  snapshot.columns = {issued(sea.data, {{Method::forecast, 0.4}, {Method::day_mean, 0.6}}, 0.6)};
  for (const UtcTime stamp : plan.stamps) {
    std::vector<CurrentSample> samples(levels);
    reference_profile(snapshot, 0, stamp, depth_m, samples);
    for (const CurrentSample& sample : samples) {
      ASSERT_EQ(sample.status, SampleStatus::ok);
      const CurrentQuantiles q = quantiles_of(sample);
      EXPECT_LT(q.p10_m_s.real(), q.p50_m_s.real());
      EXPECT_LT(q.p50_m_s.real(), q.p90_m_s.real());
      EXPECT_LT(q.p10_m_s.imag(), q.p50_m_s.imag());
      EXPECT_LT(q.p50_m_s.imag(), q.p90_m_s.imag());
      EXPECT_EQ(q.p50_m_s, sample.velocity_m_s);
    }
  }
}

TEST(IssueBlend, WhatHasNoValueIsGivenNone) {
  const KnownSeriesForTests sea = known_sea();
  const ForecastPlan plan = plan_to(6);
  ForecastColumn column = own_forecast(plan);
  for (std::size_t t = 0; t < plan.stamps.size(); ++t) {
    column.current_status[t * levels + 1] = SampleStatus::below_bed;
    column.current_m_s[t * levels + 1] = {};
  }
  const std::vector<SampleStatus> status = column.current_status;
  issue_blend(column, sea.data, known_column(sea.data, plan), plan,
              earned({{Method::persistence, 1.0}}));
  EXPECT_EQ(column.current_status, status);
  for (std::size_t t = 0; t < plan.stamps.size(); ++t)
    EXPECT_EQ(column.current_m_s[t * levels + 1], Horizontal{});
}

TEST(IssueBlend, NothingAfterTheDayMatters) {
  KnownSeriesForTests sea = known_sea();
  sea.current(analysis_of("model", 5), instants(end_of_day + hours(1), end_of_day + days(2)),
              depth_m, water);
  const std::map<Method, double> weight{{Method::forecast, 0.4},
                                        {Method::persistence, 0.2},
                                        {Method::same_hour, 0.2},
                                        {Method::day_mean, 0.2}};
  ColumnData spoilt = sea.data;
  spoil_all_after(spoilt, end_of_day);
  EXPECT_EQ(issued(spoilt, weight).current_m_s, issued(sea.data, weight).current_m_s);
}

TEST(IssueBlend, TheSlabOfAPersistedWindSeesNoWindAfterTheDay) {
  KnownSeriesForTests sea = known_sea();
  const auto blow = [](UtcTime time, double) {
    return Horizontal(10 + 0.1 * hours_between(end_of_day, time), 3);
  };
  // Three-hourly stamps that miss the end of D: a line to the next one would look ahead.
  sea.wind(analysis_of("wind"),
           instants(end_of_day - days(4) - hours(1), end_of_day + hours(2), hours(3)), blow);
  ColumnData spoilt = sea.data;
  spoil_all_after(spoilt, end_of_day);
  const auto slab = [](const ColumnData& data) {
    ForecastPlan plan = plan_to(24);
    plan.wind = WindPolicy::persist;
    ForecastColumn column = own_forecast(plan);
    issue_blend(column, data, known_column(data, plan), plan,
                earned({{Method::reference_slab, 1.0}}));
    return column.current_m_s;
  };
  EXPECT_NE(slab(sea.data), own_forecast(plan_to(24)).current_m_s) << "the slab has a say";
  EXPECT_EQ(slab(spoilt), slab(sea.data));
}

std::vector<Method> available(const ColumnData& data) {
  const ForecastPlan plan = plan_to(24);
  const std::vector<bool> found =
      available_candidates(own_forecast(plan), data, known_column(data, plan), plan);
  const std::vector<Method> methods = candidate_methods();
  EXPECT_EQ(found.size(), methods.size());
  std::vector<Method> result;
  for (std::size_t c = 0; c < methods.size(); ++c)
    if (found[c]) result.push_back(methods[c]);
  return result;
}

TEST(AvailableCandidates, AreThoseThatTheRecordAllows) {
  using Methods = std::vector<Method>;
  KnownSeriesForTests sea = known_sea();
  EXPECT_EQ(available(sea.data),
            (Methods{Method::forecast, Method::reference_slab, Method::tide_phase, Method::day_mean,
                     Method::same_hour, Method::persistence}));
  sea.current(forecast_of("model", end_of_day - hours(6)),
              instants(end_of_day - hours(6), end_of_day + days(2)), depth_m, water);
  EXPECT_EQ(available(sea.data),
            (Methods{Method::forecast, Method::provider, Method::reference_slab, Method::tide_phase,
                     Method::day_mean, Method::same_hour, Method::persistence, Method::merged}));
  sea.current(analysis_of("model", 7), instants(end_of_day - days(20), end_of_day - days(4)),
              depth_m, water);
  EXPECT_EQ(available(sea.data), candidate_methods()) << "a record of more than 15 days";
}

TEST(AvailableCandidates, NeverHoldTheOracle) {
  for (const Method method : candidate_methods()) EXPECT_NE(method, Method::oracle_mean);
}

}  // namespace
}  // namespace slackwater::calibration::issued_blend_test
