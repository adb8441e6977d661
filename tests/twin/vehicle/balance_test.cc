#include "twin/vehicle/balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "fields/base/error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/vehicle_for_tests.h"
#include "tests/twin/vehicle/changed_vehicle.h"
#include "twin/run/set_up.h"

namespace slackwater::twin::balance_test {
namespace {

using tests::bundled_vehicle;

TEST(Balance, TheBundledVehiclesLieWellAndSayNothing) {
  const std::vector<std::string> bundled = catalogue(tests::source_folder() / "data");
  EXPECT_GE(bundled.size(), 5U);
  for (const std::string& id : bundled) {
    const Vehicle vehicle = bundled_vehicle(id);
    EXPECT_TRUE(vehicle.warnings.empty()) << id << ": " << vehicle.warnings.front();
    const Balance balance = balance_of(vehicle);
    EXPECT_NEAR(balance.heel_rad, 0, 1e-12) << id;
    EXPECT_NEAR(balance.trim_rad, 0, 1e-12) << id;
    if (vehicle.kind != VehicleKind::uav) {
      EXPECT_GT(balance.stability_m, 0) << id;
    }
  }
  // twin/docs/vehicles.md: BG of 0.01 m and 0.235 kg of buoyancy.
  const Balance rov = balance_of(bundled_vehicle("bluerov2_heavy"));
  EXPECT_NEAR(rov.stability_m, 0.01, 1e-12);
  EXPECT_NEAR(rov.net_buoyancy_n, 0.235 * constants::gravity_m_s2, 0.01);
}

TEST(Balance, TheMetacentricHeightIsTheSlopeOfTheRightingMomentThatTheStepUses) {
  // GM = dK/d(heel)/W: the strips' own force at a small angle is the oracle, within what a step of
  // the table of sections makes of its slope.
  for (const char* id : {"wamv16", "ctv24"}) {
    const Vehicle vehicle = bundled_vehicle(id);
    const Body& body = vehicle.body;
    const double weight_n = body.mass_kg * constants::gravity_m_s2;
    const double down_m = floating_depth_m(body.hull, body.mass_kg, body.fluid_density_kg_m3);
    constexpr double angle = 1e-3;
    const auto moment = [&](double roll, double pitch) {
      const Rotation<double> r = rotation_of(attitude_of({roll, pitch, 0}));
      return (floating_force<double>(body.hull, body.fluid_density_kg_m3, r, down_m, nullptr) +
              force_at(body.centre_of_gravity_m, weight_n * r.down))
          .angular;
    };
    const Balance balance = balance_of(vehicle);
    EXPECT_NEAR(balance.stability_m, -moment(angle, 0).x / (weight_n * angle),
                0.02 * balance.stability_m)
        << id;
    EXPECT_NEAR(balance.stability_long_m, -moment(0, angle).y / (weight_n * angle),
                0.02 * balance.stability_long_m)
        << id;
  }
}

/// What is said of a bundled vehicle with one thing changed: of an error its message, else its
/// warnings.
std::string said(const std::string& id, const std::string& what, const std::string& instead) {
  const auto data = tests::source_folder() / "data";
  std::ifstream in(data / "vehicles" / (id + ".yaml"));
  std::string yaml(std::istreambuf_iterator<char>(in), {});
  const std::size_t at = yaml.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  const tests::TemporaryFolder folder;
  std::ofstream(folder / "odd.yaml") << yaml.replace(at, what.size(), instead);
  try {
    std::string all;
    for (const std::string& warning : read_vehicle(folder / "odd.yaml", data).warnings)
      all += "warning: " + warning + "\n";
    return all;
  } catch (const Error& problem) {
    return "error: " + problem.message();
  }
}

TEST(Balance, AHeightOfTheWindThatNobodyStatesIsToldOf) {
  const std::string stated = ", wind_height_m: 10";
  const std::string text = said("wamv16", stated, "");
  EXPECT_EQ(text.rfind("warning: wind_force: found no wind_height_m, took 10 m", 0), 0U) << text;
  EXPECT_EQ(said("wamv16", stated, ", wind_height_m: 4"), "");
  EXPECT_EQ(said("ctv24", stated, ", wind_height_m: 0.5").rfind("error: ", 0), 0U);
}

struct Odd {
  const char* id;
  const char* what;
  const char* instead;
  std::vector<const char*> says;
};

TEST(Balance, WhatCannotBeIsRefusedAndWhatIsOddIsToldWithTheNumbers) {
  const Odd all[] = {
      {"lrauv_tethys",
       "centre_of_buoyancy_m: [0, 0, -0.007]",
       "centre_of_buoyancy_m: [0, 0, 0.007]",
       {"error:", "0.007 m above", "turns over"}},
      {"lrauv_tethys",
       "centre_of_buoyancy_m: [0, 0, -0.007]",
       "centre_of_buoyancy_m: [0, 0, 0]",
       {"error:", "turns over"}},
      {"lrauv_tethys",
       "mass_kg: 147.5671",
       "mass_kg: 162.3",
       {"error:", "9.1 %) too heavy", "hull bears", "mass_kg"}},
      {"lrauv_tethys", "mass_kg: 147.5671", "mass_kg: 150", {"warning:", "too heavy"}},
      {"lrauv_tethys",
       "centre_of_buoyancy_m: [0, 0, -0.007]",
       "centre_of_buoyancy_m: [0.02, 0, -0.007]",
       {"error:", "of trim at rest"}},
      {"lrauv_tethys",
       "centre_of_buoyancy_m: [0, 0, -0.007]",
       "centre_of_buoyancy_m: [0, 0.002, -0.007]",
       {"warning:", "15.9 degrees of heel"}},
      {"bluerov2_heavy",
       "centre_of_buoyancy_m: [0, 0, -0.01]",
       "centre_of_buoyancy_m: [0, 0, 0.01]",
       {"error:", "turns over"}},
      {"bluerov2_heavy", "mass_kg: 13.5", "mass_kg: 14.9", {"warning:", "too heavy", "5 %"}},
      {"wamv16",
       "centre_of_gravity_m: [0, 0, -0.114]",
       "centre_of_gravity_m: [0, 0, -20]",
       {"error:", "capsizes"}},
      {"wamv16",
       "centre_of_gravity_m: [0, 0, -0.114]",
       "centre_of_gravity_m: [0, 0.9, -0.114]",
       {"warning:", "degrees of heel"}},
      {"wamv16",
       "from_x_m: -2.45, to_x_m: 2.45",
       "from_x_m: 4.9, to_x_m: 9.8",
       {"error:", "of trim at rest"}},
      {"ctv24", "centre_y_m: [-3.3, 3.3]", "centre_y_m: [0, 6.6]", {"error:", "degrees of heel"}},
  };
  for (const Odd& odd : all) {
    const std::string message = said(odd.id, odd.what, odd.instead);
    for (const char* says : odd.says)
      EXPECT_NE(message.find(says), std::string::npos)
          << odd.id << " " << odd.instead << "\n-> " << message;
  }
}

/// Prestero's REMUS, 306 N of buoyancy and 7 N light as in his tables, and as it is ballasted at
/// sea. The angles are of his equations, solved apart from this code.
TEST(Balance, AnAuvThatItsElevatorDoesNotHoldLevelIsRefusedWithTheAngles) {
  const std::pair<std::string, std::string> light{"volume_m3: 0.030078", "volume_m3: 0.030442"};
  const auto least = [](const char* m_s) {
    return std::pair<std::string, std::string>{"least_speed_m_s: 1.0",
                                               std::string("least_speed_m_s: ") + m_s};
  };
  const std::string refusal = tests::refusal_of("remus100", {light});
  for (const char* says : {"made-up.yaml:", "displacement", "306 N of buoyancy", "too light",
                           "at 1 m/s level flight takes 17.0 of 13.6 degrees of elevator",
                           "mass_kg, volume_m3", "or raise autopilot.least_speed_m_s to 1.2"})
    EXPECT_NE(refusal.find(says), std::string::npos) << says << "\n-> " << refusal;
  // From there on it holds, with little left to steer by.
  const std::vector<std::string> faster =
      tests::changed_vehicle("remus100", {light, least("1.2")}).warnings;
  EXPECT_TRUE(std::any_of(faster.begin(), faster.end(), [](const std::string& warning) {
    return warning.find("at 1.2 m/s level flight takes 13.") != std::string::npos;
  }));
  // Nobody says that it is steered at the least speed that autopilots have by default.
  EXPECT_NO_THROW(
      (void)tests::changed_vehicle("remus100", {light, {"least_speed_m_s: 1.0, ", ""}}));
  const std::string cruising =
      tests::refusal_of("remus100", {light, {"cruise_speed_m_s: 1.5", "cruise_speed_m_s: 1.0"}});
  EXPECT_NE(cruising.find("raise cruise_speed_m_s to 1.2"), std::string::npos) << cruising;
  EXPECT_TRUE(bundled_vehicle("remus100").warnings.empty());
}

/// Wide and shallow aft, narrow and deep forward, the waterline at the origin: areas, volumes and
/// second moments by hand.
TEST(Balance, OfHullsOfTwoSectionsIsAboutTheCentreOfTheWaterlineOfBoth) {
  Vehicle vehicle;
  vehicle.kind = VehicleKind::usv;
  Body& body = vehicle.body;
  body.hull = read_floating_hull(Config::parse(R"(hulls:
  - {beam_m: 0.25, depth_m: 0.4, from_x_m: -1, to_x_m: 0.2, keel_z_m: 0.0581,
     centre_y_m: [-0.395, 0.395], strips: 3}
  - {beam_m: 0.09375, depth_m: 0.5, from_x_m: 0.2, to_x_m: 1, keel_z_m: 0.2877,
     centre_y_m: [-0.395, 0.395], strips: 2}
)",
                                               "hulls.yaml"));
  constexpr double aft_m2 = 2 * 1.2 * 0.25, fore_m2 = 2 * 0.8 * 0.09375;
  constexpr double aft_m3 = aft_m2 * 0.0581, fore_m3 = fore_m2 * 0.2877;
  constexpr double volume_m3 = aft_m3 + fore_m3;
  const double buoyancy_x_m = (aft_m3 * -0.4 + fore_m3 * 0.6) / volume_m3;
  const double buoyancy_z_m = (aft_m3 * 0.0581 + fore_m3 * 0.2877) / (2 * volume_m3);
  body.fluid_density_kg_m3 = 1000;
  body.mass_kg = 1000 * volume_m3;
  body.centre_of_gravity_m = {buoyancy_x_m + 0.05, 0.02, -0.2};
  const Balance balance = balance_of(vehicle);
  // 0.2 m and 0.8 m from the centre of the waterline, which is 0.2 m aft of the origin.
  const double along_m4 = aft_m2 * (1.2 * 1.2 / 12 + 0.2 * 0.2) + fore_m2 * (0.8 * 0.8 / 12 + 0.64);
  const double across_m4 = aft_m2 * (0.25 * 0.25 / 12 + 0.395 * 0.395) +
                           fore_m2 * (0.09375 * 0.09375 / 12 + 0.395 * 0.395);
  const double below_m = -0.2 - buoyancy_z_m;
  // Within what the table's linear steps of 7 mm make of the moment of the area.
  EXPECT_NEAR(balance.stability_m, below_m + across_m4 / volume_m3, 1e-4);
  EXPECT_NEAR(balance.stability_long_m, below_m + along_m4 / volume_m3, 1e-4);
  EXPECT_NEAR(balance.trim_rad, std::atan(0.05 / (below_m + along_m4 / volume_m3)), 1e-6);
  EXPECT_NEAR(balance.heel_rad, std::atan(0.02 / (below_m + across_m4 / volume_m3)), 1e-6);
  EXPECT_NEAR(balance.draught_m, 0.2877, 1e-6);
  EXPECT_NEAR(balance.beam_m, 0.79 + 0.25, 1e-6);
  // The fore deck is the lower of the two: 0.5 m less 0.2877 m, against 0.4 m less 0.0581 m.
  EXPECT_NEAR(balance.least_freeboard_m,
              0.2123 - std::tan(balance.trim_rad) * 1.2 - std::tan(balance.heel_rad) * 0.395, 1e-6);
}

}  // namespace
}  // namespace slackwater::twin::balance_test
