#include "fields/current/bottom_ekman_layer.h"

#include <gtest/gtest.h>

#include "fields/current/coriolis.h"

namespace slackwater::bottom_ekman_layer_test {
namespace {

double coriolis(double latitude_deg) {
  return coriolis_parameter_rad_s(Angle::from_degrees(latitude_deg));
}

TEST(BottomEkmanVelocity, AgreesWithTheTableOfWorkedNumbers) {
  // W_g = 0.5 east, D_b = 8 m; six decimals printed.
  struct Row {
    double latitude_deg, height_m, east, north;
  };
  for (const Row& row : {Row{54, 0.5, 0.097032, 0.080155}, Row{54, 1, 0.188084, 0.129200},
                         Row{54, 2, 0.338802, 0.161198}, Row{54, 4, 0.500000, 0.103940},
                         Row{54, 8, 0.521607, 0.000000}, Row{54, 16, 0.499066, 0},
                         Row{-54, 2, 0.338802, -0.161198}}) {
    const double f = coriolis(row.latitude_deg);
    const Horizontal w = bottom_ekman_velocity({0.5, 0}, eddy_viscosity_of_ekman_depth_m2_s(8.0, f),
                                               f, row.height_m);
    EXPECT_NEAR(w.real(), row.east, 1e-6);
    EXPECT_NEAR(w.imag(), row.north, 1e-6);
  }
}

TEST(BottomEkmanVelocity, StandsStillOnTheBedAndTurnsFortyFiveDegreesJustAbove) {
  EXPECT_EQ(bottom_ekman_velocity({0.3, 0.1}, 0.01, coriolis(54), 0), Horizontal(0, 0));
  const Horizontal interior{0.3, 0.1};
  EXPECT_NEAR(std::arg(bottom_ekman_velocity(interior, 0.01, coriolis(54), 1e-6) / interior),
              constants::pi / 4, 1e-6);
  EXPECT_NEAR(std::arg(bottom_ekman_velocity(interior, 0.01, coriolis(-54), 1e-6) / interior),
              -constants::pi / 4, 1e-6);
}

TEST(BottomEkmanVelocity, TurnsWithTheInterior) {
  const Horizontal turn = std::polar(1.0, 1.234);
  for (const double h : {0.3, 2.0, 9.0}) {
    EXPECT_LT(std::abs(bottom_ekman_velocity(turn * Horizontal(0.4, 0), 0.01, coriolis(54), h) -
                       turn * bottom_ekman_velocity({0.4, 0}, 0.01, coriolis(54), h)),
              1e-12);
  }
}

TEST(BottomEkmanVelocity, SolvesTheEkmanEquation) {
  const double f = coriolis(-40);
  const double viscosity = 0.01;
  const double step = 0.05;
  const Horizontal interior{0.4, -0.2};
  const auto w = [&](double h) { return bottom_ekman_velocity(interior, viscosity, f, h); };
  for (double h = 0.5; h < 40; h += 4) {
    const Horizontal second = (w(h + step) - 2.0 * w(h) + w(h - step)) / (step * step);
    EXPECT_LT(std::abs(viscosity * second - Horizontal(0, f) * (w(h) - interior)),
              1e-5 * std::abs(f * interior));
  }
}

}  // namespace
}  // namespace slackwater::bottom_ekman_layer_test
