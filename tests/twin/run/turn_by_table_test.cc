#include <map>

#include "fields/base/constants.h"
#include "tests/twin/run/helm_for_tests.h"
#include "twin/account/manoeuvre_figures.h"

namespace slackwater::tests::turn_by_table_test {
namespace {

/// A vehicle that goes straight for a minute and then by a table, logged each half second.
std::vector<twin::ManoeuvreRow> flown(const std::string& model, const std::string& depth,
                                      const std::string& straight, const std::string& turn,
                                      double lasts_s) {
  const auto run = lone_run(
      "name: test\nseed: 7\nduration: 60min\nstep_s: 0.05\nlog_every_s: 0.5\n"
      "water: {made_up: {depth_m: 60}}\nvehicles:\n  - {name: it, model: " +
      model + ", start: {north_m: 0, east_m: 0, " + depth +
      ", heading_deg: 40}, tasks: [{do: "
      "actuators, duration_s: 1800, table: [{at_s: 0, " +
      straight + "}, {at_s: 60, " + turn + "}]}]}\n");
  twin::RunLog log;
  while (run->time_s() < 60 + lasts_s) {
    for (int i = 0; i < 10; ++i) run->step();
    log.append(run->time_s(), run->agents(), run->states());
  }
  std::map<std::string, std::vector<double>, std::less<>> columns;
  twin::VehicleRows rows;
  rows.t_s = log.t_s;
  rows.column = [&](std::string_view name) -> std::span<const double> {
    return columns[std::string(name)] = log.column(0, name);
  };
  return twin::manoeuvre_rows(rows);
}

TEST(TurnByTable, OfTwoThrustersIsTheSameToEitherSide) {
  const std::string straight = "thruster_1_share: 0.5, thruster_2_share: 0.5";
  const auto to_starboard = twin::turning_circle(
      flown("wamv16", "depth_m: 0", straight, "thruster_1_share: 0.5, thruster_2_share: 0.3", 300),
      60);
  const auto to_port = twin::turning_circle(
      flown("wamv16", "depth_m: 0", straight, "thruster_1_share: 0.3, thruster_2_share: 0.5", 300),
      60);
  EXPECT_TRUE(to_starboard.to_starboard);
  EXPECT_FALSE(to_port.to_starboard);
  ASSERT_TRUE(to_starboard.steady && to_port.steady);
  // A craft alike on both sides, but for the rounding of its attitude.
  EXPECT_NEAR(to_port.advance_m.value(), to_starboard.advance_m.value(), 0.01);
  EXPECT_NEAR(to_port.tactical_diameter_m.value(), to_starboard.tactical_diameter_m.value(), 0.01);
  EXPECT_NEAR(to_port.steady->turn_rad_s, -to_starboard.steady->turn_rad_s, 1e-5);
  // A steady turn's radius is that of the circle that it draws.
  const double half_turn_m = to_starboard.steady->radius_m * constants::pi;
  const double lasted_s = to_starboard.full_s.value() - to_starboard.half_s.value();
  EXPECT_NEAR(half_turn_m, to_starboard.steady->speed_m_s * lasted_s, 0.02 * half_turn_m);
}

TEST(TurnByTable, OfARudderTurnsToItsSideAndLogsItsHelm) {
  const std::vector<twin::ManoeuvreRow> rows =
      flown("lrauv_tethys", "depth_m: 20", "thruster_1_share: 0.8", "rudder_deg: 6", 120);
  const twin::TurningCircle circle = twin::turning_circle(rows, 60);
  EXPECT_TRUE(circle.to_starboard);
  EXPECT_TRUE(circle.advance_m);
  EXPECT_EQ(rows.front().helm_rad, 0);
  EXPECT_NEAR(rows.back().helm_rad, 6 * constants::degree, 1e-9);
}

}  // namespace
}  // namespace slackwater::tests::turn_by_table_test
