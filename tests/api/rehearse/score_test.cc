#include "api/rehearse/score.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"

namespace slackwater::tests {
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
  const VehicleScore score = scorecard_of(log_of_one(true)).vehicles.front();
  EXPECT_TRUE(score.is_done);
  EXPECT_EQ(score.time_s, 20);
  EXPECT_NEAR(score.sailed_m, 20, 1e-12);
  ASSERT_TRUE(score.energy_per_metre_j);
  EXPECT_NEAR(*score.energy_per_metre_j, 20, 1e-12);
  EXPECT_NEAR(score.rms_across_track_m, 0.5, 1e-12);
  EXPECT_NEAR(score.largest_across_track_m, 0.5, 1e-12);
  EXPECT_EQ(score.interventions, 1U);
  EXPECT_EQ(score.limit_violations, 1U);
  EXPECT_EQ(score.takeover_s, 4);
}

TEST(Score, OfAStackWithoutMissionsIsThatOfTheWholeLog) {
  const VehicleScore score = scorecard_of(log_of_one(false)).vehicles.front();
  EXPECT_FALSE(score.is_done);
  EXPECT_EQ(score.time_s, 60);
  EXPECT_NEAR(score.sailed_m, 20 + 40 * 3, 3.1);
  EXPECT_EQ(score.interventions, 0U);
}

TEST(Score, ClosestApproachesAreThoseThatTheLogTells) {
  ingest::TrajectoryFile log = log_of_one(true);
  log.names = {"eye", "other"};
  for (auto& variable : log.variables) {
    const std::vector<double> eye = variable.values;
    variable.values.insert(variable.values.end(), eye.begin(), eye.end());
  }
  // By its rows it goes through the other.
  EXPECT_EQ(scorecard_of(log).vehicles.front().closest_vehicle_m, 0.0);
  log.attributes.emplace_back("log_format", "3");
  EXPECT_FALSE(scorecard_of(log).vehicles.front().closest_vehicle_m) << "they were aboard, say";
  ingest::TrajectoryTable approach;
  approach.name = "approach";
  approach.columns = {{"vehicle", "1", "", {0, 0, 1}},
                      {"distance", "m", "", {4.5, 2.5, 9}},
                      {"time", "s", "", {3, 30, 4}},
                      {"mmsi", "1", "", {0, 0, 7}}};
  approach.texts = {{"kind", "", {"vehicle", "tether", "vessel"}},
                    {"to", "", {"other", "other", ""}}};
  log.tables.push_back(approach);
  const auto scores = scorecard_of(log).vehicles;
  EXPECT_EQ(scores[0].closest_vehicle_m, 4.5);
  EXPECT_EQ(scores[0].closest_tether_m, 2.5) << "of the whole run, also when its work is over";
  EXPECT_FALSE(scores[0].closest_vessel_m);
  EXPECT_EQ(scores[1].closest_vessel_m, 9.0);
  EXPECT_FALSE(scores[1].closest_structure_m);
}

TEST(Score, ALogWithoutPlacesIsAnError) {
  ingest::TrajectoryFile log = log_of_one(false);
  log.variables.erase(log.variables.begin());
  EXPECT_THROW((void)scorecard_of(log), Error);
}

}  // namespace
}  // namespace slackwater::tests
