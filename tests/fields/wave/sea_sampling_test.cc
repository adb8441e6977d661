#include "fields/wave/sea_sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"
#include "tests/fields/wave/textbook_sea.h"

namespace slackwater::sea_sampling_test {
namespace {

using constants::gravity_m_s2;
using constants::pi;
using constants::sea_water_density_kg_m3;
using tests::one_wave;

const UtcTime epoch = parse_utc("2025-03-10T00:00:00Z");

/// A wind sea and a swell in a tidal current over a shelf.
SeaRealisation shelf_sea(Stretching stretching, std::uint64_t seed = 7) {
  const PartitionedSea sea{{{1.8, 6.5, 250.0, std::nullopt, 10.0}, {1.1, 12.0, 310.0, 1.5, 30.0}}};
  const WaveWater water{25, {0.7, -0.4}};
  return {components_of(sea, water, seed).waves, water, epoch, stretching};
}

/// Central difference of a number of a sample along one coordinate of the place.
template <typename Value>
double slope(const SeaRealisation& sea, const WavePlace& at, double WavePlace::*coordinate,
             double step, Value value) {
  WavePlace after = at;
  WavePlace before = at;
  after.*coordinate += step;
  before.*coordinate -= step;
  return (value(sample_waves(sea, after)) - value(sample_waves(sea, before))) / (2 * step);
}

auto velocity(int component) {
  return [component](const WaveSample& s) { return s.motion.velocity_m_s[component]; };
}
double elevation(const WaveSample& s) { return s.motion.elevation_m; }
double pressure(const WaveSample& s) { return s.pressure_pa; }

/// Greatest magnitude over a period of one wave at a level.
template <typename Value>
double amplitude(double z, Value value) {
  const WaveWater water{30, {}};
  const SeaRealisation sea({one_wave(1, 8, water)}, water, epoch, Stretching::none);
  double most = 0;
  for (int i = 0; i < 16; ++i) {  // crests and zeros fall on sixteenths of the period
    most = std::max(most, std::abs(value(sample_waves(sea, {0, 0, z, 0.5 * i}))));
  }
  return most;
}

TEST(SeaRealisation, HasThePublishedAmplitudesOfOneWave) {
  // fields/docs/physics.md section 8: a 1 m, T 8 s, h 30 m.
  const auto acceleration = [](const WaveSample& s) { return s.acceleration_m_s2[0]; };
  EXPECT_NEAR(amplitude(0, velocity(0)), 0.817003, 1e-6);
  EXPECT_NEAR(amplitude(-5, velocity(0)), 0.599558, 1e-6);
  EXPECT_NEAR(amplitude(-15, velocity(0)), 0.342421, 1e-6);
  EXPECT_NEAR(amplitude(-30, velocity(0)), 0.225042, 1e-6);
  EXPECT_NEAR(amplitude(-5, velocity(2)), 0.555721, 1e-6);
  EXPECT_NEAR(amplitude(-30, velocity(2)), 0, 1e-10);
  EXPECT_NEAR(amplitude(-5, acceleration), 0.470891, 1e-6);
  EXPECT_NEAR(amplitude(-5, pressure), 7376.52, 0.01);
  EXPECT_NEAR(amplitude(-5, elevation), 1, 1e-10);
}

TEST(SeaRealisation, IsFreeOfDivergenceAndOfRotation) {
  const SeaRealisation sea = shelf_sea(Stretching::none);
  Rng rng(1, "divergence");
  for (int i = 0; i < 100; ++i) {
    const WavePlace at{rng.uniform(-500, 500), rng.uniform(-500, 500), rng.uniform(-24, -1),
                       rng.uniform(0, 3600)};
    const double step = 1e-3;
    const auto d = [&](double WavePlace::*along, int c) {
      return slope(sea, at, along, step, velocity(c));
    };
    // Values of 1 m/s good to 1e-10 over 2 mm; the gradients are of the order of 1/s.
    EXPECT_NEAR(d(&WavePlace::east_m, 0) + d(&WavePlace::north_m, 1) + d(&WavePlace::up_m, 2), 0,
                1e-6);
    EXPECT_NEAR(d(&WavePlace::up_m, 0), d(&WavePlace::east_m, 2), 1e-6);
    EXPECT_NEAR(d(&WavePlace::up_m, 1), d(&WavePlace::north_m, 2), 1e-6);
    EXPECT_NEAR(d(&WavePlace::north_m, 0), d(&WavePlace::east_m, 1), 1e-6);
  }
}

TEST(SeaRealisation, NothingFlowsThroughTheBed) {
  for (const Stretching stretching : {Stretching::none, Stretching::wheeler}) {
    const SeaRealisation sea = shelf_sea(stretching);
    for (int i = 0; i < 50; ++i) {
      const WaveSample s = sample_waves(sea, {13.0 * i, -7.0 * i, -25, 3.3 * i});
      ASSERT_EQ(s.motion.status, SampleStatus::ok);
      EXPECT_NEAR(s.motion.velocity_m_s[2], 0, 1e-10);
      EXPECT_NEAR(s.acceleration_m_s2[2], 0, 1e-10);
    }
  }
}

TEST(SeaRealisation, TheSurfaceMovesWithTheWaterThatIsCarriedByTheCurrent) {
  // Linear kinematic condition at z = 0: deta/dt + U . grad eta = w.
  const SeaRealisation sea = shelf_sea(Stretching::none);
  const Horizontal current = sea.water().current_m_s;
  for (int i = 0; i < 100; ++i) {
    const WavePlace at{31.0 * i, -17.0 * i, -0.0, 2.7 * i};
    const double rise = slope(sea, at, &WavePlace::t_s, 2e-4, elevation) +
                        current.real() * slope(sea, at, &WavePlace::east_m, 1e-3, elevation) +
                        current.imag() * slope(sea, at, &WavePlace::north_m, 1e-3, elevation);
    EXPECT_NEAR(rise, sample_waves(sea, at).motion.velocity_m_s[2], 2e-6);
  }
}

TEST(SeaRealisation, TheSurfaceIsFreeOfPressure) {
  // Linear dynamic condition at z = 0: p = rho g eta.
  const SeaRealisation sea = shelf_sea(Stretching::none);
  for (int i = 0; i < 50; ++i) {
    const WaveSample s = sample_waves(sea, {11.0 * i, 5.0 * i, 0, 1.9 * i});
    EXPECT_NEAR(s.pressure_pa, sea_water_density_kg_m3 * gravity_m_s2 * s.motion.elevation_m, 1e-4);
  }
}

TEST(SeaRealisation, AccelerationIsThatOfTheMovingWaterAndTheForceOfThePressure) {
  const SeaRealisation sea = shelf_sea(Stretching::none);
  const Horizontal current = sea.water().current_m_s;
  Rng rng(2, "acceleration");
  for (int i = 0; i < 100; ++i) {
    const WavePlace at{rng.uniform(-500, 500), rng.uniform(-500, 500), rng.uniform(-24, -1),
                       rng.uniform(0, 3600)};
    const WaveSample s = sample_waves(sea, at);
    double WavePlace::*const along[3] = {&WavePlace::east_m, &WavePlace::north_m, &WavePlace::up_m};
    for (int c = 0; c < 3; ++c) {
      const double follow = slope(sea, at, &WavePlace::t_s, 2e-4, velocity(c)) +
                            current.real() * slope(sea, at, along[0], 1e-3, velocity(c)) +
                            current.imag() * slope(sea, at, along[1], 1e-3, velocity(c));
      EXPECT_NEAR(s.acceleration_m_s2[c], follow, 2e-6);
      const double force = -slope(sea, at, along[c], 1e-3, pressure) / sea_water_density_kg_m3;
      EXPECT_NEAR(s.acceleration_m_s2[c], force, 2e-6);
    }
  }
}

TEST(SeaRealisation, EnergyOfTheMovingWaterIsHalfOfRhoGHsSquaredBySixteen) {
  // Kinetic energy below still water, in the mean over many places, equals the potential energy of
  // the surface, rho g Hs^2/32 (equipartition); both together rho g Hs^2/16.
  const PartitionedSea swell{{{2.0, 9.0, 270.0, 3.3, 20.0}}};
  const WaveWater water{30, {}};
  const SeaRealisation sea(components_of(swell, water, 3).waves, water, epoch, Stretching::none);
  Rng rng(3, "energy");
  double kinetic = 0;
  double potential = 0;
  constexpr int places = 3000;
  constexpr int levels = 12;
  for (int i = 0; i < places; ++i) {
    const double x = rng.uniform(-1e5, 1e5), y = rng.uniform(-1e5, 1e5), t = rng.uniform(0, 1e5);
    for (int j = 0; j < levels; ++j) {
      // Levels closer near the surface: z = -h q^2, dz = 2 h q dq.
      const double q = (j + 0.5) / levels;
      const WaveSample s = sample_waves(sea, {x, y, -30 * q * q, t});
      const double* v = s.motion.velocity_m_s;
      kinetic += 0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) * 60 * q / levels / places;
      if (j == 0) potential += 0.5 * gravity_m_s2 * std::pow(s.motion.elevation_m, 2) / places;
    }
  }
  // 3 000 independent places: the standard error of a mean square is sqrt(2/3000) = 2.6 %.
  EXPECT_NEAR(potential / (gravity_m_s2 * 4.0 / 32), 1, 0.08);
  EXPECT_NEAR(kinetic / (gravity_m_s2 * 4.0 / 32), 1, 0.08);
}

TEST(SeaRealisation, HasTheHeightThatIsAskedExactlyAndOverALongRecord) {
  const PartitionedSea asked{
      {{1.8, 6.5, 250.0, std::nullopt, 10.0}, {1.1, 12.0, 310.0, 1.5, 30.0}}};
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const SeaRealisation sea = realise(asked, {25, {}}, seed, epoch);
    EXPECT_NEAR(sea.significant_height_m(), asked.significant_height_m(), 1e-12);
    // Half a day; a sample in 3.1 s is enough for a variance.
    std::vector<WavePlace> record(14000);
    for (std::size_t i = 0; i < record.size(); ++i) record[i].t_s = 3.1 * static_cast<double>(i);
    std::vector<double> eta(record.size());
    sample_elevation(sea, record, eta);
    double mean = 0, square = 0;
    for (const double e : eta) mean += e / static_cast<double>(eta.size());
    for (const double e : eta) square += (e - mean) * (e - mean) / static_cast<double>(eta.size());
    EXPECT_NEAR(4 * std::sqrt(square) / asked.significant_height_m(), 1, 0.02) << "seed " << seed;
    EXPECT_NEAR(mean, 0, 0.002);
  }
}

