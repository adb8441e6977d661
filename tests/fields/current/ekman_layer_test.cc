#include "fields/current/ekman_layer.h"

#include <gtest/gtest.h>

#include "fields/current/coriolis.h"
#include "fields/current/wind_stress.h"

namespace slackwater::ekman_layer_test {
namespace {

constexpr double density = 1025.0;
double coriolis(double latitude_deg) {
  return coriolis_parameter_rad_s(Angle::from_degrees(latitude_deg));
}
Horizontal towards(double modulus, double math_deg) {
  return std::polar(modulus, Angle::from_degrees(math_deg).radians());
}

TEST(SurfaceEkmanVelocity, AgreesWithTheTableOfWorkedNumbers) {
  // nu 0.02 m2/s, tau 0.194775 Pa; six decimals printed.
  struct Row {
    double latitude_deg, wind_to_math_deg, depth_m, east, north;
  };
  for (const Row& row :
       {Row{54, 0, 0, 0.087470, -0.087470}, Row{54, 0, 5, 0.046343, -0.082108},
        Row{54, 0, 10, 0.017241, -0.069764}, Row{54, 0, 20, -0.012370, -0.039873},
        Row{54, 90, 0, 0.087470, 0.087470}, Row{54, 90, 5, 0.082108, 0.046343},
        Row{54, 30, 0, 0.119486, -0.032016}, Row{54, 30, 5, 0.081189, -0.047936},
        Row{54, 30, 10, 0.049813, -0.051796}, Row{-54, 0, 0, 0.087470, 0.087470},
        Row{-54, 0, 5, 0.046343, 0.082108}, Row{-54, 90, 10, -0.069764, 0.017241}}) {
    const Horizontal w = surface_ekman_velocity(towards(0.194775, row.wind_to_math_deg), 0.02,
                                                coriolis(row.latitude_deg), density, row.depth_m);
    EXPECT_NEAR(w.real(), row.east, 1e-6);
    EXPECT_NEAR(w.imag(), row.north, 1e-6);
  }
}

TEST(SurfaceEkmanVelocity, TenMetresPerSecondAtFortyMetresEkmanDepthGiveSeventeenCentimetres) {
  const double f = coriolis(55);
  const double viscosity = eddy_viscosity_of_ekman_depth_m2_s(40.0, f);
  EXPECT_NEAR(ekman_depth_m(viscosity, f), 40.0, 1e-12);
  const double speed =
      std::abs(surface_ekman_velocity(wind_stress_pa({10, 0}), viscosity, f, density, 0));
  EXPECT_NEAR(speed, 0.176, 0.01 * 0.176);
}

TEST(SurfaceEkmanVelocity, DividesByTheDensityNotByItsRoot) {
  // A public code divides by sqrt(rho), 32 times too large: latitude 43, D = 5 m, 1 m/s of wind
  // gave 0.297 m/s.
  const double f = coriolis(43);
  const double viscosity = eddy_viscosity_of_ekman_depth_m2_s(5.0, f);
  const double speed =
      std::abs(surface_ekman_velocity(wind_stress_pa({1, 0}), viscosity, f, density, 0));
  EXPECT_NEAR(speed, 0.0093, 0.00005);
  const double heavier =
      std::abs(surface_ekman_velocity(wind_stress_pa({1, 0}), viscosity, f, 4 * density, 0));
  EXPECT_NEAR(heavier, speed / 4, 1e-15);
}

TEST(SurfaceEkmanVelocity, TurningTheStressTurnsTheWholeSpiral) {
  for (const double latitude_deg : {54.0, -35.0}) {
    const double f = coriolis(latitude_deg);
    for (const double depth_m : {0.0, 3.0, 17.0, 60.0}) {
      const Horizontal east = surface_ekman_velocity({0.2, 0}, 0.02, f, density, depth_m);
      for (double deg = 0; deg < 360; deg += 11) {
        const Horizontal turned =
            surface_ekman_velocity(towards(0.2, deg), 0.02, f, density, depth_m);
        EXPECT_LT(std::abs(turned - east * towards(1, deg)), 1e-12);
      }
    }
  }
}

TEST(SurfaceEkmanVelocity, SpeedAtADepthDoesNotDependOnTheWindsDirection) {
  // The published components turn by opposite signs of the wind's angle: their speed would run from
  // 0 to 1.414.
  const double f = coriolis(54);
  const double speed = std::abs(surface_ekman_velocity({0.2, 0}, 0.02, f, density, 4));
  for (double deg = -180; deg <= 180; deg += 15) {
    EXPECT_NEAR(std::abs(surface_ekman_velocity(towards(0.2, deg), 0.02, f, density, 4)), speed,
                1e-15);
  }
}

TEST(SurfaceEkmanVelocity, TransportIsStressOverRhoFAtARightAngle) {
  for (const double latitude_deg : {54.0, -54.0, 20.0}) {
    for (const double viscosity : {0.005, 0.02, 0.3}) {
      const double f = coriolis(latitude_deg);
      const double step_m =
          ekman_scale_m(viscosity, f) / 500;  // midpoint rule: error (1/500)^2/24, far below 0.1 %
      Horizontal transport{};
      for (int i = 0; i < 20000; ++i) {
        transport += step_m * surface_ekman_velocity({0.194775, 0}, viscosity, f, density,
                                                     (i + 0.5) * step_m);
      }
      const Horizontal expected{0, -0.194775 / (density * f)};  // right for f > 0, left for f < 0
      EXPECT_LT(std::abs(transport - expected), 1e-3 * std::abs(expected))
          << latitude_deg << ' ' << viscosity;
    }
  }
  EXPECT_NEAR(-0.194775 / (density * coriolis(54)), -1.6105276982, 1e-9);
}

TEST(SurfaceEkmanVelocity, LiesFortyFiveDegreesBesideTheWindAtTheSurface) {
  for (const double viscosity : {0.001, 0.02, 0.5}) {
    EXPECT_NEAR(std::arg(surface_ekman_velocity({0.1, 0}, viscosity, coriolis(54), density, 0)),
                -constants::pi / 4, 1e-14);
    EXPECT_NEAR(std::arg(surface_ekman_velocity({0.1, 0}, viscosity, coriolis(-54), density, 0)),
                constants::pi / 4, 1e-14);
  }
}

TEST(SurfaceEkmanVelocity, MirrorsInTheSouthernHemisphere) {
  for (double depth_m = 0; depth_m < 80; depth_m += 6.5) {
    const Horizontal north =
        surface_ekman_velocity({0.1, 0.07}, 0.02, coriolis(47), density, depth_m);
    const Horizontal south =
        surface_ekman_velocity({0.1, -0.07}, 0.02, coriolis(-47), density, depth_m);
    EXPECT_LT(std::abs(south - std::conj(north)), 1e-15);
  }
}

TEST(SurfaceEkmanVelocity, SolvesTheEkmanEquation) {
  const double f = coriolis(54);
  const double viscosity = 0.02;
  const double h = 0.05;
  const auto w = [&](double d) {
    return surface_ekman_velocity({0.15, 0.1}, viscosity, f, density, d);
  };
  for (double d = 1; d < 60; d += 7) {
    const Horizontal second = (w(d + h) - 2.0 * w(d) + w(d - h)) / (h * h);
    // Truncation h^2/12 |W''''| = h^2/12 |lambda|^2 |W''|: 1e-6 of the term; rounding 1e-16/h^2.
    EXPECT_LT(std::abs(viscosity * second - Horizontal(0, f) * w(d)), 3e-6 * f * std::abs(w(0)));
  }
  // The stress at the surface is the wind's: rho nu dW/dz, z up.
  const Horizontal stress = density * viscosity * (w(0) - w(1e-5)) / 1e-5;
  EXPECT_LT(std::abs(stress - Horizontal(0.15, 0.1)), 1e-6);
}

}  // namespace
}  // namespace slackwater::ekman_layer_test
