#include "fields/current/steady_column.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/numbers/random.h"

namespace slackwater::steady_column_test {
namespace {

const std::vector<SteadyForm> both_forms{SteadyForm::three_layer, SteadyForm::finite_depth};
const std::vector<SteadyForm> all_forms{SteadyForm::three_layer, SteadyForm::finite_depth,
                                        SteadyForm::mixed_layer};

SteadyParameters typical() {
  SteadyParameters p;
  p.interior_east_m_s = 0.2;
  p.interior_north_m_s = -0.1;
  p.eddy_viscosity_m2_s = 0.02;
  p.bottom_eddy_viscosity_m2_s = 0.004;
  p.stress_factor = 1.1;
  return p;
}

std::vector<Horizontal> profile(SteadyForm form, const SteadyParameters& p, double latitude_deg,
                                double water_m, const std::vector<double>& depths,
                                Horizontal stress) {
  const LevelResponses responses =
      level_responses(form, p, Angle::from_degrees(latitude_deg), water_m, depths);
  std::vector<Horizontal> out;
  for (std::size_t k = 0; k < depths.size(); ++k)
    out.push_back(p.interior_m_s() * responses.interior(k) + stress * responses.stress(k));
  return out;
}

std::vector<double> every(double step_m, double to_m) {
  std::vector<double> depths;
  for (int i = 0; i * step_m <= to_m; ++i) depths.push_back(i * step_m);
  return depths;
}

TEST(SteadyColumn, TurningWindAndInteriorTurnsTheProfile) {
  Rng rng(11, "steady_column/turn");
  const std::vector<double> depths = every(3.7, 120);
  for (const SteadyForm form : all_forms) {
    for (int i = 0; i < 50; ++i) {
      SteadyParameters p = typical();
      p.eddy_viscosity_m2_s = std::exp(rng.uniform(-8, 0));
      p.bottom_friction_m_s = p.base_friction_m_s = std::exp(rng.uniform(-11, -4));
      p.mixed_layer_depth_m = std::exp(rng.uniform(1, 5));
      const double latitude_deg = rng.uniform(3.1, 89) * (rng.uniform() < 0.5 ? -1 : 1);
      const Horizontal stress{rng.uniform(-1, 1), rng.uniform(-1, 1)};
      const Horizontal turn = std::polar(1.0, rng.uniform(0, 2 * constants::pi));
      SteadyParameters turned = p;
      turned.interior_east_m_s = (turn * p.interior_m_s()).real();
      turned.interior_north_m_s = (turn * p.interior_m_s()).imag();
      const auto before = profile(form, p, latitude_deg, 120, depths, stress);
      const auto after = profile(form, turned, latitude_deg, 120, depths, turn * stress);
      for (std::size_t k = 0; k < depths.size(); ++k) {
        // Largest speeds here are about 10 m/s (1 Pa on thin layers); the lock is for unit speeds.
        EXPECT_LT(std::abs(after[k] - turn * before[k]),
                  1e-12 * std::max(1.0, std::abs(before[k])));
      }
    }
  }
}

TEST(SteadyColumn, HasNoJumpAnywhereBetweenSurfaceAndBed) {
  const double step_m = 0.01;
  for (const SteadyForm form : all_forms) {
    for (const double water_m : {35.0, 230.0, 400.0}) {
      const std::vector<double> depths = every(step_m, water_m);
      const auto w = profile(form, typical(), 54, water_m, depths, {0.2, 0.1});
      // Shear is bounded by the thinnest layer: |dW/dz| <= |lambda_b| |W_g| + |T|/(rho nu).
      const double thin_m = ekman_scale_m(0.004, coriolis_parameter_rad_s(Angle::from_degrees(54)));
      const double shear = std::sqrt(2.0) / thin_m * 0.4 + 0.25 * 1.1 / (1025 * 0.02);
      for (std::size_t k = 1; k < w.size(); ++k)
        EXPECT_LT(std::abs(w[k] - w[k - 1]), shear * step_m);
    }
  }
}

TEST(SteadyColumn, TheThreeLayersAreSpiralInteriorAndBedLayer) {
  const SteadyParameters p = typical();
  const double f = coriolis_parameter_rad_s(Angle::from_degrees(54));
  const auto w = profile(SteadyForm::three_layer, p, 54, 400, {0, 10, 180, 398, 400}, {0.2, 0.1});
  const auto surface = [&](double d) {
    return surface_ekman_velocity(1.1 * Horizontal(0.2, 0.1), p.eddy_viscosity_m2_s, f, 1025, d);
  };
  EXPECT_LT(std::abs(w[0] - p.interior_m_s() - surface(0)), 1e-12);
  EXPECT_LT(std::abs(w[1] - p.interior_m_s() - surface(10)), 1e-12);
  EXPECT_LT(std::abs(w[2] - p.interior_m_s()),
            2e-5);  // three Ekman depths down: e^{-3 pi} of 0.15 m/s
  EXPECT_LT(
      std::abs(w[3] - bottom_ekman_velocity(p.interior_m_s(), p.bottom_eddy_viscosity_m2_s, f, 2)),
      1e-9);
  EXPECT_LT(std::abs(w[4]), 1e-9);
}

TEST(SteadyColumn, BothFormsAgreeInDeepWaterAwayFromTheBed) {
  const std::vector<double> depths = every(5, 150);
  const auto layered = profile(SteadyForm::three_layer, typical(), 47, 3000, depths, {0.1, -0.3});
  const auto finite = profile(SteadyForm::finite_depth, typical(), 47, 3000, depths, {0.1, -0.3});
  for (std::size_t k = 0; k < depths.size(); ++k)
    EXPECT_LT(std::abs(layered[k] - finite[k]), 1e-12);
}

TEST(SteadyColumn, AMixedLayerAsDeepAsTheWaterIsTheFiniteColumnWithoutItsFrictionOnTheInterior) {
  SteadyParameters p = typical();
  p.mixed_layer_depth_m = 45;
  p.base_friction_m_s = p.bottom_friction_m_s;
  const std::vector<double> depths = every(1.5, 45);
  for (const double latitude_deg : {54.0, -35.0}) {
    const Angle latitude = Angle::from_degrees(latitude_deg);
    const auto mixed = level_responses(SteadyForm::mixed_layer, p, latitude, 45, depths);
    const auto finite = level_responses(SteadyForm::finite_depth, p, latitude, 45, depths);
    for (std::size_t k = 0; k < depths.size(); ++k) {
      EXPECT_EQ(mixed.stress(k), finite.stress(k));
      EXPECT_EQ(mixed.interior(k), Horizontal(1, 0));
    }
  }
}

TEST(SteadyColumn, BelowTheMixedLayerTheWindsPartDiesOutOverAQuarterOfIt) {
  SteadyParameters p = typical();
  p.mixed_layer_depth_m = 20;
  const auto r = level_responses(SteadyForm::mixed_layer, p, Angle::from_degrees(54), 90,
                                 std::vector<double>{20, 20.0001, 25, 30, 60});
  EXPECT_LT(std::abs(r.stress(1) - r.stress(0)), 3e-5 * std::abs(r.stress(0)));
  for (std::size_t k = 2; k < 5; ++k) {
    const Horizontal left = r.stress(0) * std::exp(-(r.depth_m[k] - 20) / 5.0);
    EXPECT_LT(std::abs(r.stress(k) - left), 1e-15);
  }
}

TEST(SteadyColumn, TheTransportOfTheMixedLayerIsThatOfTheStressLessTheDragOnItsBase) {
  // i f Int W dz = T/rho - r W(h) over the layer, Simpson's rule.
  const SteadyParameters p = typical();
  const double f = coriolis_parameter_rad_s(Angle::from_degrees(54));
  constexpr std::size_t parts = 2000;
  std::vector<double> depths;
  for (std::size_t i = 0; i <= parts; ++i)
    depths.push_back(p.mixed_layer_depth_m * static_cast<double>(i) / parts);
  const auto r = level_responses(SteadyForm::mixed_layer, p, Angle::from_degrees(54), 90, depths);
  Horizontal transport{};
  for (std::size_t i = 0; i <= parts; ++i) {
    const double weight = i == 0 || i == parts ? 1 : i % 2 == 1 ? 4 : 2;
    transport += weight / 3.0 * p.mixed_layer_depth_m / parts * r.stress(i);
  }
  const Horizontal force = p.stress_factor / 1025 - p.base_friction_m_s * r.stress(parts);
  EXPECT_LT(std::abs(Horizontal(0, f) * transport - force), 1e-9 * std::abs(force));
}

TEST(SteadyColumn, MirrorsBetweenTheHemispheres) {
  const std::vector<double> depths = every(7, 100);
  for (const SteadyForm form : all_forms) {
    SteadyParameters mirrored = typical();
    mirrored.interior_north_m_s = -mirrored.interior_north_m_s;
    const auto north = profile(form, typical(), 40, 100, depths, {0.2, 0.1});
    const auto south = profile(form, mirrored, -40, 100, depths, {0.2, -0.1});
    for (std::size_t k = 0; k < depths.size(); ++k)
      EXPECT_LT(std::abs(north[k] - std::conj(south[k])), 1e-14);
  }
}

TEST(SteadyColumn, TheFiniteFormIsChosenWhereverTheLayersCanMeet) {
  const Angle north_sea = Angle::from_degrees(54);
  EXPECT_EQ(default_form(35, north_sea), SteadyForm::finite_depth);
  EXPECT_EQ(default_form(3800, north_sea), SteadyForm::three_layer);
  const double meet_m = 4 * ekman_depth_m(0.02, coriolis_parameter_rad_s(north_sea));
  EXPECT_EQ(default_form(meet_m * 0.999, north_sea, 0.02), SteadyForm::finite_depth);
  EXPECT_EQ(default_form(meet_m * 1.001, north_sea, 0.02), SteadyForm::three_layer);
  EXPECT_EQ(default_form(3800, Angle::from_degrees(-1)), SteadyForm::finite_depth);
}

TEST(SteadyColumn, InTheEquatorialBandOnlyTheInteriorIsLeft) {
  for (const SteadyForm form : all_forms) {
    for (const double latitude_deg : {0.0, 1.0, -2.9}) {
      for (const Horizontal w :
           profile(form, typical(), latitude_deg, 50, {0, 10, 49, 50}, {5, 5})) {
        EXPECT_EQ(w, typical().interior_m_s());
      }
    }
  }
}

TEST(SteadyColumn, BelowTheBedTheValueOnTheBedHolds) {
  for (const SteadyForm form : both_forms) {
    const auto w = profile(form, typical(), 54, 40, {40, 40.5, 60}, {0.2, 0});
    EXPECT_EQ(w[0], w[1]);
    EXPECT_EQ(w[0], w[2]);
  }
}

TEST(SteadyColumn, StaysFiniteForEveryParameterWithinTheBounds) {
  const std::vector<double> depths{0, 1, 50, 5000, 11000};
  for (const SteadyForm form : all_forms) {
    for (const double viscosity : {1e-4, 1e-2, 1.0}) {
      for (const double friction : {1e-5, 2e-2}) {
        for (const double latitude_deg : {-89.0, 3.01, 54.0}) {
          for (const double water_m : {1.0, 11000.0}) {
            SteadyParameters p = typical();
            p.eddy_viscosity_m2_s = viscosity;
            p.bottom_friction_m_s = p.base_friction_m_s = friction;
            p.mixed_layer_depth_m = viscosity < 1e-3 ? 300 : 3;
            p.bottom_eddy_viscosity_m2_s = viscosity;
            for (const Horizontal w : profile(form, p, latitude_deg, water_m, depths, {1, 1})) {
              EXPECT_TRUE(std::isfinite(w.real()) && std::isfinite(w.imag()));
            }
          }
        }
      }
    }
  }
}

TEST(SteadyColumn, ABrokenPreconditionIsAContractViolation) {
  SteadyParameters p = typical();
  p.eddy_viscosity_m2_s = 0;
  const std::vector<double> depths{0};
  EXPECT_THROW(
      (void)level_responses(SteadyForm::finite_depth, p, Angle::from_degrees(54), 30, depths),
      ContractViolation);
  EXPECT_THROW((void)level_responses(SteadyForm::finite_depth, typical(), Angle::from_degrees(54),
                                     0, depths),
               ContractViolation);
}

}  // namespace
}  // namespace slackwater::steady_column_test
