#include "fields/wind/turbine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "fields/base/error.h"
#include "tests/support/shared_data.h"

namespace slackwater::turbine_test {
namespace {

Turbine nrel_5mw() {
  return Turbine::load(tests::source_folder() / "data" / "turbines" / "nrel_5mw.yaml");
}

std::string message_of(const std::string& yaml) {
  try {
    static_cast<void>(Turbine::parse(yaml, "turbine.yaml"));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    return error.message();
  }
  return "no error";
}

constexpr const char* small =
    "name: small\nsource: made up\nrotor_diameter_m: 20\nhub_height_m: 30\nrated_power_w: 1.0e5\n"
    "cut_in_speed_m_s: 3\nrated_speed_m_s: 10\ncut_out_speed_m_s: 20\nair_density_kg_m3: 1.225\n";

TEST(NrelTurbine, HasThePublishedPowerCurve) {
  // fields/docs/physics.md, section 10, power, printed to 0.1 kW; from 11.5 m/s on it is rated.
  const Turbine turbine = nrel_5mw();
  EXPECT_NEAR(turbine.power_w(3.0), 36.7e3, 50);
  EXPECT_NEAR(turbine.power_w(5.0), 387.6e3, 50);
  EXPECT_NEAR(turbine.power_w(8.0), 1707.1e3, 50);
  EXPECT_NEAR(turbine.power_w(10.0), 3329.1e3, 50);
  EXPECT_NEAR(turbine.power_w(11.0), 4403.9e3, 50);
  for (const double speed : {11.5, 12.0, 15.0, 20.0, 25.0}) {
    EXPECT_NEAR(turbine.power_w(speed), 5.0e6, 100) << speed;
  }
}

TEST(NrelTurbine, MakesItsFiveMegawattsFromCpAtTwelveMetresPerSecond) {
  const Turbine turbine = nrel_5mw();
  const double cp = turbine.power_coefficient(12.0);
  EXPECT_NEAR(0.5 * 1.225 * turbine.rotor_area_m2() * cp * 12 * 12 * 12, 5.000e6, 50);
}

TEST(NrelTurbine, StandsStillOutsideItsRange) {
  const Turbine turbine = nrel_5mw();
  for (const double speed : {-1.0, 0.0, 2.999, 25.001, 60.0}) {
    EXPECT_EQ(turbine.power_w(speed), 0) << speed;
    EXPECT_EQ(turbine.thrust_coefficient(speed), 0) << speed;
  }
  EXPECT_TRUE(std::isnan(turbine.power_w(std::nan(""))));
  EXPECT_TRUE(std::isnan(turbine.thrust_coefficient(std::nan(""))));
}

TEST(NrelTurbine, NeverExceedsRatedPowerNorFallsBelowItsRated) {
  const Turbine turbine = nrel_5mw();
  double before = 0;
  for (double speed = 3; speed <= 25; speed += 0.01) {
    const double power = turbine.power_w(speed);
    EXPECT_LE(power, 5.0e6);
    // Rated power is tabulated to 0.1 kW.
    EXPECT_GE(power, before - 200) << speed;
    before = power;
  }
}

TEST(NrelTurbine, PassesThroughTheRowsOfItsThrustAndHalfwayBetween) {
  const Turbine turbine = nrel_5mw();
  EXPECT_DOUBLE_EQ(turbine.thrust_coefficient(3.0), 0.99);
  EXPECT_DOUBLE_EQ(turbine.thrust_coefficient(8.0), 0.7629228);
  EXPECT_DOUBLE_EQ(turbine.thrust_coefficient(25.0), 0.05741999);
  EXPECT_NEAR(turbine.thrust_coefficient(8.25), 0.5 * (0.7629228 + 0.76156073), 1e-15);
}

TEST(TurbineFile, WithAnUnknownKeyIsRefusedByName) {
  const std::string curve =
      "wind_speed_m_s: [3, 20]\npower_coefficient: [0.2, 0.1]\nthrust_coefficient: [0.8, 0.1]\n";
  EXPECT_EQ(message_of(small + curve), "no error");
  EXPECT_NE(message_of(small + curve + "hub_heigt_m: 3\n").find("'hub_height_m'"),
            std::string::npos);
}

TEST(TurbineFile, WithABrokenCurveIsRefusedWithTheReason) {
  const auto curve = [](const std::string& speed, const std::string& cp, const std::string& ct) {
    return message_of(small + ("wind_speed_m_s: [" + speed + "]\npower_coefficient: [" + cp +
                               "]\nthrust_coefficient: [" + ct + "]\n"));
  };
  EXPECT_NE(curve("3, 20", "0.2", "0.8, 0.1").find("found 1 values beside 2"), std::string::npos);
  EXPECT_NE(curve("3, 3, 20", "0, 0, 0", "0, 0, 0").find("do not rise"), std::string::npos);
  EXPECT_NE(curve("4, 20", "0.1, 0.1", "0.8, 0.1").find("must begin at"), std::string::npos);
  EXPECT_NE(curve("3, 20", "0.7, 0.1", "0.8, 0.1").find("found 0.7"), std::string::npos);
  EXPECT_NE(curve("3, 20", "0.2, 0.1", "1.1, 0.1").find("found 1.1"), std::string::npos);
  EXPECT_NE(curve("", "", "").find("fewer than two"), std::string::npos);
}

}  // namespace
}  // namespace slackwater::turbine_test