TEST(SeaRealisation, HasGaussianCrestsAndNoPeriod) {
  const SeaRealisation sea =
      realise(PartitionedSea{{{2.0, 8.0, 0.0, 3.3, 10.0}}}, {50, {}}, 4, epoch);
  const double sigma = std::sqrt(sea.variance_m2());
  std::vector<WavePlace> record(40000);
  for (std::size_t i = 0; i < record.size(); ++i) record[i].t_s = 1.7 * static_cast<double>(i);
  std::vector<double> eta(record.size());
  sample_elevation(sea, record, eta);
  double fourth = 0;
  for (const double e : eta) fourth += std::pow(e / sigma, 4) / static_cast<double>(eta.size());
  EXPECT_NEAR(fourth, 3, 0.15);  // kurtosis of a sum of many independent waves
  // No lag of more than an hour brings the record back: its correlation stays far from 1.
  for (std::size_t lag = 2200; lag < 20000; lag += 37) {
    double product = 0;
    for (std::size_t i = 0; i + lag < eta.size(); i += 2) product += eta[i] * eta[i + lag];
    product /= sigma * sigma * static_cast<double>((eta.size() - lag + 1) / 2);
    ASSERT_LT(std::abs(product), 0.6) << lag;
  }
}

TEST(SeaRealisation, WheelerBringsStillWaterToTheSurfaceAndKeepsTheBed) {
  const SeaRealisation moved = shelf_sea(Stretching::wheeler);
  const SeaRealisation still = shelf_sea(Stretching::none);
  for (int i = 0; i < 200; ++i) {
    const double x = 23.0 * i, y = -9.0 * i, t = 4.1 * i;
    const double eta = sample_waves(still, {x, y, 0, t}).motion.elevation_m;
    for (const double share : {0.0, 0.3, 1.0}) {
      // The level that lies `share` of the way down to the bed, in the wave and in still water.
      const WaveSample a = sample_waves(moved, {x, y, eta - share * (25 + eta), t});
      const WaveSample b = sample_waves(still, {x, y, -25 * share, t});
      if (!has_value(a.motion.status)) continue;  // the surface itself, by a rounding
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(a.motion.velocity_m_s[c], b.motion.velocity_m_s[c], 1e-12);
        EXPECT_NEAR(a.acceleration_m_s2[c], b.acceleration_m_s2[c], 1e-12);
      }
      EXPECT_NEAR(a.pressure_pa, b.pressure_pa, 1e-8);
    }
  }
}

