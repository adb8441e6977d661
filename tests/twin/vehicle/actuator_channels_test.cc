#include "twin/vehicle/actuator_channels.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"
#include "tests/support/shared_data.h"

namespace slackwater::twin::actuator_channels_test {
namespace {

Vehicle bundled(const std::string& id) {
  const auto data = tests::source_folder() / "data";
  return read_vehicle(data / "vehicles" / (id + ".yaml"), data);
}

std::string said_of(const Vehicle& vehicle, const std::vector<std::string>& names,
                    const std::vector<double>& values) {
  try {
    (void)values_by_name(vehicle, names, values);
  } catch (const Error& problem) {
    return problem.message();
  }
  return "";
}

TEST(ActuatorChannels, AreThoseThatAVehicleHas) {
  EXPECT_EQ(channel_names(bundled("lrauv_tethys")),
            "thruster_1, rudder, elevator, moving_mass, volume");
  EXPECT_EQ(channel_names(bundled("wamv16")), "thruster_1, thruster_2");
}

TEST(ActuatorChannels, EachHaveTheUnitOfTheirModel) {
  const Vehicle auv = bundled("lrauv_tethys"), rov = bundled("bluerov2_heavy");
  EXPECT_EQ(channel_of(auv, 0)->unit, ActuatorUnit::rad_s);
  EXPECT_EQ(channel_of(auv, rudder_channel)->unit, ActuatorUnit::rad);
  EXPECT_EQ(channel_of(auv, moving_mass_channel)->unit, ActuatorUnit::m);
  EXPECT_EQ(channel_of(auv, volume_channel)->unit, ActuatorUnit::m3);
  EXPECT_EQ(channel_of(rov, 7)->unit, ActuatorUnit::command);
  EXPECT_FALSE(channel_of(rov, rudder_channel));
  EXPECT_FALSE(channel_of(auv, 1)) << "it has one thruster";
}

TEST(ActuatorChannels, TakeSharesOfTheirMostAndOfTheirLeast) {
  const Vehicle auv = bundled("lrauv_tethys");
  const ActuatorChannel volume = channel_of(auv, volume_channel).value();
  EXPECT_DOUBLE_EQ(volume.of_share(0.5), 0.5 * 0.000455);
  EXPECT_DOUBLE_EQ(volume.of_share(-0.5), -0.5 * 0.000420);
  EXPECT_EQ(volume.of_share(0), 0);
  const ActuatorChannel rudder = channel_of(auv, rudder_channel).value();
  EXPECT_DOUBLE_EQ(rudder.of_share(-1), -auv.rudder.limit_rad);
}

TEST(ActuatorChannels, GivenInUnitsOrSharesAreTheSame) {
  const Vehicle auv = bundled("lrauv_tethys");
  ActuatorValues shares, units;
  shares.give(rudder_channel, 0.5);
  units.give(rudder_channel, 0.5 * auv.rudder.limit_rad);
  EXPECT_EQ(in_units(auv, shares, false), in_units(auv, units, true));
  EXPECT_FALSE(in_units(auv, shares, false).has(elevator_channel)) << "it was not given";
}

TEST(ActuatorChannels, ByANameThatAVehicleHasNotListThoseThatItHas) {
  const Vehicle usv = bundled("wamv16");
  EXPECT_EQ(
      said_of(usv, {"rudder"}, {0.1}),
      "actuators: found rudder, expected one of those of the WAM-V 16: thruster_1, thruster_2");
  EXPECT_EQ(said_of(usv, {"thruster_1", "thruster_1"}, {0.1, 0.2}),
            "actuators: found thruster_1 twice; give it one value");
  EXPECT_EQ(said_of(usv, {"thruster_1"}, {}),
            "actuators: found 1 names and 0 values; give one value for each name");
  EXPECT_EQ(said_of(usv, {"thruster_2", "thruster_1"}, {0.1, 0.2}), "");
}

}  // namespace
}  // namespace slackwater::twin::actuator_channels_test
