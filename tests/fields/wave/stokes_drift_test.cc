#include "fields/wave/stokes_drift.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/wave/dispersion.h"
#include "fields/wave/sea_components.h"

namespace slackwater {
namespace {

using constants::pi;

double drift(double period_s, double depth_m, double height_m) {
  const double omega = 2 * pi / period_s;
  return monochromatic_stokes_drift_m_s(1, omega, wavenumber_rad_m(omega, depth_m), depth_m,
                                        height_m);
}

TEST(MonochromaticStokesDrift, HasThePublishedValues) {
  // fields/docs/physics.md section 6: a = 1 m, T = 8 s.
  EXPECT_NEAR(drift(8, 30, 0), 0.05350009222308551, 1e-9);
  EXPECT_NEAR(drift(8, 30, -2), 0.041191057537936664, 1e-9);
  EXPECT_NEAR(drift(8, 30, -5), 0.02783819809375785, 1e-9);
  EXPECT_NEAR(drift(8, 30, -10), 0.014526303922258272, 1e-9);
  EXPECT_NEAR(drift(8, 5000, 0), 0.04940250474215809, 1e-9);
  EXPECT_NEAR(drift(8, 5000, -5), 0.02633737148895624, 1e-9);
}

TEST(MonochromaticStokesDrift, CarriesTheMomentumOfTheWave) {
  // Depth-integrated, rho times it is E/c = rho g a^2/(2 c) at any depth (Longuet-Higgins 1977).
  for (const double depth : {3.0, 30.0, 300.0}) {
    const double omega = 2 * pi / 8;
    double sum = 0;
    constexpr int cells = 20000;
    for (int i = 0; i < cells; ++i)
      sum += drift(8, depth, -(i + 0.5) * depth / cells) * depth / cells;
    const double speed = omega / wavenumber_rad_m(omega, depth);
    EXPECT_NEAR(sum / (constants::gravity_m_s2 / (2 * speed)), 1, 1e-5) << depth;
  }
}

TEST(MonochromaticStokesDrift, IsTheMeanVelocityOfAParticleInTheOrbit) {
  // A particle followed through the linear velocity of a low wave drifts by it, to second order.
  const double a = 0.02, omega = 2 * pi / 6, h = 8;
  const double k = wavenumber_rad_m(omega, h);
  double x = 0, z = -2;
  const int steps = 40000;
  const double dt = 50 * 2 * pi / omega / steps;
  const auto u = [&](double px, double pz, double t) {
    return a * omega * std::cosh(k * (pz + h)) / std::sinh(k * h) * std::cos(k * px - omega * t);
  };
  const auto w = [&](double px, double pz, double t) {
    return a * omega * std::sinh(k * (pz + h)) / std::sinh(k * h) * std::sin(k * px - omega * t);
  };
  for (int i = 0; i < steps; ++i) {  // midpoint rule
    const double t = i * dt;
    const double mx = x + 0.5 * dt * u(x, z, t), mz = z + 0.5 * dt * w(x, z, t);
    x += dt * u(mx, mz, t + 0.5 * dt);
    z += dt * w(mx, mz, t + 0.5 * dt);
  }
  // It started at a phase of its orbit, so that its mean height is off z by k a of its excursion.
  const double expected = monochromatic_stokes_drift_m_s(a, omega, k, h, -2);
  EXPECT_NEAR(x / (steps * dt) / expected, 1, 0.03);
}

TEST(StokesProfile, HasThePublishedValues) {
  // fields/docs/physics.md section 6: us0 0.10, Hs 2, Tm01 6.
  const double v = stokes_transport_m2_s(2, 6);
  EXPECT_NEAR(v, 0.2617993877991494, 1e-12);
  const auto u = [&](double z, StokesProfile profile) {
    return 0.10 * stokes_share(0.10, v, z, profile);
  };
  const auto old = StokesProfile::exponential_integral_2014;
  EXPECT_NEAR(u(-1, old), 0.05819904683556867, 1e-9);
  EXPECT_NEAR(u(-5, old), 0.014817283681147016, 1e-9);
  const auto phillips = StokesProfile::phillips_2016;
  EXPECT_NEAR(u(-1, phillips), 0.04922337935961474, 1e-9);
  EXPECT_NEAR(u(-2, phillips), 0.03499394798371152, 1e-9);
  EXPECT_NEAR(u(-5, phillips), 0.016257047294980516, 1e-9);
  EXPECT_NEAR(u(-10, phillips), 0.005884262775591876, 1e-9);
}

TEST(StokesProfile, IntegratesToItsTransport) {
  const double v = 0.2617993877991494;
  const auto integral = [&](StokesProfile profile) {
    double sum = 0;  // z = -x^2 tames the root at the surface
    constexpr int cells = 100000;
    const double top = std::sqrt(2000.0);
    for (int i = 0; i < cells; ++i) {
      const double x = (i + 0.5) * top / cells;
      sum += 0.10 * stokes_share(0.10, v, -x * x, profile) * 2 * x * top / cells;
    }
    return sum;
  };
  EXPECT_NEAR(integral(StokesProfile::phillips_2016) / v, 1, 1e-7);
  EXPECT_NEAR(integral(StokesProfile::exponential_integral_2014) / v, 1.00064, 1e-5);
}

TEST(StokesProfile, StartsAtTheSurfaceValueAndKeepsItsDirection) {
  const Horizontal surface{0.06, -0.08};
  EXPECT_EQ(stokes_drift_m_s(surface, 0.2, 0), surface);
  double last = 1;
  for (double z = -0.1; z > -100; z *= 1.3) {
    const Horizontal u = stokes_drift_m_s(surface, 0.2, z);
    EXPECT_NEAR((u / surface).imag(), 0, 1e-15);
    EXPECT_LT((u / surface).real(), last);
    EXPECT_GE((u / surface).real(), 0);
    last = (u / surface).real();
  }
  EXPECT_EQ(stokes_drift_m_s({}, 0.2, -1), Horizontal{});
}

TEST(StokesDriftOfASea, IsTheSumOverItsWavesAndNearlyThatOfItsSpectrum) {
  const WaveWater water{500.0, {}};
  const PartitionedSea sea{{{2.0, 8.0, 270.0, 1.0, 1000.0}}};
  const SeaComponents parts = components_of(sea, water, 3);
  // Deep water, nearly long-crested: (2/g) integral of omega^3 S e^(2kz) over the same range.
  const JonswapSpectrum s = sea.partitions[0].spectrum();
  for (const double z : {0.0, -2.0, -10.0}) {
    double sum = 0;
    const int cells = 20000;
    const double low = 0.4 * s.peak_rad_s(), high = 6 * s.peak_rad_s();
    for (int i = 0; i < cells; ++i) {
      const double w = low + (i + 0.5) * (high - low) / cells;
      const double k = w * w / constants::gravity_m_s2;
      sum += 2 * w * k * s.density(w) * std::exp(2 * k * z) * (high - low) / cells;
    }
    const Horizontal drifted = stokes_drift_m_s(parts.waves, water, z);
    EXPECT_NEAR(drifted.real() / sum, 1, 0.02) << z;  // from the west: towards the east
    EXPECT_LT(std::abs(drifted.imag()), 0.02 * drifted.real());
  }
}

TEST(StokesDrift, RefusesPlacesOutsideTheWater) {
  EXPECT_THROW((void)monochromatic_stokes_drift_m_s(1, 1, 0.1, 10, 0.1), ContractViolation);
  EXPECT_THROW((void)monochromatic_stokes_drift_m_s(1, 1, 0.1, 10, -10.1), ContractViolation);
  EXPECT_THROW((void)stokes_share(0.1, 0, -1), ContractViolation);
  EXPECT_THROW((void)stokes_share(0.1, 1, 1), ContractViolation);
  EXPECT_THROW((void)stokes_transport_m2_s(1, 0), ContractViolation);
}

}  // namespace
}  // namespace slackwater
