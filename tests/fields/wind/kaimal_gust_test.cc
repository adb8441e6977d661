#include "fields/wind/kaimal_gust.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater {
namespace {

constexpr std::array<GustAxis, 3> all_axes{GustAxis::along, GustAxis::across, GustAxis::up};

KaimalSpectrum at_hub() {
  return {12.0, 90.0, normal_turbulence_m_s(12.0, reference_intensity(TurbulenceClass::b))};
}

double of(const Gust& gust, GustAxis axis) {
  return axis == GustAxis::along ? gust.along_m_s
                                 : (axis == GustAxis::across ? gust.across_m_s : gust.up_m_s);
}

TEST(KaimalSpectrum, HasThePublishedValues) {
  // fields/docs/physics.md, section 9.
  const KaimalSpectrum spectrum = at_hub();
  EXPECT_NEAR(spectrum.sigma_m_s(GustAxis::along), 2.044, 1e-12);
  for (const auto& [n, s] : std::vector<std::pair<double, double>>{{0.005, 169.86074391},
                                                                   {0.01, 90.44138349},
                                                                   {0.05, 11.10847995},
                                                                   {0.1, 3.82870568},
                                                                   {0.5, 0.28248152}}) {
    EXPECT_NEAR(spectrum.density(GustAxis::along, n), s, 1e-6) << n;
  }
  EXPECT_NEAR(spectrum.variance_below(GustAxis::along, 1e12), 4.177936, 1e-6);
  EXPECT_NEAR(normal_turbulence_m_s(10, reference_intensity(TurbulenceClass::c)), 1.572, 1e-12);
  EXPECT_NEAR(spectrum.length_m(GustAxis::along), 340.2, 1e-12);
  EXPECT_NEAR(spectrum.length_m(GustAxis::across), 113.4, 1e-12);
  EXPECT_NEAR(spectrum.length_m(GustAxis::up), 27.72, 1e-12);
  EXPECT_NEAR(KaimalSpectrum(8, 20, 1).length_m(GustAxis::along), 8.1 * 14, 1e-12);
}

TEST(KaimalSpectrum, IsTheDerivativeOfItsVariance) {
  const KaimalSpectrum spectrum = at_hub();
  for (const GustAxis axis : all_axes)
    for (const double n : {1e-4, 1e-2, 0.3, 5.0}) {
      const double h = 1e-4 * n;
      const double slope =
          (spectrum.variance_below(axis, n + h) - spectrum.variance_below(axis, n - h)) / (2 * h);
      EXPECT_NEAR(slope / spectrum.density(axis, n), 1, 1e-6);
    }
}

TEST(KaimalGust, CarriesTheVarianceOfItsBandsInEveryRealisation) {
  const KaimalSpectrum spectrum = at_hub();
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const KaimalGust gust(spectrum, seed);
    for (const GustAxis axis : all_axes) {
      EXPECT_NEAR(gust.variance_m2_s2(axis), spectrum.variance_below(axis, 10), 1e-12) << seed;
    }
  }
  EXPECT_GT(spectrum.variance_below(GustAxis::along, 10) / (2.044 * 2.044), 0.99);
}

TEST(KaimalGust, ShowsThatVarianceInTimeOverManySeeds) {
  // One hour holds few of the slowest gusts: the mean over seeds is compared. Instants of
  // different seeds are independent, so the mean of N squares scatters by sqrt(2/N) at most.
  const KaimalSpectrum spectrum = at_hub();
  constexpr int seeds = 200;
  constexpr int instants = 200;
  std::array<double, 3> square{};
  std::array<double, 3> mean{};
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const KaimalGust gust(spectrum, seed);
    for (int i = 0; i < instants; ++i) {
      const Gust now = gust.at(i * 61.7);
      for (const GustAxis axis : all_axes) {
        const double value = of(now, axis);
        square[static_cast<std::size_t>(axis)] += value * value / (seeds * instants);
        mean[static_cast<std::size_t>(axis)] += value / (seeds * instants);
      }
    }
  }
  for (const GustAxis axis : all_axes) {
    const double asked = spectrum.variance_below(axis, 10);
    EXPECT_NEAR(square[static_cast<std::size_t>(axis)] / asked, 1, 0.03);
    EXPECT_NEAR(mean[static_cast<std::size_t>(axis)] / std::sqrt(asked), 0, 0.03);
  }
}

TEST(KaimalGust, HasTheSpectrumAskedInEachBand) {
  // Periodograms of 2048 s at 2 Hz, averaged over seeds and over the lines of each band.
  const KaimalSpectrum spectrum = at_hub();
  constexpr int n = 4096;
  constexpr double dt = 0.5;
  constexpr int seeds = 8;
  const std::array<double, 4> edge_hz{0.02, 0.06, 0.18, 0.5};
  std::array<double, 3> found{};
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    // Nothing above the Nyquist frequency may fold back: the bands end there.
    const KaimalGust gust(spectrum, seed, "test", {.bands = 256, .highest_hz = 1.0});
    std::vector<double> series(n);
    for (int i = 0; i < n; ++i) {
      const double window = 1 - std::cos(2 * constants::pi * (i + 0.5) / n);  // Hann, leakage
      series[static_cast<std::size_t>(i)] = window * gust.at(i * dt).along_m_s;
    }
    for (std::size_t band = 0; band < found.size(); ++band) {
      const int first = static_cast<int>(edge_hz[band] * n * dt);
      const int last = static_cast<int>(edge_hz[band + 1] * n * dt);
      for (int k = first; k < last; ++k) {
        std::complex<double> line = 0;
        const std::complex<double> turn = std::polar(1.0, -2 * constants::pi * k / n);
        std::complex<double> phase = 1;
        for (const double value : series) {
          line += value * phase;
          phase *= turn;
        }
        // The window has mean square 3/2; a line is 1/(n dt) wide, one-sided.
        found[band] += 2 * std::norm(line) / (1.5 * n * n) / seeds;
      }
    }
  }
  for (std::size_t band = 0; band < found.size(); ++band) {
    const double asked = spectrum.variance_below(GustAxis::along, edge_hz[band + 1]) -
                         spectrum.variance_below(GustAxis::along, edge_hz[band]);
    EXPECT_NEAR(found[band] / asked, 1, 0.05) << "from " << edge_hz[band] << " Hz";
  }
}

TEST(KaimalGust, IsTheSameAtAnInstantInWhateverOrderItIsAsked) {
  const KaimalGust gust(at_hub(), 5);
  const KaimalGust twin(at_hub(), 5);
  const KaimalGust other(at_hub(), 6);
  const KaimalGust elsewhere(at_hub(), 5, "another stream");
  const Gust late = gust.at(3600);
  static_cast<void>(twin.at(-12));
  EXPECT_EQ(late, twin.at(3600));
  EXPECT_NE(late, other.at(3600));
  EXPECT_NE(late, elsewhere.at(3600));
}

TEST(KaimalGust, RefusesAWindThatDoesNotBlow) {
  EXPECT_THROW(KaimalSpectrum(0, 90, 1), ContractViolation);
  EXPECT_THROW(KaimalSpectrum(10, -1, 1), ContractViolation);
  EXPECT_THROW(KaimalSpectrum(10, 90, std::nan("")), ContractViolation);
}

}  // namespace
}  // namespace slackwater
