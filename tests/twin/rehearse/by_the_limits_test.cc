#include "twin/rehearse/by_the_limits.h"

#include "tests/twin/mission/mission_for_tests.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/rehearse/flight.h"

namespace slackwater::tests::by_the_limits_test {
namespace {

const UtcTime start = parse_utc("2025-06-02T06:00:00Z");

twin::Scenario scour(const std::string& agents) {
  const std::string yaml =
      "name: scour\nseed: 7\nduration: 3h\nstep_s: 0.05\nlog_every_s: 1\nwater: {made_up: "
      "{depth_m: "
      "35, current: [{depth_m: 0, east_m_s: 0.2, north_m_s: 0}], wind: {speed_m_s: 3, from_deg: "
      "270}}}\ntasks: [scour_survey]\nturbines: [A01]\nagents: {surveyor: " +
      agents + "}\n";
  return twin::expand_mission(Config::parse(yaml, "mission.yaml"), small_farm_parts()).scenario;
}

/// Its water, with a current that grows evenly to `grown` times what it is within four hours.
twin::Surround water_of(const twin::Scenario& mission, double grown) {
  twin::Surround surround = surround_of(mission);
  surround.field = twin::made_up_field(std::get<twin::MadeUpWater>(mission.water), surround.site,
                                       start, start + std::chrono::hours(4));
  auto snapshot = std::make_shared<Snapshot>(surround.field->snapshot());
  const std::size_t times = snapshot->time.size();
  for (ForecastColumn& column : snapshot->columns)
    for (std::size_t i = 0; i < column.current_m_s.size(); ++i) {
      const std::size_t t = i / (column.current_m_s.size() / times);
      column.current_m_s[i] *=
          1 + (grown - 1) * static_cast<double>(t) / static_cast<double>(times - 1);
    }
  surround.field = std::make_shared<Field>(std::move(snapshot));
  return surround;
}

twin::Flight flown(const twin::Scenario& mission, const twin::Surround& surround) {
  const twin::FlightCase flown{start, 0};
  return twin::fly(mission, surround, {&flown, 1}, {}).front();
}

TEST(ByTheLimits, AreOfOneMindWithTheFlightsWhereNothingElseStopsThem) {
  const twin::Scenario mission = scour("{}");
  const twin::Surround surround = water_of(mission, 1);
  const twin::LimitsSay say = twin::by_the_limits(mission, surround, start, {});
  EXPECT_TRUE(say.allows);
  EXPECT_NE(say.binding.find("current at most 0.5"), std::string::npos) << say.binding;
  EXPECT_NEAR(say.share, 0.4, 0.01);
  EXPECT_TRUE(flown(mission, surround).is_done);
}

TEST(ByTheLimits, AllowWhatTheBatteryRefuses) {
  const twin::Scenario mission = scour("{state_of_charge: 0.23}");
  const twin::Surround surround = water_of(mission, 1);
  EXPECT_TRUE(twin::by_the_limits(mission, surround, start, {}).allows);
  const twin::Flight flight = flown(mission, surround);
  EXPECT_FALSE(flight.is_done);
  EXPECT_EQ(flight.stopped_by, "energy for the way home (surveyor)");
  // Home with what it was to keep.
  EXPECT_GT(flight.vehicles[0].on_mission.charge, 0.2);
  EXPECT_LT(flight.vehicles[0].work_share(), 1);
}

TEST(ByTheLimits, ForbidWhatIsDoneBeforeTheyAreExceeded) {
  const twin::Scenario mission = scour("{}");
  const twin::Surround surround = water_of(mission, 4);
  const twin::LimitsSay say = twin::by_the_limits(mission, surround, start, {});
  EXPECT_FALSE(say.allows);
  EXPECT_GT(say.share, 1);
  const twin::Flight flight = flown(mission, surround);
  EXPECT_TRUE(flight.is_done) << flight.stopped_by;
  EXPECT_LT(flight.ended_s, 3600);
}

/// Its water on levels of 5 m, faster at one of them.
twin::Surround water_with_a_jet(const twin::Scenario& mission, double jet_depth_m) {
  twin::Surround surround = water_of(mission, 1);
  auto snapshot = std::make_shared<Snapshot>(surround.field->snapshot());
  const std::size_t times = snapshot->time.size();
  snapshot->depth_m = {0, 5, 10, 15, 20, 25, 30, 34};
  const std::size_t levels = snapshot->depth_m.size();
  for (ForecastColumn& column : snapshot->columns) {
    column.current_m_s.assign(times * levels, {0.2, 0});
    column.current_sigma_m_s.assign(times * levels, column.current_sigma_m_s.front());
    column.current_status.assign(times * levels, column.current_status.front());
    for (std::size_t i = 0; i < column.current_m_s.size(); ++i)
      if (snapshot->depth_m[i % levels] == jet_depth_m) column.current_m_s[i] = {0.8, 0};
  }
  surround.field = std::make_shared<Field>(std::move(snapshot));
  return surround;
}

TEST(ByTheLimits, OfAWayDownCountWhatItPassesThrough) {
  const twin::Scenario mission = scour("{}");
  for (const double jet_depth_m : {5.0, 20.0}) {  // where it begins, and half way down
    const twin::Surround surround = water_with_a_jet(mission, jet_depth_m);
    const twin::LimitsSay say = twin::by_the_limits(mission, surround, start, {});
    EXPECT_FALSE(say.allows) << jet_depth_m;
    EXPECT_NE(say.binding.find("current at most 0.5"), std::string::npos) << say.binding;
    EXPECT_NE(say.binding.find("m of depth"), std::string::npos) << say.binding;
  }
  EXPECT_FALSE(flown(mission, water_with_a_jet(mission, 5)).is_done);
  // Above where it begins nothing counts.
  EXPECT_TRUE(twin::by_the_limits(mission, water_with_a_jet(mission, 0), start, {}).allows);
}

TEST(ByTheLimits, AFlightInACurrentThatGrowsHoldsAndComesHome) {
  // From 0.2 to 2.8 m/s in four hours: 0.5 m/s after half an hour.
  const twin::Scenario slow = scour("{speed_m_s: 0.15, state_of_charge: 0.8}");
  const twin::Surround surround = water_of(slow, 14);
  const twin::Flight flight = flown(slow, surround);
  EXPECT_FALSE(flight.is_done);
  std::vector<twin::MissionEvent> told;
  for (const twin::MissionEvent& event : flight.vehicles[0].mission)
    if (event.kind != twin::ConductEventKind::phase_began) told.push_back(event);
  // It holds for the limit, and leaves before the way home is more than it has.
  ASSERT_EQ(told.size(), 5U);
  EXPECT_EQ(told[0].kind, twin::ConductEventKind::hold_began);
  EXPECT_EQ(told[0].cause, twin::Cause::limit);
  EXPECT_NEAR(told[0].value.value_or(0), 0.5, 0.005);
  EXPECT_EQ(told[1].kind, twin::ConductEventKind::turned_for_home);
  EXPECT_EQ(told[1].cause, twin::Cause::reserve);
  EXPECT_EQ(told[2].kind, twin::ConductEventKind::came_home);
  EXPECT_EQ(told[4].kind, twin::ConductEventKind::came_aboard);
  EXPECT_EQ(flight.stopped_by, "energy for the way home (surveyor)");
  // The current has grown on its way: that is what the reserve is for.
  EXPECT_GT(flight.vehicles[0].on_mission.charge, 0.1);
}

}  // namespace
}  // namespace slackwater::tests::by_the_limits_test
