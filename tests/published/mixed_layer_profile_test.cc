#include "tests/published/mixed_layer_profile.h"

#include <gtest/gtest.h>

#include "fields/current/coriolis.h"
#include "fields/current/ekman_layer.h"

namespace slackwater::mixed_layer_profile_test {
namespace {

constexpr double density = 1025.0;
constexpr double viscosity = 0.02;
// Rounding of a handful of operations on values below 1 m/s.
constexpr double rounding = 1e-14;

MixedLayerProfile<double> some_profile() {
  MixedLayerProfile<double> p;
  p.interior_m_s = {0.12, -0.05};
  p.shear_per_s = {2e-4, 5e-4};
  p.slab_m_s = {-0.2, 0.07};
  p.spiral_m_s = {0.09, 0.11};
  p.shape = {45.0, 7.0, 18.0, true};
  return p;
}

Horizontal at(const MixedLayerProfile<double>& p, double depth_m) {
  return to_horizontal(p.at_depth(depth_m));
}

TEST(MixedLayerProfile, WithoutSlabAndShearIsTheSurfaceEkmanLayer) {
  const Horizontal stress(0.1, -0.05);
  for (const double latitude_deg : {54.0, 10.0, -46.0}) {
    const double f = coriolis_parameter_rad_s(Angle::from_degrees(latitude_deg));
    const Complex<double> per_pascal = surface_current_per_pascal(viscosity, f, density);
    MixedLayerProfile<double> p;
    p.spiral_m_s = per_pascal * Complex<double>{stress.real(), stress.imag()};
    p.shape = {30.0, 5.0, ekman_scale_m(viscosity, f), f > 0};
    for (const double depth_m : {0.0, 3.0, 20.0, 80.0}) {
      const Horizontal spiral =
          stress * to_horizontal(surface_ekman_response(viscosity, f, density, depth_m));
      EXPECT_NEAR(std::abs(at(p, depth_m) - spiral), 0, rounding) << latitude_deg << ' ' << depth_m;
    }
  }
}

TEST(MixedLayerProfile, SpiralTurnsClockwiseWithDepthInTheNorth) {
  MixedLayerProfile<double> p;
  p.spiral_m_s = {1.0, 0.0};
  p.shape = {30.0, 5.0, 20.0, true};
  // One radian and 1/e at one scale.
  EXPECT_NEAR(std::abs(at(p, 20.0) - std::polar(std::exp(-1.0), -1.0)), 0, rounding);
  p.shape.is_northern = false;
  EXPECT_NEAR(std::abs(at(p, 20.0) - std::polar(std::exp(-1.0), 1.0)), 0, rounding);
}

TEST(MixedLayerProfile, TurningItsVectorsTurnsTheWholeProfile) {
  const Complex<double> turn{std::cos(0.7), std::sin(0.7)};
  const MixedLayerProfile<double> p = some_profile();
  MixedLayerProfile<double> turned = p;
  for (auto* v :
       {&turned.interior_m_s, &turned.shear_per_s, &turned.slab_m_s, &turned.spiral_m_s}) {
    *v = *v * turn;
  }
  for (const double depth_m : {0.0, 10.0, 44.0, 46.0, 150.0}) {
    EXPECT_NEAR(std::abs(at(turned, depth_m) - at(p, depth_m) * to_horizontal(turn)), 0, rounding);
  }
}

TEST(MixedLayerProfile, MirrorsInTheSouthernHemisphere) {
  const MixedLayerProfile<double> p = some_profile();
  MixedLayerProfile<double> mirrored = p;
  for (auto* v :
       {&mirrored.interior_m_s, &mirrored.shear_per_s, &mirrored.slab_m_s, &mirrored.spiral_m_s}) {
    v->im = -v->im;
  }
  mirrored.shape.is_northern = false;
  for (const double depth_m : {0.0, 10.0, 44.0, 46.0, 150.0})
    EXPECT_EQ(at(mirrored, depth_m), std::conj(at(p, depth_m)));
}

TEST(MixedLayerProfile, ADeepBaseMakesTheSlabOneWithTheInterior) {
  MixedLayerProfile<double> deep = some_profile();
  deep.shape.base_depth_m = 1e6;
  MixedLayerProfile<double> merged = deep;
  merged.interior_m_s = deep.interior_m_s + deep.slab_m_s;
  merged.slab_m_s = {0.0, 0.0};
  for (const double depth_m : {0.0, 50.0, 900.0})
    EXPECT_NEAR(std::abs(at(deep, depth_m) - at(merged, depth_m)), 0, rounding);
}

TEST(MixedLayerProfile, FarBelowBaseAndSpiralOnlyTheInteriorIsLeft) {
  const MixedLayerProfile<double> p = some_profile();
  // 130 half-thicknesses and 50 scales below: e^-50 is less than rounding.
  const Horizontal interior = to_horizontal(p.interior_m_s) + to_horizontal(p.shear_per_s) * 1000.0;
  EXPECT_NEAR(std::abs(at(p, 1000.0) - interior), 0, rounding);
}

TEST(MixedLayerProfile, AVanishingSpiralScaleLeavesTheSlab) {
  MixedLayerProfile<double> p = some_profile();
  p.shape.spiral_scale_m = 1e-3;
  MixedLayerProfile<double> slab = p;
  slab.spiral_m_s = {0.0, 0.0};
  for (const double depth_m : {0.1, 10.0, 50.0})
    EXPECT_NEAR(std::abs(at(p, depth_m) - at(slab, depth_m)), 0, rounding);
}

TEST(MixedLayerShape, TheStepIsHalfDoneAtTheBaseAndTanhOneOfItWithinOneHalfThickness) {
  const MixedLayerShape<double> shape{45.0, 7.0, 18.0, true};
  EXPECT_DOUBLE_EQ(shape.at_depth(45.0).slab, 0.5);
  EXPECT_NEAR(shape.at_depth(38.0).slab - shape.at_depth(52.0).slab, std::tanh(1.0), rounding);
}

}  // namespace
}  // namespace slackwater::mixed_layer_profile_test
