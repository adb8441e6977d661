#include "calibration/residuals/prior.h"

#include <gtest/gtest.h>

namespace slackwater::calibration::prior_test {
namespace {

TEST(PriorResidual, CountsStandardDeviationsFromTheMean) {
  const Prior prior{-3.5, 1.2};
  EXPECT_EQ(prior.residual(-3.5), 0.0);
  EXPECT_NEAR(prior.residual(-2.3), 1.0, 1e-15);
  EXPECT_NEAR(prior.residual(-5.9), -2.0, 1e-15);
}

TEST(PriorResidual, DerivativeAgreesWithFiniteDifferences) {
  for (const double sigma : {1e-3, 0.3, 1.0, 40.0}) {
    const Prior prior{0.7, sigma};
    const double h = 1e-4 * sigma;
    const double difference = (prior.residual(0.2 + h) - prior.residual(0.2 - h)) / (2 * h);
    EXPECT_NEAR(prior.derivative() / difference, 1.0, 1e-9);
  }
}

}  // namespace
}  // namespace slackwater::calibration::prior_test
