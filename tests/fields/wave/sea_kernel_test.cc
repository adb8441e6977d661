#include "fields/wave/sea_kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"
#include "tests/fields/wave/textbook_sea.h"

namespace slackwater::sea_kernel_test {
namespace {

using constants::pi;
using tests::textbook_sea;

/// A sea of `count` waves with nothing ordered about it, heights over four decades.
SeaRealisation wild_sea(std::size_t count, double depth_m, std::uint64_t seed,
                        Stretching stretching) {
  Rng rng(seed, "wild_sea");
  const WaveWater water{depth_m, {rng.uniform(-1, 1), rng.uniform(-1, 1)}};
  std::vector<WaveComponent> waves;
  for (std::size_t i = 0; i < count; ++i) {
    const double period = std::exp(rng.uniform(std::log(0.5), std::log(40.0)));
    const double turn = rng.uniform(-pi, pi);
    waves.push_back(tests::one_wave(std::pow(10.0, rng.uniform(-5, -1.5)), period, water,
                                    std::polar(1.0, turn), rng.uniform(-10, 10)));
  }
  return {std::move(waves), water, UtcTime{}, stretching};
}

std::vector<WavePlace> wild_places(double depth_m, std::uint64_t seed) {
  Rng rng(seed, "wild_places");
  std::vector<WavePlace> places;
  for (int i = 0; i < 60; ++i) {
    places.push_back({rng.uniform(-1e5, 1e5), rng.uniform(-1e5, 1e5), -depth_m * rng.uniform(),
                      rng.uniform(-1e7, 1e7)});
  }
  places[0] = {0, 0, -depth_m, 0};
  places[1] = {0, 0, 0, 0};
  places[2] = {0, 0, 1, 0};
  places[3] = {0, 0, std::nan(""), 0};
  places[4] = {std::nan(""), 0, 0, 0};
  places[5] = {1e300, 0, 0, 0};
  places[6] = {0, 0, -1e300, 0};
  return places;
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool same_bits(const WaveSample& a, const WaveSample& b) {
  bool same = a.motion.status == b.motion.status &&
              same_bits(a.motion.elevation_m, b.motion.elevation_m) &&
              same_bits(a.pressure_pa, b.pressure_pa);
  for (int i = 0; i < 3; ++i) {
    same = same && same_bits(a.motion.velocity_m_s[i], b.motion.velocity_m_s[i]) &&
           same_bits(a.acceleration_m_s2[i], b.acceleration_m_s2[i]);
  }
  return same;
}

TEST(SeaKernel, EveryPathOfThisMachineGivesTheSameBits) {
  const auto paths = supported_kernel_paths();
  // Counts around the eight lanes, depths from a puddle, where e^-2kh is 1, to where it is 0.
  for (const std::size_t count : {0u, 1u, 2u, 7u, 8u, 9u, 15u, 16u, 17u, 200u, 1024u}) {
    for (const double depth : {0.5, 30.0, 5000.0}) {
      const SeaRealisation sea = wild_sea(count, depth, count, Stretching::wheeler);
      const std::vector<WavePlace> places = wild_places(depth, count);
      std::vector<WaveSample> reference(places.size());
      sample_waves_on(KernelPath::baseline, sea, places, reference);
      for (const KernelPath path : paths) {
        std::vector<WaveSample> out(places.size());
        std::vector<WaveMotion> motion(places.size());
        sample_waves_on(path, sea, places, out);
        sample_motion_on(path, sea, places, motion);
        for (std::size_t i = 0; i < places.size(); ++i) {
          EXPECT_TRUE(same_bits(out[i], reference[i])) << name_of(path) << ' ' << count << ' ' << i;
          // Asking for less is no other arithmetic.
          EXPECT_TRUE(same_bits(motion[i].velocity_m_s[2], out[i].motion.velocity_m_s[2]));
          EXPECT_TRUE(same_bits(motion[i].velocity_m_s[0], out[i].motion.velocity_m_s[0]));
        }
      }
    }
  }
}

TEST(SeaRow, IsItsPlacesOneByOne) {
  for (const std::size_t count : {0u, 1u, 9u, 200u}) {
    const SeaRealisation sea = wild_sea(count, 30, count, Stretching::none);
    double amplitudes = 0, pushes = 0;
    for (const WaveComponent& wave : sea.waves()) {
      amplitudes += wave.amplitude_m;
      pushes += wave.amplitude_m * std::pow(wave.intrinsic_rad_s, 2) /
                std::tanh(30 * std::abs(wave.wavenumber_rad_m));
    }
    // The same to the rounding of the phase for a first place; then 2e-11 of sin and cos, and twice
    // that of their product, for each place.
    const double off = 1e-10 + most_in_row * 6e-11;
    Rng rng(9, "sea_row");
    for (int round = 0; round < 40; ++round) {
      const WaveRow row{{rng.uniform(-1e3, 1e3), rng.uniform(-1e3, 1e3), -30 * rng.uniform(), 3e3},
                        rng.uniform(-20, 20),
                        rng.uniform(-20, 20),
                        rng.uniform(-2, 2)};
      std::vector<WaveSample> out(most_in_row);
      sample_row(sea, row, out);
      for (std::size_t j = 0; j < out.size(); ++j) {
        const auto steps = static_cast<double>(j);
        const WaveSample alone = sample_waves(sea, {row.first.east_m + steps * row.east_step_m,
                                                    row.first.north_m + steps * row.north_step_m,
                                                    row.first.up_m + steps * row.up_step_m, 3e3});
        ASSERT_EQ(out[j].motion.status, alone.motion.status);
        EXPECT_NEAR(out[j].motion.elevation_m, alone.motion.elevation_m, off * amplitudes);
        if (!has_value(alone.motion.status)) continue;
        EXPECT_NEAR(out[j].pressure_pa, alone.pressure_pa, 1e4 * off * amplitudes);
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(out[j].acceleration_m_s2[c], alone.acceleration_m_s2[c], off * pushes);
      }
    }
  }
}

TEST(SeaRow, HasTheSameBitsOnEveryPath) {
  const SeaRealisation sea = wild_sea(17, 30, 3, Stretching::wheeler);
  const WaveRow row{{10, -20, -0.3, 77}, 1.5, 0.5, 0.02};
  std::vector<WaveSample> reference(most_in_row), out(most_in_row);
  sample_row_on(KernelPath::baseline, sea, row, reference);
  for (const KernelPath path : supported_kernel_paths()) {
    sample_row_on(path, sea, row, out);
    for (std::size_t j = 0; j < out.size(); ++j)
      EXPECT_TRUE(same_bits(out[j], reference[j])) << name_of(path) << ' ' << j;
  }
}

TEST(SeaRow, ThatLeavesTheSeaIsOutsideAltogether) {
  const SeaRealisation sea = wild_sea(8, 30, 3, Stretching::wheeler);
  std::vector<WaveSample> out(3);
  for (const WaveRow& row :
       {WaveRow{{999999, 0, -1, 0}, 1, 0, 0}, WaveRow{{1e7, 0, -1, 0}, 0, 0, 0},
        WaveRow{{0, 0, -1, 0}, std::nan(""), 0, 0}}) {
    sample_row(sea, row, out);
    for (const WaveSample& sample : out) {
      EXPECT_EQ(sample.motion.status, SampleStatus::outside_area);
      EXPECT_TRUE(std::isnan(sample.motion.elevation_m));
    }
  }
  sample_row(sea, {{0, 0, -1, 1e9}, 0, 0, 0}, out);
  EXPECT_EQ(out[0].motion.status, SampleStatus::outside_time);
  std::vector<WaveSample> many(most_in_row + 1);
  EXPECT_THROW(sample_row(sea, {}, many), ContractViolation);
}

TEST(SeaKernel, IsTheTextbookWithinItsStatedErrors) {
  double worst = 0;
  for (const double depth : {2.0, 15.0, 40.0}) {  // where the textbook's cosh does not overflow
    const SeaRealisation sea = wild_sea(200, depth, 5, Stretching::none);
    double amplitudes = 0, speeds = 0, pushes = 0;
    for (const WaveComponent& wave : sea.waves()) {
      const double k = std::abs(wave.wavenumber_rad_m);
      amplitudes += wave.amplitude_m;
      speeds += wave.amplitude_m * wave.intrinsic_rad_s / std::tanh(k * depth);
      pushes += wave.amplitude_m * std::pow(wave.intrinsic_rad_s, 2) / std::tanh(k * depth);
    }
    Rng rng(6, "textbook");
    for (int i = 0; i < 300; ++i) {
      // A day and a kilometre: phases of 1e6 rad, rounded to 1e-10 rad on both sides.
      const WavePlace at{rng.uniform(-1e3, 1e3), rng.uniform(-1e3, 1e3), -depth * rng.uniform(),
                         rng.uniform(0, 86400)};
      const WaveSample ours = sample_waves(sea, at);
      const WaveSample theirs = textbook_sea(sea, at, at.up_m);
      ASSERT_EQ(ours.motion.status, SampleStatus::ok);
      const auto off = [&](double a, double b, double scale) {
        ASSERT_TRUE(std::isfinite(b));
        worst = std::max(worst, std::abs(a - b) / scale);
      };
      off(ours.motion.elevation_m, theirs.motion.elevation_m, amplitudes);
      off(ours.pressure_pa, theirs.pressure_pa, 1025 * 9.80665 * amplitudes);
      for (int c = 0; c < 3; ++c) {
        off(ours.motion.velocity_m_s[c], theirs.motion.velocity_m_s[c], speeds);
        off(ours.acceleration_m_s2[c], theirs.acceleration_m_s2[c], pushes);
      }
    }
  }
  EXPECT_LT(worst, 2e-10);  // 6e-11 of the decay, 2e-11 of sin and cos, 1e-10 of the phase
  RecordProperty("worst_relative_error", std::to_string(worst * 1e12) + "e-12");
}

TEST(SeaKernel, DeepPlacesFeelNothingThatMatters) {
  // The kernel stops at waves that do not reach down: below 3e-14 of what they are at the surface.
  const SeaRealisation sea = wild_sea(200, 40, 8, Stretching::none);
  for (const double z : {-1.0, -5.0, -20.0, -39.0}) {
    const WavePlace at{10, 20, z, 30};
    const WaveSample ours = sample_waves(sea, at);
    const WaveSample theirs = textbook_sea(sea, at, z);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(ours.motion.velocity_m_s[c], theirs.motion.velocity_m_s[c], 1e-10) << z;
    }
  }
}

}  // namespace
}  // namespace slackwater::sea_kernel_test
