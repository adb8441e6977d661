#include <fstream>

#include "fields/base/error.h"
#include "fields/site/site.h"
#include "tests/twin/mission/mission_for_tests.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/mission/site_work.h"
#include "twin/rehearse/expect_fit.h"
#include "twin/rehearse/flight.h"

namespace slackwater::tests::from_a_vessel_test {
namespace {

using Kind = twin::ConductEventKind;

/// The mission that comes with the program, laid out at its farm.
struct FromAVessel {
  twin::ExpandedMission expanded;
  twin::Scenario scenario;
  twin::Surround surround;
};

FromAVessel from_a_vessel(const std::function<void(std::string&)>& change = {}) {
  const std::filesystem::path data = source_folder() / "data";
  std::ifstream in(data / "missions" / "scour_from_a_vessel.yaml");
  std::string yaml((std::istreambuf_iterator<char>(in)), {});
  if (change) change(yaml);
  const Config mission = Config::parse(yaml, "scour_from_a_vessel.yaml");
  twin::MissionParts parts = small_farm_parts();
  const Site site = find_site((data / "sites" / "example_farm.yaml").string(), {});
  parts.site = twin::work_site_of(site);
  parts.origin = site.point;
  FromAVessel out;
  out.expanded = twin::expand_mission(mission, parts);
  mission.expect_all_read();
  out.scenario = out.expanded.scenario;
  out.surround = surround_of(out.scenario);
  out.surround.field =
      twin::made_up_field(std::get<twin::MadeUpWater>(out.scenario.water), site.point,
                          *out.scenario.start, *out.scenario.start + std::chrono::hours(4));
  return out;
}

twin::Flight flown(const FromAVessel& mission) {
  twin::expect_fit(mission.expanded, twin::set_up(mission.scenario, mission.surround));
  twin::FlightSettings settings;
  settings.workers = mission.expanded.workers;
  const twin::FlightCase flown{*mission.scenario.start, 0};
  return twin::fly(mission.scenario, mission.surround, {&flown, 1}, settings).front();
}

std::vector<double> times(const twin::VehicleAccount& vehicle, Kind kind) {
  std::vector<double> out;
  for (const twin::MissionEvent& event : vehicle.mission)
    if (event.kind == kind) out.push_back(event.t_s);
  return out;
}

TEST(FromAVessel, AnRovSurveysTwoPilesInOneMorning) {
  const FromAVessel mission = from_a_vessel();
  const twin::Flight flight = flown(mission);
  EXPECT_TRUE(flight.is_done) << flight.stopped_by;
  ASSERT_EQ(flight.vehicles.size(), 2U);
  const twin::VehicleAccount &rov = flight.vehicles[0], &tender = flight.vehicles[1];
  EXPECT_EQ(rov.work_share(), 1);
  EXPECT_EQ(rov.held_s, 0);
  const auto launched = times(rov, Kind::launched), aboard = times(rov, Kind::came_aboard);
  ASSERT_EQ(launched.size(), 2U);
  ASSERT_EQ(aboard.size(), 2U);
  // Three minutes for the launch; recovered for three, then carried 700 m at 4 m/s with another
  // battery put in for 15 min meanwhile, and launched for three.
  EXPECT_NEAR(launched[0], 180, 5);
  EXPECT_GT(launched[1] - aboard[0], 180 + 15 * 60 + 180 - 5);
  EXPECT_LT(launched[1] - aboard[0], 180 + 15 * 60 + 180 + 120);
  // Work alike at both, in the same water.
  EXPECT_NEAR(aboard[1] - launched[1], aboard[0] - launched[0], 0.1 * (aboard[0] - launched[0]));
  EXPECT_TRUE(tender.is_done) << tender.stopped_by;
  EXPECT_GT(tender.closest.structure->distance_m, 13);
  EXPECT_LT(rov.line_used, 0.5);
  EXPECT_GT(rov.line_used, 0.005);
}

/// Its fence goes with her.
TEST(FromAVessel, APilotInsideAFenceReadsAnodesAtTwoPiles) {
  const twin::Flight flight = flown(from_a_vessel([](std::string& yaml) {
    yaml.replace(yaml.find("scour_survey"), 12, "cp_anode");
    yaml.replace(yaml.find("  surveyor:"), 11, "  inspector:");
  }));
  EXPECT_TRUE(flight.is_done) << flight.stopped_by;
  EXPECT_EQ(flight.vehicles[0].work_share(), 1);
  EXPECT_EQ(times(flight.vehicles[0], Kind::launched).size(), 2U);
}

TEST(FromAVessel, IsRefusedWhereItsWorkLiesBeyondItsLine) {
  const FromAVessel far = from_a_vessel([](std::string& yaml) {
    const std::string stands = "distance_m: 30";
    yaml.replace(yaml.find(stands), stands.size(), "distance_m: 95");
  });
  try {
    twin::expect_fit(far.expanded, twin::set_up(far.scenario, far.surround));
    FAIL() << "expected a refusal";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("from the top of its tether"), std::string::npos)
        << error.what();
  }
}

TEST(FromAVessel, IsNotLaunchedFromADeckThatMovesMoreThanIsAllowed) {
  const twin::Flight flight = flown(from_a_vessel([](std::string& yaml) {
    const std::string allowed = "deck_motion_m: 1.5";
    yaml.replace(yaml.find(allowed), allowed.size(), "deck_motion_m: 0.02");
  }));
  EXPECT_FALSE(flight.is_done);
  EXPECT_NE(flight.stopped_by.find("motion of the deck"), std::string::npos) << flight.stopped_by;
  EXPECT_TRUE(times(flight.vehicles[0], Kind::launched).empty());
}

}  // namespace
}  // namespace slackwater::tests::from_a_vessel_test