TEST(SeaRealisation, AFixedPlaceMeetsTheDopplerShiftedFrequency) {
  // One swell against and with a tidal stream, its zero crossings counted at a fixed pile and at a
  // raft that the stream carries.
  for (const double stream : {-1.5, 0.0, 1.5}) {
    const WaveWater water{20, {stream, 0}};
    const WaveComponent wave = one_wave(0.5, 9, water);
    const SeaRealisation sea({wave}, water, epoch);
    const auto frequency_seen = [&](double carried_m_s) {
      int crossings = 0;
      double first = 0, last = 0, before = 1;
      for (int i = 0; i < 20000; ++i) {
        const double t = 0.25 * i;
        const double eta = sample_waves(sea, {carried_m_s * t, 0, -1, t}).motion.elevation_m;
        if (before < 0 && eta >= 0) {
          last = t - 0.25 * eta / (eta - before);
          if (crossings++ == 0) first = last;
        }
        before = eta;
      }
      return 2 * pi * (crossings - 1) / (last - first);
    };
    const double k = wave.wavenumber_rad_m.real();
    EXPECT_NEAR(frequency_seen(0) / (2 * pi / 9 + k * stream), 1, 1e-6);
    EXPECT_NEAR(frequency_seen(stream) / (2 * pi / 9), 1, 1e-6);
    EXPECT_NEAR(
        std::pow(frequency_seen(0) - k * stream, 2) / (gravity_m_s2 * k * std::tanh(k * 20)), 1,
        3e-5);
  }
}

