#include "api/log/score.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"

namespace slackwater::tests::score_test {
namespace {

using namespace api;

/// A vehicle goes 20 m east in 20 s for 400 J, is then done, and hovers on for 40 s more, 3 m off,
/// for 800 J. A limit held it from 5 s to 9 s.
ingest::TrajectoryFile log_of_one(bool has_mission) {
  ingest::TrajectoryFile log;
  log.names = {"eye"};
  log.epoch = parse_utc("2025-03-10T06:00:00Z");
  for (int t = 0; t <= 60; ++t) log.t_s.push_back(t);
  const auto add = [&](const char* name, auto&& of) {
    std::vector<double> values;
    for (const double t_s : log.t_s) values.push_back(of(t_s));
    log.variables.push_back({name, "", "", "", 1, std::move(values)});
  };
  add("x", [](double t_s) { return std::min(t_s, 20.0); });
  add("y",
      [](double t_s) { return t_s > 20 ? (static_cast<int>(t_s) % 2 == 0 ? 3.0 : 0.0) : 0.0; });
  add("z", [](double) { return -5.0; });
  add("across_track", [](double t_s) { return t_s > 20 ? 3.0 : 0.5; });
  add("below_track", [](double) { return 0.1; });
  add("electrical_energy", [](double t_s) { return 20 * t_s; });
  if (!has_mission) return log;
  ingest::TrajectoryTable mission;
  mission.name = "mission";
  mission.columns = {{"vehicle", "1", "", {0, 0, 0, 0}}, {"time", "s", "", {0, 5, 9, 20}}};
  mission.texts = {{"kind", "", {"phase_began", "hold_began", "resumed", "finished"}},
                   {"cause", "", {"none", "limit", "limit", "none"}},
                   {"text", "", {"work", "holds", "resumes", "finished"}}};
  log.tables.push_back(mission);
  return log;
}

TEST(Score, WhatAVehicleDoesWhenItsWorkIsOverIsNotScored) {
  const twin::VehicleAccount eye = scorecard_of(log_of_one(true)).account.vehicles.front();
  EXPECT_TRUE(is_scored_done(eye, 60));
  EXPECT_EQ(scored_time_s(eye), 20);
  EXPECT_NEAR(eye.at_work.sailed_m, 20, 1e-12);
  ASSERT_TRUE(energy_per_metre_j(eye));
  EXPECT_NEAR(*energy_per_metre_j(eye), 20, 1e-12);
  EXPECT_NEAR(eye.at_work.rms_across_m, 0.5, 1e-12);
  EXPECT_NEAR(eye.at_work.across_m->value, 0.5, 1e-12);
  EXPECT_NEAR(eye.track.across_m->value, 3, 1e-12) << "of the whole run";
  const twin::Interventions away = twin::interventions_of(eye.mission, 60);
  EXPECT_EQ(away.count, 1U);
  EXPECT_EQ(away.limit_violations, 1U);
  EXPECT_EQ(away.away_s, 4);
}

TEST(Score, OfAStackWithoutMissionsIsThatOfTheWholeLog) {
  const twin::VehicleAccount eye = scorecard_of(log_of_one(false)).account.vehicles.front();
  EXPECT_FALSE(is_scored_done(eye, 60));
  EXPECT_EQ(scored_time_s(eye), 60);
  EXPECT_NEAR(eye.at_work.sailed_m, 20 + 40 * 3, 3.1);
  EXPECT_EQ(twin::interventions_of(eye.mission, 60).count, 0U);
}

TEST(Score, ClosestApproachesAreThoseThatTheLogTells) {
  ingest::TrajectoryFile log = log_of_one(true);
  log.names = {"eye", "other"};
  for (auto& variable : log.variables) {
    const std::vector<double> eye = variable.values;
    variable.values.insert(variable.values.end(), eye.begin(), eye.end());
  }
  // By its rows it goes through the other.
  const auto closest = [&](std::size_t i) { return scorecard_of(log).account.vehicles[i].closest; };
  EXPECT_EQ(closest(0).vehicle->distance_m, 0.0);
  log.attributes.emplace_back("log_format", "3");
  EXPECT_FALSE(closest(0).vehicle) << "they were aboard, say";
  ingest::TrajectoryTable approach;
  approach.name = "approach";
  approach.columns = {{"vehicle", "1", "", {0, 0, 1}},
                      {"distance", "m", "", {4.5, 2.5, 9}},
                      {"time", "s", "", {3, 30, 4}},
                      {"mmsi", "1", "", {0, 0, 7}}};
  approach.texts = {{"kind", "", {"vehicle", "tether", "vessel"}},
                    {"to", "", {"other", "other", ""}}};
  log.tables.push_back(approach);
  EXPECT_EQ(closest(0).vehicle->distance_m, 4.5);
  EXPECT_EQ(closest(0).tether->distance_m, 2.5) << "of the whole run, also when its work is over";
  EXPECT_FALSE(closest(0).vessel);
  EXPECT_EQ(closest(1).vessel->distance_m, 9.0);
  EXPECT_FALSE(closest(1).structure);
}

TEST(Score, ALogWithoutPlacesIsAnError) {
  ingest::TrajectoryFile log = log_of_one(false);
  log.variables.erase(log.variables.begin());
  EXPECT_THROW((void)scorecard_of(log), Error);
}

}  // namespace
}  // namespace slackwater::tests::score_test
