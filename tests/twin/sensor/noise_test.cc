#include "twin/sensor/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>
#include <vector>

namespace slackwater::twin::noise_test {
namespace {

static_assert(std::is_trivially_copyable_v<NoiseStream> && sizeof(NoiseStream) == 16);

TEST(NoiseStreams, AreSetBySeedAndNameAlone) {
  NoiseStream a(7, "rov/gnss"), again(7, "rov/gnss"), other(7, "rov/imu"), seed(8, "rov/gnss");
  const double first = a.normal();
  EXPECT_NE(first, other.normal());
  EXPECT_NE(first, seed.normal());
  EXPECT_EQ(first, again.normal());
  // Whatever is drawn elsewhere meanwhile.
  for (int i = 0; i < 1000; ++i) {
    for (int k = 0; k < i % 3; ++k) (void)other.normal();
    ASSERT_EQ(a.normal(), again.normal());
  }
}

TEST(NoiseStreams, GoOnFromACopyAsTheOriginalDoes) {
  NoiseStream stream(7, "rov/dvl");
  for (int i = 0; i < 17; ++i) (void)stream.normal();
  NoiseStream checkpoint = stream;
  std::vector<double> onward(50);
  for (double& x : onward) x = stream.normal();
  for (const double x : onward) EXPECT_EQ(checkpoint.normal(), x);
  EXPECT_EQ(checkpoint, stream);
}

TEST(NoiseStreams, HaveTheMomentsOfANormalAndNoEcho) {
  NoiseStream stream(11, "tests/moments"), neighbour(12, "tests/moments");
  constexpr int n = 200000;
  double sum = 0, squares = 0, fourths = 0, echo = 0, shared = 0, before = 0;
  for (int i = 0; i < n; ++i) {
    const double x = stream.normal();
    sum += x;
    squares += x * x;
    fourths += x * x * x * x;
    echo += x * before;
    shared += x * neighbour.normal();
    before = x;
  }
  // Five standard errors each.
  EXPECT_NEAR(sum / n, 0, 5 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1, 5 * std::sqrt(2.0 / n));
  EXPECT_NEAR(fourths / n, 3, 5 * std::sqrt(96.0 / n));
  EXPECT_NEAR(echo / n, 0, 5 / std::sqrt(n));
  EXPECT_NEAR(shared / n, 0, 5 / std::sqrt(n));
}

/// E x(0) x(t) = sd^2 exp(-t/tau), whatever the step it is sampled with.
TEST(GaussMarkovNoise, HasItsStandardDeviationAndItsCorrelationTime) {
  const GaussMarkov model{2.0, 30};
  for (const double dt_s : {1.0, 7.0}) {
    NoiseStream noise(3, "tests/gauss_markov");
    constexpr std::size_t n = 400000;
    std::vector<double> x(n);
    double now = model.sd * noise.normal();
    for (double& value : x) value = now = later(model, now, dt_s, noise);
    // So many independent values are in the record: n dt/(2 tau).
    const double independent = static_cast<double>(n) * dt_s / (2 * model.correlation_time_s);
    for (const std::size_t lag : {0U, 1U, 4U, 12U}) {
      double sum = 0;
      for (std::size_t i = 0; i + lag < n; ++i) sum += x[i] * x[i + lag];
      const double expected =
          4 * std::exp(-static_cast<double>(lag) * dt_s / model.correlation_time_s);
      EXPECT_NEAR(sum / static_cast<double>(n - lag), expected, 5 * 4 * std::sqrt(2 / independent))
          << lag << " steps of " << dt_s << " s";
    }
  }
}

TEST(Resolutions, RoundToTheNearestMultiple) {
  EXPECT_NEAR(rounded_to(1.2349, 0.01), 1.23, 1e-15);
  EXPECT_NEAR(rounded_to(-1.2351, 0.01), -1.24, 1e-15);
  EXPECT_EQ(rounded_to(1.2349, 0), 1.2349);
}

}  // namespace
}  // namespace slackwater::twin::noise_test
