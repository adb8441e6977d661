#include "calibration/residuals/separable_sum.h"

#include <gtest/gtest.h>

namespace slackwater::calibration::separable_sum_test {
namespace {

TEST(SeparableSum, IsTheSumOfTheComplexProducts) {
  constexpr Eigen::Index times = 7;
  constexpr Eigen::Index levels = 5;
  SeparableSum sum(times, levels);
  for (int round = 0; round < 2;
       ++round) {  // the second after clear(): nothing is left of the first
    sum.clear();
    Eigen::MatrixXcd expected = Eigen::MatrixXcd::Zero(times, levels);
    for (int i = 0; i < 30; ++i) {  // more terms than it has room for at first
      const OverTime p = OverTime::Random(times);
      const Eigen::RowVectorXd real = Eigen::RowVectorXd::Random(levels);
      const OverLevels complex = OverLevels::Random(levels);
      sum.add(p, real);
      sum.add(p, complex);
      expected += p * (real.cast<Horizontal>() + complex);
    }
    Planes planes(2 * times, levels);
    sum.write(planes);
    // Sixty products of numbers of size one, summed in another order.
    EXPECT_LT((planes.topRows(times) - expected.real()).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_LT((planes.bottomRows(times) - expected.imag()).cwiseAbs().maxCoeff(), 1e-13);
  }
}

}  // namespace
}  // namespace slackwater::calibration::separable_sum_test
