#include "calibration/residuals/level_velocity.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "fields/base/random.h"

namespace slackwater::calibration {
namespace {

const std::array<double, 4> depths{0.5, 8, 21, 33};

struct Case {
  SteadyForm form;
  Angle latitude;
  std::array<double, 5> parameters;
};

std::array<double, 2> residual_of(const Case& c, const std::array<double, 5>& p,
                                  const LevelVelocity& pair, std::size_t count, double* jacobian) {
  std::array<ResponseDerivatives, 4> response;
  response_derivatives(c.form, p[log_eddy_viscosity], p[log_bottom], c.latitude, 35.0, depths,
                       response);
  const double factor = count > log_stress_factor ? std::exp(p[log_stress_factor]) : 1.0;
  std::array<double, 2> r{};
  level_velocity_residual(pair, response[pair.level], p.data(), count, factor, 0.03, r.data(),
                          jacobian);
  return r;
}

std::vector<Case> random_cases() {
  Rng rng(5, "level_velocity");
  std::vector<Case> cases;
  for (int i = 0; i < 40; ++i) {
    cases.push_back({i % 2 == 0 ? SteadyForm::finite_depth : SteadyForm::three_layer,
                     Angle::from_degrees(rng.uniform(3.5, 80) * (i % 3 == 0 ? -1 : 1)),
                     {rng.normal(), rng.normal(), rng.uniform(std::log(1e-4), 0),
                      rng.uniform(std::log(1e-5), std::log(2e-2)), rng.uniform(-1, 1)}});
  }
  return cases;
}

TEST(LevelVelocityResidual, JacobianAgreesWithFiniteDifferences) {
  for (const Case& c : random_cases()) {
    for (std::size_t level = 0; level < depths.size(); ++level) {
      const LevelVelocity pair{{0.1, -0.3}, {0.21, -0.13}, level};
      for (const std::size_t count : {2u, 4u, 5u}) {
        std::array<double, 10> jacobian{};
        (void)residual_of(c, c.parameters, pair, count, jacobian.data());
        for (std::size_t i = 0; i < count; ++i) {
          // Central differences of step h: truncation about h^2, rounding about 1e-16 |r|/h; h =
          // 1e-5 balances them.
          const double h = 1e-5;
          std::array<double, 5> up = c.parameters;
          std::array<double, 5> down = c.parameters;
          up[i] += h;
          down[i] -= h;
          const auto r_up = residual_of(c, up, pair, count, nullptr);
          const auto r_down = residual_of(c, down, pair, count, nullptr);
          for (std::size_t row = 0; row < 2; ++row) {
            const double difference = (r_up[row] - r_down[row]) / (2 * h);
            EXPECT_NEAR(jacobian[row * count + i], difference, 1e-7 * (100 + std::abs(difference)))
                << name_of(c.form) << " parameter " << i << " level " << level;
          }
        }
      }
    }
  }
}

TEST(LevelVelocityResidual, IsModelMinusObservationInStandardDeviations) {
  const Case c{SteadyForm::finite_depth,
               Angle::from_degrees(54),
               {0.2, 0.1, std::log(0.02), std::log(5e-4), std::log(1.2)}};
  SteadyParameters p;
  p.interior_east_m_s = 0.2;
  p.interior_north_m_s = 0.1;
  p.eddy_viscosity_m2_s = 0.02;
  p.bottom_friction_m_s = 5e-4;
  p.stress_factor = 1.2;
  const LevelResponses responses = level_responses(c.form, p, c.latitude, 35, depths);
  const std::vector<Horizontal> stress{{0.1, 0.2}};
  std::vector<Horizontal> model(depths.size());
  evaluate_steady(responses, p.interior_m_s(), stress, model);
  for (std::size_t level = 0; level < depths.size(); ++level) {
    const auto r = residual_of(c, c.parameters, {{0.05, -0.02}, stress[0], level}, 5, nullptr);
    EXPECT_NEAR(r[0], (model[level].real() - 0.05) / 0.03, 1e-12);
    EXPECT_NEAR(r[1], (model[level].imag() + 0.02) / 0.03, 1e-12);
  }
}

TEST(ResponseDerivatives, TheValuesAreThoseTheServiceEvaluates) {
  for (const Case& c : random_cases()) {
    std::array<ResponseDerivatives, 4> dual;
    response_derivatives(c.form, c.parameters[2], c.parameters[3], c.latitude, 35, depths, dual);
    SteadyParameters p;
    p.eddy_viscosity_m2_s = std::exp(c.parameters[2]);
    p.bottom_friction_m_s = p.bottom_eddy_viscosity_m2_s = std::exp(c.parameters[3]);
    const LevelResponses served = level_responses(c.form, p, c.latitude, 35, depths);
    for (std::size_t k = 0; k < depths.size(); ++k) {
      EXPECT_LT(std::abs(to_horizontal(dual[k].interior) - served.interior(k)), 1e-13);
      EXPECT_LT(std::abs(to_horizontal(dual[k].stress) - served.stress(k)),
                1e-13 * (1 + std::abs(served.stress(k))));
    }
  }
}

TEST(ResponseDerivatives, VanishInTheEquatorialBand) {
  std::array<ResponseDerivatives, 4> dual;
  response_derivatives(SteadyForm::finite_depth, -4, -7, Angle::from_degrees(1), 35, depths, dual);
  for (const ResponseDerivatives& d : dual) {
    EXPECT_EQ(to_horizontal(d.interior), Horizontal(1, 0));
    EXPECT_EQ(to_horizontal(d.stress), Horizontal(0, 0));
    EXPECT_EQ(to_horizontal(d.interior_by_log_viscosity), Horizontal(0, 0));
    EXPECT_EQ(to_horizontal(d.stress_by_log_bottom), Horizontal(0, 0));
  }
}

}  // namespace
}  // namespace slackwater::calibration
