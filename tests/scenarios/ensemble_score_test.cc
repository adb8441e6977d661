#include "tests/scenarios/ensemble_score.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "calibration/skill/predictive.h"
#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"

namespace slackwater::calibration::ensemble_score_test {
namespace {

std::vector<double> normals(std::size_t n, Rng& random) {
  std::vector<double> x(n);
  for (double& one : x) one = random.normal();
  return x;
}

/// Members 2p and 2p + 1 are opposite.
std::vector<double> opposite_pairs(std::size_t n, Rng& random) {
  std::vector<double> x;
  for (std::size_t p = 0; p < n / 2; ++p) {
    x.push_back(random.normal());
    x.push_back(-x.back());
  }
  return x;
}

std::vector<double> sorted(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return x;
}

TEST(EnsembleQuantile, OfEvenlySpacedMembersIsTheirRank) {
  const std::vector<double> x{1, 2, 3, 4};
  EXPECT_DOUBLE_EQ(ensemble_quantile(x, 0.2), 1.0);
  EXPECT_DOUBLE_EQ(ensemble_quantile(x, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(ensemble_quantile(x, 0.7), 3.5);
  EXPECT_EQ(ensemble_quantile(x, 0.1), 1.0) << "held beyond the outermost";
  EXPECT_EQ(ensemble_quantile(x, 0.9), 4.0);
  EXPECT_DOUBLE_EQ(probability_below(x, 2.5), 0.5);
  EXPECT_DOUBLE_EQ(probability_below(x, 3.0), 0.6);
  EXPECT_DOUBLE_EQ(probability_below(x, 0.0), 0.1);
  EXPECT_DOUBLE_EQ(probability_below(x, 9.0), 0.9);
  EXPECT_DOUBLE_EQ(probability_below(std::vector<double>{1, 2, 2, 2, 3}, 2), 0.5) << "ties";
}

TEST(EnsembleQuantile, IsTheInverseOfTheProbability) {
  Rng random(1, "tests/ensemble_quantile");
  const auto x = sorted(normals(24, random));
  for (double p = 0.05; p < 0.95; p += 0.013)
    EXPECT_NEAR(probability_below(x, ensemble_quantile(x, p)), p, 1e-12);
}

/// How often one more draw lies in the central 80 % of n members.
template <typename Draw, typename Quantile>
double coverage(const Draw& draw, const Quantile& quantile) {
  Rng random(2, "tests/ensemble_coverage");
  constexpr int cases = 40000;
  int held = 0;
  for (int c = 0; c < cases; ++c) {
    const auto x = sorted(draw(random));
    const double y = random.normal();
    held += y >= quantile(x, 0.1) && y <= quantile(x, 0.9) ? 1 : 0;
  }
  return static_cast<double>(held) / cases;
}

TEST(EnsembleQuantile, HoldsATruthThatIsOneMoreDrawWhateverTheNumberOfMembers) {
  // A share of 40000 has a standard error of 0.2 %; the line between two members adds as much.
  for (const std::size_t n : {9U, 24U, 50U}) {
    EXPECT_NEAR(coverage([n](Rng& r) { return normals(n, r); }, ensemble_quantile), 0.8, 0.007)
        << n;
  }
  const auto with_centre = [](Rng& r) {
    auto x = opposite_pairs(24, r);
    x.push_back(0.0);
    return x;
  };
  EXPECT_NEAR(coverage(with_centre, ensemble_quantile), 0.8, 0.007);
  // The rule of the spreadsheets, P(x_i) = (i - 1)/(n - 1), promises more than it holds.
  const auto rule_7 = [](const std::vector<double>& x, double p) {
    const double place = p * static_cast<double>(x.size() - 1);
    const auto low = static_cast<std::size_t>(place);
    return x[low] + (place - static_cast<double>(low)) * (x[low + 1] - x[low]);
  };
  EXPECT_LT(coverage([](Rng& r) { return normals(24, r); }, rule_7), 0.775);
}

/// Integral of [F_n(x) - 1(x >= y)]^2 over the steps of the members' distribution.
double crps_by_steps(const std::vector<double>& ascending, double y) {
  std::vector<double> edges = ascending;
  edges.push_back(y);
  std::sort(edges.begin(), edges.end());
  double integral = 0;
  for (std::size_t e = 0; e + 1 < edges.size(); ++e) {
    const double middle = 0.5 * (edges[e] + edges[e + 1]);
    const auto below = static_cast<double>(
        std::upper_bound(ascending.begin(), ascending.end(), middle) - ascending.begin());
    const double p = below / static_cast<double>(ascending.size()) - (middle >= y ? 1.0 : 0.0);
    integral += p * p * (edges[e + 1] - edges[e]);
  }
  return integral;
}

TEST(EnsembleCrps, IsTheIntegralOfTheSquaredDistanceOfDistributions) {
  Rng random(3, "tests/ensemble_crps");
  for (int c = 0; c < 100; ++c) {
    const auto x = sorted(normals(2 + static_cast<std::size_t>(c) % 30, random));
    const double y = 2 * random.normal();
    EXPECT_NEAR(ensemble_crps(x, y, Drawn::as_they_are), crps_by_steps(x, y), 1e-12);
  }
  EXPECT_EQ(ensemble_crps(std::vector<double>{0.3}, 0.1, Drawn::as_they_are), 0.3 - 0.1);
}

TEST(EnsembleCrps, OfDrawsFromANormalLawIsThatLawsWhereTheScoreIsFair) {
  constexpr int cases = 20000;
  const double of_law = score_of_normal(0.0, 1.0, 0.7).crps;
  const double mean_distance = 2.0 / std::sqrt(constants::pi);  // of two standard normals
  for (const std::size_t n : {8U, 24U}) {
    Rng random(4, "tests/fair_crps");
    double fair = 0;
    double plain = 0;
    double paired = 0;
    double paired_as_fair = 0;
    for (int c = 0; c < cases; ++c) {
      const auto x = sorted(normals(n, random));
      fair += ensemble_crps(x, 0.7) / cases;
      plain += ensemble_crps(x, 0.7, Drawn::as_they_are) / cases;
      const auto pairs = opposite_pairs(n, random);
      const std::vector<double> y{0.7};
      paired += energy_score(pairs, y, Drawn::in_opposite_pairs) / cases;
      paired_as_fair += ensemble_crps(sorted(pairs), 0.7) / cases;
    }
    // Standard errors about 0.15/sqrt(20000) = 0.001.
    EXPECT_NEAR(fair, of_law, 0.004) << n;
    EXPECT_NEAR(paired, of_law, 0.004) << n;
    EXPECT_NEAR(plain, of_law + 0.5 * mean_distance / static_cast<double>(n), 0.004) << n;
    // Opposites stand sqrt(2) times farther apart than strangers.
    EXPECT_NEAR(paired_as_fair,
                of_law - 0.5 * mean_distance * (std::sqrt(2.0) - 1) / static_cast<double>(n - 1),
                0.004)
        << n;
  }
}

TEST(EnergyScore, IsTheCrpsInOneDimensionAndTurnsWithTheAxes) {
  Rng random(5, "tests/energy_score");
  const auto x = normals(12, random);
  const std::vector<double> y{0.4};
  for (const Drawn drawn : {Drawn::as_they_are, Drawn::independently})
    EXPECT_NEAR(energy_score(x, y, drawn), ensemble_crps(sorted(x), 0.4, drawn), 1e-14);

  const auto plane = normals(2 * 12, random);
  const std::vector<double> truth{0.3, -0.8};
  const auto turned = [](std::vector<double> v) {
    for (std::size_t i = 0; i + 1 < v.size(); i += 2) {
      const double east = v[i];
      v[i] = 0.6 * east - 0.8 * v[i + 1];
      v[i + 1] = 0.8 * east + 0.6 * v[i + 1];
    }
    return v;
  };
  EXPECT_NEAR(energy_score(plane, truth), energy_score(turned(plane), turned(truth)), 1e-14);
}

TEST(EnergyScore, OfAnIsotropicNormalLawInThePlaneIsRayleighs) {
  // x - y and x - x' are normal of variance 2: E|.| = sqrt(2) sqrt(pi/2) = sqrt(pi).
  Rng random(6, "tests/rayleigh");
  double sum = 0;
  constexpr int cases = 20000;
  for (int c = 0; c < cases; ++c)
    sum += energy_score(normals(2 * 10, random), normals(2, random)) / cases;
  EXPECT_NEAR(sum, 0.5 * std::sqrt(constants::pi), 0.01);
}

/// A path of eight hours, Gauss-Markov of variance 1.
std::vector<double> path(double kept, Rng& random) {
  std::vector<double> x{random.normal()};
  while (x.size() < 8) x.push_back(kept * x.back() + std::sqrt(1 - kept * kept) * random.normal());
  return x;
}

TEST(VariogramScore, IsLeastForTheDependenceThatTheTruthHas) {
  std::vector<VariogramPair> pairs;
  for (std::size_t a = 0; a < 8; ++a) {
    for (std::size_t b = a + 1; b < 8; ++b) pairs.push_back({a, b, 1.0 / double(b - a)});
  }
  const auto mean_score = [&](double kept) {
    Rng random(7, "tests/variogram");
    double sum = 0;
    constexpr int cases = 2000;
    for (int c = 0; c < cases; ++c) {
      const auto y = path(0.9, random);
      std::vector<double> members;
      for (int m = 0; m < 24; ++m) {
        const auto x = path(kept, random);
        members.insert(members.end(), x.begin(), x.end());
      }
      sum += variogram_score(members, y, pairs) / cases;
    }
    return sum;
  };
  const double right = mean_score(0.9);
  EXPECT_GT(mean_score(0.0), 1.5 * right) << "no memory";
  EXPECT_GT(mean_score(0.6), 1.05 * right);
  EXPECT_GT(mean_score(0.995), 1.05 * right) << "too much memory";
}

TEST(VariogramScore, IsWhatTheFormulaSaysByHand) {
  // |y| steps 1; members' steps 4 and 0: mean of roots 1; and once of order 1: mean 2.
  const std::vector<double> members{0, 4, 1, 1};
  const std::vector<double> y{2, 3};
  const std::vector<VariogramPair> pairs{{0, 1, 3.0}};
  EXPECT_DOUBLE_EQ(variogram_score(members, y, pairs), 0.0);
  EXPECT_DOUBLE_EQ(variogram_score(members, y, pairs, 1.0), 3.0);
  EXPECT_THROW((void)variogram_score(members, y, std::vector<VariogramPair>{{0, 2, 1.0}}),
               ContractViolation);
}

TEST(EnsembleScore, MembersAreComparedAndSortedOnesHaveLostTheirPairs) {
  const std::vector<double> one{0.5};
  EXPECT_THROW((void)ensemble_crps(one, 0.1), ContractViolation);
  EXPECT_THROW((void)ensemble_crps(std::vector<double>{-1, 1}, 0.1, Drawn::in_opposite_pairs),
               ContractViolation);
  EXPECT_THROW((void)energy_score(std::vector<double>{1, 2, 3}, std::vector<double>{0, 0}),
               ContractViolation);
  EXPECT_THROW((void)ensemble_quantile({}, 0.5), ContractViolation);
}

}  // namespace
}  // namespace slackwater::calibration::ensemble_score_test
