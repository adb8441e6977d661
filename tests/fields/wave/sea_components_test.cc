#include "fields/wave/sea_components.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/wave/dispersion.h"
#include "fields/wave/spreading.h"
#include "fields/wave/variance_division.h"

namespace slackwater::sea_components_test {
namespace {

using constants::pi;

const PartitionedSea two_systems{
    {{1.8, 6.5, 250.0, std::nullopt, 10.0}, {1.1, 12.0, 310.0, 1.5, 30.0}}};

double variance_of(const std::vector<WaveComponent>& waves) {
  double sum = 0;
  for (const WaveComponent& wave : waves) sum += 0.5 * wave.amplitude_m * wave.amplitude_m;
  return sum;
}

TEST(VarianceDivision, KeepsTheAreaAndTheSecondMoment) {
  DensityTable table;
  for (int i = 0; i <= 1000; ++i) {
    const double w = 0.5 + 0.005 * i;
    table.frequency_rad_s.push_back(w);
    table.density_m2_s.push_back(std::pow(w, -5) * std::exp(-1.25 * std::pow(w, -4)));
  }
  double m0 = 0, m2 = 0;
  for (std::size_t i = 1; i < table.frequency_rad_s.size(); ++i) {
    const auto term = [&](std::size_t j, int n) {
      return table.density_m2_s[j] * std::pow(table.frequency_rad_s[j], n) * 0.5 * 0.005;
    };
    m0 += term(i - 1, 0) + term(i, 0);
    m2 += term(i - 1, 2) + term(i, 2);
  }
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng rng(seed, "division");
    double area = 0, second = 0, last = 0;
    for (const VarianceShare& share : divide_variance(table, 200, rng)) {
      EXPECT_GT(share.frequency_rad_s, last);
      last = share.frequency_rad_s;
      area += share.variance_m2;
      second += share.variance_m2 * last * last;
    }
    EXPECT_NEAR(area / m0, 1, 1e-12);
    EXPECT_NEAR(second / m2, 1, 0.01);  // one frequency stands for its cell
  }
  Rng rng(1, "division");
  EXPECT_TRUE(divide_variance({{1, 2}, {0, 0}}, 10, rng).empty());
}

TEST(SeaComponents, HoldTheEnergyOfTheSeaExactly) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for (const std::size_t count : {16u, 50u, 200u, 1000u}) {
      const SeaComponents sea = components_of(two_systems, {30, {}}, seed, {.count = count});
      EXPECT_EQ(sea.waves.size(), count);
      EXPECT_NEAR(16 * variance_of(sea.waves), 1.8 * 1.8 + 1.1 * 1.1, 1e-12);
      EXPECT_EQ(sea.blocked_variance_m2, 0);
    }
  }
}

TEST(SeaComponents, HaveTheMeanPeriodTheDirectionAndTheSpreadThatAreAsked) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const PartitionedSea sea{{{2.0, 8.0, 200.0, 3.3, 15.0}}};
    const SeaComponents parts = components_of(sea, {100, {}}, seed);
    double m2 = 0;
    Horizontal mean{};
    for (const WaveComponent& wave : parts.waves) {
      const double energy = 0.5 * wave.amplitude_m * wave.amplitude_m;
      m2 += energy * wave.intrinsic_rad_s * wave.intrinsic_rad_s;
      mean += energy * wave.wavenumber_rad_m / std::abs(wave.wavenumber_rad_m);
    }
    const double tm02 = 2 * pi * std::sqrt(variance_of(parts.waves) / m2);
    // Above 6 omega_p lie 2 % of m2, and as much of the mean period is missing, halved by the root.
    EXPECT_NEAR(tm02 / (8 * 0.77751), 1.01, 0.015);
    EXPECT_NEAR(std::abs(mean) / variance_of(parts.waves), spreading_first_moment(15), 0.02);
    EXPECT_NEAR(std::remainder(from_direction_deg(mean) - 200.0, 360), 0, 2.5);
  }
}

TEST(SeaComponents, OneSeedIsOneSeaAndAnotherIsAnother) {
  const auto phases = [](std::uint64_t seed) {
    std::vector<double> all;
    for (const WaveComponent& w : components_of(two_systems, {30, {}}, seed).waves) {
      all.insert(all.end(), {w.phase_rad, w.intrinsic_rad_s, w.wavenumber_rad_m.real()});
    }
    return all;
  };
  EXPECT_EQ(phases(7), phases(7));
  EXPECT_NE(phases(7), phases(8));
}

TEST(SeaComponents, NoTwoShareAFrequencyOrADifferenceOfFrequencies) {
  // Equal steps would repeat the sea after 2 pi over the step.
  const SeaComponents sea = components_of(two_systems, {30, {}}, 5);
  std::set<double> frequencies;
  for (const WaveComponent& wave : sea.waves) frequencies.insert(wave.intrinsic_rad_s);
  EXPECT_EQ(frequencies.size(), sea.waves.size());
  std::set<long long> differences;
  for (auto next = std::next(frequencies.begin()); next != frequencies.end(); ++next) {
    differences.insert(std::llround((*next - *std::prev(next)) * 1e12));
  }
  EXPECT_EQ(differences.size(), frequencies.size() - 1);
}

TEST(SeaComponents, ObeyTheDispersionRelationInTheMovingWater) {
  const WaveWater water{25, {0.9, -0.5}};
  for (const FrequencyFrame frame : {FrequencyFrame::intrinsic, FrequencyFrame::absolute}) {
    const SeaComponents sea = components_of(two_systems, water, 2, {.frame = frame});
    for (const WaveComponent& wave : sea.waves) {
      const double k = std::abs(wave.wavenumber_rad_m);
      EXPECT_NEAR(intrinsic_frequency_rad_s(k, 25) / wave.intrinsic_rad_s, 1, 1e-13);
      const double shift = (std::conj(wave.wavenumber_rad_m) * water.current_m_s).real();
      EXPECT_NEAR((wave.intrinsic_rad_s + shift) / wave.absolute_rad_s, 1, 1e-12);
    }
  }
}

TEST(SeaComponents, ABlockedTailIsLeftOutAndToldABlockedSeaRefused) {
  // Waves from the east, a current towards the east: blocked from omega = g/(4 U) on.
  const PartitionedSea sea{{{1.5, 6.0, 90.0, 3.3, 200.0}}};
  const ComponentChoice measured{.frame = FrequencyFrame::absolute};
  const SeaComponents weak = components_of(sea, {50, {0.8, 0}}, 1, measured);
  EXPECT_GT(weak.blocked_variance_m2, 0);
  EXPECT_LT(weak.blocked_variance_m2, 0.02 * 1.5 * 1.5 / 16);
  EXPECT_NEAR(16 * (variance_of(weak.waves) + weak.blocked_variance_m2), 1.5 * 1.5, 1e-12);
  try {
    (void)components_of(sea, {50, {2.5, 0}}, 1, measured);
    FAIL() << "a blocked sea was made";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    EXPECT_NE(error.message().find("a current of 2.50 m/s blocks"), std::string::npos);
  }
  EXPECT_NO_THROW((void)components_of(sea, {50, {2.5, 0}}, 1));  // intrinsic: always there
}

}  // namespace
}  // namespace slackwater::sea_components_test