TEST(SeaRealisation, TurningTheSeaTurnsTheMotion) {
  const WaveWater water{25, {}};
  std::vector<WaveComponent> waves = shelf_sea(Stretching::wheeler).waves();
  for (WaveComponent& wave : waves) wave.absolute_rad_s = wave.intrinsic_rad_s;
  const SeaRealisation sea(waves, water, epoch);
  const Horizontal turn = std::polar(1.0, 0.77);
  for (WaveComponent& wave : waves) wave.wavenumber_rad_m *= turn;
  const SeaRealisation turned(waves, water, epoch);
  for (int i = 0; i < 50; ++i) {
    const Horizontal at{3.0 * i, -40.0 + 2.0 * i};
    const WaveSample a = sample_waves(sea, {at.real(), at.imag(), -5, 1.0 * i});
    const Horizontal there = at * turn;
    const WaveSample b = sample_waves(turned, {there.real(), there.imag(), -5, 1.0 * i});
    const Horizontal v{a.motion.velocity_m_s[0], a.motion.velocity_m_s[1]};
    EXPECT_NEAR(std::abs(v * turn - Horizontal{b.motion.velocity_m_s[0], b.motion.velocity_m_s[1]}),
                0, 1e-9);
    EXPECT_NEAR(a.motion.velocity_m_s[2], b.motion.velocity_m_s[2], 1e-9);
  }
}

