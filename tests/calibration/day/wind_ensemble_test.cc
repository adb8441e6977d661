#include "calibration/day/given/wind_ensemble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::wind_ensemble_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcTime end_of_day = parse_utc("2024-06-12T00:00:00Z");
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<UtcTime> stamps_to(int lead_h) {
  std::vector<UtcTime> stamps;
  for (int h = 0; h <= lead_h; ++h) stamps.push_back(end_of_day + hours(h));
  return stamps;
}

Origin member_of(const std::string& dataset, UtcTime issued, int number, std::int64_t granule = 2) {
  Origin origin = forecast_of(dataset, issued, granule);
  origin.ensemble_member = number;
  return origin;
}

/// Member n blows n m/s to the east, and its hour of lead to the north.
FlowForTests of_member(int number) {
  return [=](UtcTime time, double) { return Horizontal(number, hours_between(end_of_day, time)); };
}

/// Adds the members [1, last] of a run, three-hourly.
void add_run(KnownSeriesForTests& sea, const std::string& dataset, UtcTime issued, int last,
             int reach_h = 96) {
  for (int n = last; n >= 1; --n) {
    sea.wind(member_of(dataset, issued, n, 100 + n),
             instants(issued, issued + hours(reach_h), hours(3)), of_member(n));
  }
}

const Knowledge all_known{};
Knowledge issued_by(UtcTime time) { return {time, time}; }

