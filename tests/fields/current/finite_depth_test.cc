#include "fields/current/finite_depth.h"

#include <gtest/gtest.h>

#include "fields/current/coriolis.h"
#include "fields/current/ekman_layer.h"

namespace slackwater::finite_depth_test {
namespace {

constexpr double density = 1025.0;
using FiniteDepth = FiniteDepthColumn<double>;
double coriolis(double latitude_deg) {
  return coriolis_parameter_rad_s(Angle::from_degrees(latitude_deg));
}
Horizontal flow(const LevelResponse<double>& r, Horizontal interior, Horizontal stress) {
  return interior * to_horizontal(r.interior) + stress * to_horizontal(r.stress);
}

struct Row {
  double depth_m, east, north;
};

TEST(FiniteDepth, NoSlipAgreesWithTheTableOfWorkedNumbers) {
  const auto column = FiniteDepth::no_slip(0.05, coriolis(54), density, 25);
  for (const Row& row : {Row{0, 0.12100636468869161, 0.15991608988535283},
                         Row{5, 0.10026309209972832, 0.1544407977891477},
                         Row{10, 0.07636607498609087, 0.13716646129960244},
                         Row{15, 0.050341324276811455, 0.10668831271831698},
                         Row{20, 0.023994412099932166, 0.06147989056531984}, Row{25, 0.0, 0.0}}) {
    const Horizontal w = flow(column.at_depth(row.depth_m), {0.3, 0.1}, 0.194775);
    EXPECT_NEAR(w.real(), row.east, 1e-9);
    EXPECT_NEAR(w.imag(), row.north, 1e-9);
  }
  const Horizontal mean = flow(column.depth_mean(), {0.3, 0.1}, 0.194775);
  EXPECT_NEAR(mean.real(), 0.06233957731484625, 1e-9);
  EXPECT_NEAR(mean.imag(), 0.10911504294137284, 1e-9);
}

TEST(FiniteDepth, LinearBottomStressAgreesWithTheTableOfWorkedNumbers) {
  const auto column = FiniteDepth::linear_bottom_stress(0.05, 5e-4, coriolis(54), density, 25);
  for (const Row& row : {Row{0, 0.32898592664491094, 0.07632357789553967},
                         Row{10, 0.2937245553676045, 0.07830338056779915},
                         Row{25, 0.25042531832315784, 0.07641819474290955}}) {
    const Horizontal w = flow(column.at_depth(row.depth_m), {0.3, 0.1}, 0.194775);
    EXPECT_NEAR(w.real(), row.east, 1e-9);
    EXPECT_NEAR(w.imag(), row.north, 1e-9);
  }
}

TEST(FiniteDepth, DeepWaterIsTheInfiniteSpiral) {
  for (const double latitude_deg : {54.0, -30.0}) {
    const double f = coriolis(latitude_deg);
    for (const double depth_of_water_m :
         {1000.0, 11000.0, 1e6}) {  // the last has |lambda| H of 7e4
      const auto column =
          FiniteDepth::linear_bottom_stress(0.02, 5e-4, f, density, depth_of_water_m);
      for (const double d : {0.0, 5.0, 20.0, 90.0}) {
        const LevelResponse<double> r = column.at_depth(d);
        const Complex<double> spiral = surface_ekman_response(0.02, f, density, d);
        EXPECT_LT(std::abs(to_horizontal(r.stress - spiral)), 1e-13);
        EXPECT_LT(std::abs(to_horizontal(r.interior) - 1.0), 1e-12);
      }
    }
  }
}

TEST(FiniteDepth, InfiniteFrictionIsNoSlip) {
  const double f = coriolis(54);
  const auto still = FiniteDepth::no_slip(0.05, f, density, 30);
  double last = 1;
  for (const double friction : {1.0, 1e2, 1e4, 1e6}) {
    const auto column = FiniteDepth::linear_bottom_stress(0.05, friction, f, density, 30);
    double worst = 0;
    for (double d = 0; d <= 30; d += 3) {
      worst = std::max(
          worst, std::abs(to_horizontal(column.at_depth(d).interior - still.at_depth(d).interior)));
      worst = std::max(
          worst, std::abs(to_horizontal(column.at_depth(d).stress - still.at_depth(d).stress)));
    }
    EXPECT_LT(worst, 0.011 * last);  // first order in 1/r: each step of 100 gains two digits
    last = worst;
  }
  EXPECT_LT(last, 1e-8);
}

TEST(FiniteDepth, SolvesTheEkmanEquationAndItsBoundaryConditions) {
  const Horizontal interior{0.3, 0.1};
  const Horizontal stress{0.12, -0.2};
  for (const double latitude_deg : {54.0, -35.0}) {
    for (const double depth_of_water_m : {8.0, 35.0, 200.0}) {
      const double f = coriolis(latitude_deg);
      const double viscosity = 0.04;
      const double friction = 7e-4;
      const auto column =
          FiniteDepth::linear_bottom_stress(viscosity, friction, f, density, depth_of_water_m);
      const auto w = [&](double d) { return flow(column.at_depth(d), interior, stress); };
      const double h = 0.02;
      for (double d = 0.5; d < depth_of_water_m; d += depth_of_water_m / 9.7) {
        const Horizontal second = (w(d + h) - 2.0 * w(d) + w(d - h)) / (h * h);
        EXPECT_LT(std::abs(viscosity * second - Horizontal(0, f) * (w(d) - interior)),
                  1e-5 * std::abs(f));
      }
      // One-sided differences of second order, z up.
      const Horizontal top = (3.0 * w(0) - 4.0 * w(h) + w(2 * h)) / (2 * h);
      EXPECT_LT(std::abs(density * viscosity * top - stress), 1e-5);
      const double bed = depth_of_water_m;
      const Horizontal foot = (-3.0 * w(bed) + 4.0 * w(bed - h) - w(bed - 2 * h)) / (2 * h);
      EXPECT_LT(std::abs(viscosity * foot - friction * w(bed)), 1e-8);
    }
  }
}

TEST(FiniteDepth, TheDepthMeanIsTheIntegralOverTheDepth) {
  for (const double friction : {2e-4, 5e-3, 1e9}) {
    const auto column =
        FiniteDepth::linear_bottom_stress(0.03, friction, coriolis(50), density, 45);
    constexpr int n = 20000;
    Horizontal interior{};
    Horizontal stress{};
    for (int i = 0; i < n; ++i) {
      const LevelResponse<double> r = column.at_depth(45.0 * (i + 0.5) / n);
      interior += to_horizontal(r.interior) / static_cast<double>(n);
      stress += to_horizontal(r.stress) / static_cast<double>(n);
    }
    EXPECT_LT(std::abs(interior - to_horizontal(column.depth_mean().interior)), 1e-8);
    EXPECT_LT(std::abs(stress - to_horizontal(column.depth_mean().stress)), 1e-8);
  }
}

TEST(FiniteDepth, ShallowStiffWaterMovesAsOneBody) {
  // |lambda| H = 5e-3: without care for small arguments the responses would lose their digits. The
  // exact limit is a slab of thickness H under friction r: W = (T/rho + i f H W_g)/(r + i f H),
  // corrected by O(r H/nu).
  const double f = coriolis(54);
  const double viscosity = 1.0;
  const double water_m = 0.5;
  const double friction = 5e-5;
  const auto column = FiniteDepth::linear_bottom_stress(viscosity, friction, f, density, water_m);
  const Horizontal denominator{friction, f * water_m};
  for (const double d : {0.0, 0.25, 0.5}) {
    EXPECT_LT(std::abs(to_horizontal(column.at_depth(d).interior) -
                       Horizontal(0, f * water_m) / denominator),
              1e-4);
    EXPECT_LT(std::abs(to_horizontal(column.at_depth(d).stress) * denominator * density - 1.0),
              1e-4);
  }
}

TEST(FiniteDepth, MirrorsInTheSouthernHemisphere) {
  const auto north = FiniteDepth::linear_bottom_stress(0.05, 5e-4, coriolis(47), density, 30);
  const auto south = FiniteDepth::linear_bottom_stress(0.05, 5e-4, coriolis(-47), density, 30);
  for (double d = 0; d <= 30; d += 2.5) {
    EXPECT_LT(std::abs(to_horizontal(north.at_depth(d).stress) -
                       std::conj(to_horizontal(south.at_depth(d).stress))),
              1e-16);
    EXPECT_LT(std::abs(to_horizontal(north.at_depth(d).interior) -
                       std::conj(to_horizontal(south.at_depth(d).interior))),
              1e-15);
  }
}

}  // namespace
}  // namespace slackwater::finite_depth_test