TEST(SeaRealisation, OutsideTheWaterIsAStatusAndNeverANumber) {
  const SeaRealisation sea = shelf_sea(Stretching::wheeler);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const double eta = sample_waves(sea, {0, 0, -5, 0}).motion.elevation_m;
  struct Row {
    WavePlace at;
    SampleStatus status;
  };
  for (const Row& row : {Row{{0, 0, eta + 1e-6, 0}, SampleStatus::above_surface},
                         Row{{0, 0, 50, 0}, SampleStatus::above_surface},
                         Row{{0, 0, nan, 0}, SampleStatus::above_surface},
                         Row{{0, 0, -25.001, 0}, SampleStatus::below_bed},
                         Row{{0, 0, -inf, 0}, SampleStatus::below_bed},
                         Row{{nan, 0, -5, 0}, SampleStatus::outside_area},
                         Row{{0, 1e7, -5, 0}, SampleStatus::outside_area},
                         Row{{0, 0, -5, 1e9}, SampleStatus::outside_time},
                         Row{{0, 0, -5, nan}, SampleStatus::outside_time}}) {
    const WaveSample s = sample_waves(sea, row.at);
    EXPECT_EQ(s.motion.status, row.status);
    EXPECT_FALSE(has_value(s.motion.status));
    for (int c = 0; c < 3; ++c) {
      EXPECT_TRUE(std::isnan(s.motion.velocity_m_s[c]));
      EXPECT_TRUE(std::isnan(s.acceleration_m_s2[c]));
    }
    EXPECT_TRUE(std::isnan(s.pressure_pa));
    const bool has_surface =
        row.status == SampleStatus::above_surface || row.status == SampleStatus::below_bed;
    EXPECT_EQ(std::isfinite(s.motion.elevation_m), has_surface);
  }
  EXPECT_EQ(sample_waves(sea, {0, 0, eta - 1e-6, 0}).motion.status, SampleStatus::ok);
  EXPECT_EQ(sample_waves(sea, {0, 0, -25, 0}).motion.status, SampleStatus::ok);
}

TEST(SeaRealisation, ACalmSeaIsStill) {
  const SeaRealisation sea = realise(PartitionedSea{}, {25, {}}, 1, epoch);
  const WaveSample s = sample_waves(sea, {3, 4, -5, 6});
  EXPECT_EQ(s.motion.status, SampleStatus::ok);
  EXPECT_EQ(s.motion.elevation_m, 0);
  EXPECT_EQ(s.motion.velocity_m_s[0], 0);
  EXPECT_EQ(sea.significant_height_m(), 0);
}

TEST(SeaRealisation, ManyThreadsReadOneSea) {
  const SeaRealisation sea = shelf_sea(Stretching::wheeler);
  std::vector<WavePlace> places(500);
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = {1.0 * static_cast<double>(i), 0, -4, 2.0 * static_cast<double>(i)};
  }
  std::vector<std::vector<WaveMotion>> out(4, std::vector<WaveMotion>(places.size()));
  std::vector<std::thread> threads;
  for (auto& mine : out) threads.emplace_back([&] { sample_motion(sea, places, mine); });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_EQ(out[0][i].velocity_m_s[0], out[3][i].velocity_m_s[0]);
  }
}

TEST(SeaRealisation, RefusesWavesThatAreNone) {
  const WaveWater water{20, {}};
  WaveComponent still = one_wave(1, 8, water);
  still.wavenumber_rad_m = 0;
  EXPECT_THROW(SeaRealisation({still}, water, epoch), ContractViolation);
  WaveComponent broken = one_wave(1, 8, water);
  broken.amplitude_m = std::nan("");
  EXPECT_THROW(SeaRealisation({broken}, water, epoch), ContractViolation);
  const WaveComponent sound = one_wave(1, 8, water);
  EXPECT_THROW(SeaRealisation({sound}, {0, {}}, epoch), ContractViolation);
  EXPECT_THROW(SeaRealisation(std::vector<WaveComponent>(1025, sound), water, epoch),
               ContractViolation);
  std::vector<WaveMotion> out(1);
  EXPECT_THROW(sample_motion(SeaRealisation({sound}, water, epoch), {}, out), ContractViolation);
}

}  // namespace
}  // namespace slackwater::sea_sampling_test
