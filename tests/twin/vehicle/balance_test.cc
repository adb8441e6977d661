#include "twin/vehicle/balance.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "fields/base/error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/vehicle_for_tests.h"

namespace slackwater::twin::balance_test {
namespace {

using tests::bundled_vehicle;

TEST(Balance, TheBundledVehiclesLieWellAndSayNothing) {
  for (const char* id : {"bluerov2_heavy", "lrauv_tethys", "x500", "wamv16", "ctv24"}) {
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
      {"lrauv_tethys", "mass_kg: 147.5671", "mass_kg: 150.3", {"warning:", "too heavy"}},
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

}  // namespace
}  // namespace slackwater::twin::balance_test