TEST(NewestWindEnsemble, IsTheNewestThatIsKnown) {
  KnownSeriesForTests sea;
  for (const int issued_h : {-24, -12, 0, 6}) add_run(sea, "ens", end_of_day + hours(issued_h), 6);
  const auto stamps = stamps_to(72);
  for (const int known_h : {-24, -12, 0, 6}) {
    const UtcTime issued = end_of_day + hours(known_h);
    const auto found = newest_wind_ensemble(sea.data.wind, issued_by(issued + hours(2)), stamps);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->run.reference_time, issued);
    EXPECT_EQ(found->run.number, (std::vector{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(found->run.dataset, "ens");
    EXPECT_EQ(found->run.origins.size(), 6U);
  }
  EXPECT_FALSE(newest_wind_ensemble(sea.data.wind, issued_by(end_of_day - hours(25)), stamps));
}

TEST(NewestWindEnsemble, NeedsFiveMembersThatReachADay) {
  const auto stamps = stamps_to(72);
  KnownSeriesForTests few;
  add_run(few, "ens", end_of_day, 4);
  EXPECT_FALSE(newest_wind_ensemble(few.data.wind, all_known, stamps));
  few.wind(member_of("ens", end_of_day, 5), instants(end_of_day, end_of_day + hours(23)),
           of_member(5));
  EXPECT_FALSE(newest_wind_ensemble(few.data.wind, all_known, stamps)) << "the fifth ends at 23 h";
  EXPECT_TRUE(newest_wind_ensemble(few.data.wind, all_known, stamps_to(23)))
      << "all of a shorter horizon is enough";
  add_run(few, "ens", end_of_day - hours(12), 5, 36);
  const auto older = newest_wind_ensemble(few.data.wind, all_known, stamps);
  ASSERT_TRUE(older);
  EXPECT_EQ(older->run.reference_time, end_of_day - hours(12)) << "it has five, to 24 h";
}

TEST(NewestWindEnsemble, TakesNoControlNoDeterministicRunAndNoAnalysis) {
  KnownSeriesForTests sea;
  const auto time = instants(end_of_day, end_of_day + days(4));
  sea.wind(member_of("ens", end_of_day, 0), time, of_member(0));
  sea.wind(forecast_of("hres", end_of_day), time, of_member(0));
  for (int n = 1; n <= 9; ++n) {
    Origin origin = analysis_of("eda");
    origin.ensemble_member = n;
    sea.wind(origin, time, of_member(n));
  }
  EXPECT_FALSE(newest_wind_ensemble(sea.data.wind, all_known, stamps_to(72)));
  add_run(sea, "ens", end_of_day, 5);
  EXPECT_EQ(newest_wind_ensemble(sea.data.wind, all_known, stamps_to(72))->run.number,
            (std::vector{1, 2, 3, 4, 5}));
}

TEST(NewestWindEnsemble, OfOneTimeIsTheLargerThenTheFirstByName) {
  const auto stamps = stamps_to(48);
  for (const bool large_first : {true, false}) {
    KnownSeriesForTests sea;
    add_run(sea, large_first ? "large" : "b", end_of_day, large_first ? 7 : 6);
    add_run(sea, large_first ? "b" : "large", end_of_day, large_first ? 6 : 7);
    add_run(sea, "a", end_of_day, 6);
    EXPECT_EQ(newest_wind_ensemble(sea.data.wind, all_known, stamps)->run.dataset, "large");
    std::erase_if(sea.data.wind.pieces,
                  [](const auto& piece) { return piece.origin->dataset == "large"; });
    EXPECT_EQ(newest_wind_ensemble(sea.data.wind, all_known, stamps)->run.dataset, "a");
  }
}

TEST(NewestWindEnsemble, JoinsTheStepRangesOfAMemberInWhateverOrderTheyCome) {
  KnownSeriesForTests sea;
  for (int n = 1; n <= 5; ++n) {
    sea.wind(member_of("ens", end_of_day, n, 10 + n), instants(end_of_day, end_of_day + hours(12)),
             of_member(n));
    sea.wind(member_of("ens", end_of_day, n, 20 + n),
             instants(end_of_day + hours(12), end_of_day + hours(48)), of_member(n + 100));
  }
  const auto stamps = stamps_to(48);
  const auto straight = members_at(*newest_wind_ensemble(sea.data.wind, all_known, stamps), stamps);
  std::reverse(sea.data.wind.pieces.begin(), sea.data.wind.pieces.end());
  const auto turned = members_at(*newest_wind_ensemble(sea.data.wind, all_known, stamps), stamps);
  ASSERT_EQ(straight.size(), 5U);
  for (std::size_t m = 0; m < 5; ++m) {
    const auto n = static_cast<double>(m + 1);
    EXPECT_EQ(straight[m].number, static_cast<int>(m + 1));
    EXPECT_EQ(straight[m].wind_m_s, turned[m].wind_m_s);
    EXPECT_EQ(straight[m].wind_m_s[11], Horizontal(n, 11));
    EXPECT_EQ(straight[m].wind_m_s[12], Horizontal(n + 100, 12)) << "the later ingested wins";
    EXPECT_EQ(straight[m].wind_m_s[48], Horizontal(n + 100, 48));
  }
}

TEST(NewestWindEnsemble, MayBeginAfterTheDayHasEnded) {
  KnownSeriesForTests sea;
  add_run(sea, "ens", end_of_day + hours(24), 5);
  const auto stamps = stamps_to(72);
  const auto found = newest_wind_ensemble(sea.data.wind, all_known, stamps);
  ASSERT_TRUE(found);
  const auto members = members_at(*found, stamps);
  EXPECT_TRUE(std::isnan(members[0].wind_m_s[23].real()));
  EXPECT_EQ(members[0].wind_m_s[24], Horizontal(1, 24));
  EXPECT_FALSE(newest_wind_ensemble(sea.data.wind, all_known, stamps_to(47)))
      << "23 hours of it say too little";
}

TEST(MembersAt, AreLinearWithinTheRunAndNothingBeyondIt) {
  KnownSeriesForTests sea;
  add_run(sea, "ens", end_of_day - hours(6), 5, 36);
  const auto stamps = stamps_to(48);
  const auto members = members_at(*newest_wind_ensemble(sea.data.wind, all_known, stamps), stamps);
  for (std::size_t m = 0; m < 5; ++m) {
    for (std::size_t t = 0; t < stamps.size(); ++t) {
      const Horizontal wind = members[m].wind_m_s[t];
      if (t > 30) {
        EXPECT_TRUE(std::isnan(wind.real())) << t;
      } else {
        EXPECT_NEAR(std::abs(wind - of_member(static_cast<int>(m + 1))(stamps[t], 0)), 0, 1e-12);
      }
    }
  }
}

TEST(NewestWindEnsemble, HolesInAMemberAreNoValues) {
  KnownSeriesForTests sea;
  add_run(sea, "ens", end_of_day, 5);
  sea.wind(member_of("ens", end_of_day, 6), instants(end_of_day, end_of_day + days(4)),
           steady({nan, nan}));
  EXPECT_EQ(newest_wind_ensemble(sea.data.wind, all_known, stamps_to(72))->run.number,
            (std::vector{1, 2, 3, 4, 5}));
}

}  // namespace
}  // namespace slackwater::calibration::wind_ensemble_test
