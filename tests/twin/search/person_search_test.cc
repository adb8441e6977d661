#include "twin/search/person_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/support/shared_data.h"
#include "twin/control/patterns.h"
#include "twin/search/datum.h"

namespace slackwater::tests::person_search_test {
namespace {

using twin::PersonSearch;
using twin::SearchWater;
using twin::Triple;

constexpr double speed_m_s = 2, leg_m = 40, dt_s = 1;
constexpr int legs = 10;

/// That of data/tasks/mob_drill: a vessel's camera, somebody who fell in two minutes ago.
PersonSearch drill() {
  PersonSearch search;
  search.object = "person_upright";
  search.lookout = "usv_camera";
  search.radius_m = 30;
  search.elapsed_s = 120;
  search.visibility_m = 10000;
  twin::load(search, source_folder() / "data");
  return search;
}

/// Whether somebody is found by whoever goes along the drill's square at 2 m/s over the ground, or
/// over the water that the pattern drifts with: no vehicle, the way alone.
bool is_found(const PersonSearch& search, const SearchWater& water, bool drifts,
              std::uint64_t seed) {
  const std::vector<twin::Waypoint> way = twin::expanding_square({}, leg_m, legs, 0, speed_m_s);
  const Triple<double> drift_m_s =
      drifts ? twin::expected_drift(search.drifts, water.current_m_s, water.wind_10m_m_s)
             : Triple<double>{};
  twin::SearchState state = twin::begin_search(search, {}, water, seed, "searcher");
  double t_s = 0;
  Triple<double> from_m;
  for (const twin::Waypoint& to : way) {
    const Triple<double> leg = to.position_m - from_m;
    const double takes_s = twin::length_of(leg) / speed_m_s;
    for (double gone_s = 0; gone_s < takes_s; gone_s += dt_s) {
      const Triple<double> at_m =
          from_m + (gone_s / takes_s) * leg + (search.elapsed_s + t_s) * drift_m_s;
      if (twin::search_on(search, water, at_m, true, t_s, dt_s, state)) return true;
      t_s += dt_s;
    }
    from_m = to.position_m;
  }
  return false;
}

double share_found(const SearchWater& water, bool drifts, int trials) {
  const PersonSearch search = drill();
  int found = 0;
  for (int i = 0; i < trials; ++i)
    found += is_found(search, water, drifts, static_cast<std::uint64_t>(i)) ? 1 : 0;
  return static_cast<double>(found) / trials;
}

SearchWater water_of(double current_m_s, double wind_m_s) {
  return {{0, current_m_s, 0}, {wind_m_s, 0, 0}, 0.5};
}

TEST(PersonSearch, InStillWaterAndAirItIsAllOneWhetherThePatternDrifts) {
  const PersonSearch search = drill();
  for (std::uint64_t seed = 0; seed < 50; ++seed)
    EXPECT_EQ(is_found(search, water_of(0, 0), false, seed),
              is_found(search, water_of(0, 0), true, seed));
}

/// In the frame of the water a uniform current is none: who drifts with it and who searches in it
/// are as they are in still water.
TEST(PersonSearch, APatternThatDriftsFindsAsOftenInAnyCurrent) {
  constexpr int trials = 400;
  const double still = share_found(water_of(0, 0), true, trials);
  for (const double current_m_s : {0.2, 0.5, 1.0})
    EXPECT_EQ(share_found(water_of(current_m_s, 0), true, trials), still) << current_m_s;
}

/// What drifting does to P(found), with the leeway of a wind across the current on top.
TEST(PersonSearch, ThatDriftsFindsMoreAndAFixedOneFewerTheFasterTheWater) {
  constexpr int trials = 1000;
  double before = 1;
  std::printf("current m/s, P(found) of a fixed and of a drifting square, wind 6 m/s\n");
  for (const double current_m_s : {0.0, 0.25, 0.5}) {
    const double fixed = share_found(water_of(current_m_s, 6), false, trials);
    const double drifting = share_found(water_of(current_m_s, 6), true, trials);
    std::printf("%11.2f  %.3f  %.3f\n", current_m_s, fixed, drifting);
    RecordProperty("fixed_at_" + std::to_string(current_m_s), std::to_string(fixed));
    RecordProperty("drifting_at_" + std::to_string(current_m_s), std::to_string(drifting));
    const double error = 3 * std::sqrt((fixed * (1 - fixed) + 0.002) / trials);
    EXPECT_LT(fixed, before + error);
    if (current_m_s > 0) {
      EXPECT_GT(drifting, fixed + error) << current_m_s;
    }
    before = fixed;
  }
}

}  // namespace
}  // namespace slackwater::tests::person_search_test
