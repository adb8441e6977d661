#include "calibration/blend/past_pair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"

namespace slackwater::calibration::past_pair_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<Horizontal> random_errors(std::size_t n, std::string_view stream) {
  Rng random(7, stream);
  std::vector<Horizontal> errors(n);
  for (Horizontal& error : errors) error = {random.normal(), random.normal()};
  return errors;
}

TEST(PairOfErrors, TheFormIsTheMeanSquareErrorOfAnyBlend) {
  const std::vector<std::vector<Horizontal>> errors{random_errors(50, "a"), random_errors(50, "b"),
                                                    random_errors(50, "c")};
  const PastPair pair = pair_of_errors(errors, 3.0);
  const Eigen::Vector3d w(0.2, 0.5, 0.3);
  double square = 0;
  for (std::size_t i = 0; i < 50; ++i) {
    square += std::norm(w[0] * errors[0][i] + w[1] * errors[1][i] + w[2] * errors[2][i]) / 50.0;
  }
  EXPECT_NEAR(w.dot(pair.gram * w), square, 1e-14);
  EXPECT_EQ(pair.values, 50u);
  EXPECT_EQ(pair.age_days, 3.0);
}

TEST(PairOfErrors, TurningTheAxesChangesNothing) {
  std::vector<std::vector<Horizontal>> errors{random_errors(40, "a"), random_errors(40, "b")};
  const PastPair before = pair_of_errors(errors, 0.0);
  const Horizontal turn = std::polar(1.0, 0.7);
  for (auto& of_one : errors) {
    for (Horizontal& error : of_one) error *= turn;
  }
  EXPECT_TRUE(pair_of_errors(errors, 0.0).gram.isApprox(before.gram, 1e-14));
}

TEST(PairOfErrors, CountsTheValuesThatAllHave) {
  std::vector<std::vector<Horizontal>> errors{random_errors(40, "a"), random_errors(40, "b"), {}};
  errors[0][3] = nan;
  errors[1][7] = {0.0, nan};
  const PastPair pair = pair_of_errors(errors, 0.0);
  EXPECT_EQ(pair.values, 38u);
  EXPECT_EQ(pair.present, (std::vector<bool>{true, true, false}));
  double square = 0;
  for (std::size_t i = 0; i < 40; ++i) {
    if (i != 3 && i != 7) square += std::norm(errors[0][i]) / 38.0;
  }
  EXPECT_NEAR(pair.gram(0, 0), square, 1e-14);
}

TEST(PairOfErrors, ACandidateWithManyGapsIsAbsentAndDoesNotThinTheRest) {
  std::vector<std::vector<Horizontal>> errors{random_errors(40, "a"), random_errors(40, "b")};
  for (std::size_t i = 0; i < 5; ++i) errors[1][i] = nan;
  const PastPair pair = pair_of_errors(errors, 0.0);
  EXPECT_EQ(pair.present, (std::vector<bool>{true, false}));
  EXPECT_EQ(pair.values, 40u);
}

TEST(WithoutUnusable, WhatIsNotFiniteIsAbsent) {
  PastPair pair;
  pair.values = 10;
  pair.present = {true, true, true, true};
  pair.gram = Eigen::MatrixXd::Identity(4, 4);
  pair.gram(1, 1) = std::numeric_limits<double>::infinity();
  pair.gram(0, 3) = nan;  // 0 and 3: the later goes
  const PastPair checked = without_unusable(pair);
  EXPECT_EQ(checked.present, (std::vector<bool>{true, false, true, false}));
}

TEST(WithoutUnusable, OneBadRowDoesNotTakeTheOthersWithIt) {
  PastPair pair;
  pair.values = 10;
  pair.present = {true, true, true};
  pair.gram = Eigen::MatrixXd::Identity(3, 3);
  pair.gram(0, 1) = pair.gram(1, 0) = nan;
  pair.gram(0, 2) = pair.gram(2, 0) = nan;
  EXPECT_EQ(without_unusable(pair).present, (std::vector<bool>{false, true, true}));
}

TEST(WithoutUnusable, NoValuesAreNoEvidenceAndTheFutureIsABug) {
  PastPair pair;
  pair.present = {true};
  pair.gram = Eigen::MatrixXd::Zero(1, 1);
  EXPECT_EQ(without_unusable(pair).present, (std::vector<bool>{false}));
  pair.age_days = -1.0;
  EXPECT_THROW((void)without_unusable(pair), ContractViolation);
}

}  // namespace
}  // namespace slackwater::calibration::past_pair_test
