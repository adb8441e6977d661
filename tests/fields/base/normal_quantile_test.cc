#include "fields/base/numbers/normal_quantile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::normal_quantile_test {
namespace {

TEST(NormalQuantile, IsThatOfTables) {
  EXPECT_EQ(normal_quantile(0.5), 0);
  EXPECT_NEAR(normal_quantile(0.9), constants::normal_p90, 1e-15);
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_quantile(1e-6), -4.753424308822899, 1e-12);
  for (double p = 0.001; p < 1; p += 0.01)
    EXPECT_NEAR(0.5 * std::erfc(-normal_quantile(p) / std::sqrt(2.0)), p, 1e-14);
}

TEST(NormalQuantile, OfNoProbabilityIsRefused) {
  for (const double p : {0.0, 1.0, -0.1, 1.1, std::nan("")})
    EXPECT_THROW((void)normal_quantile(p), ContractViolation) << p;
}

}  // namespace
}  // namespace slackwater::normal_quantile_test
