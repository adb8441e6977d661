#include "fields/wave/height_course.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"
#include "fields/wave/sea_moment.h"
#include "tests/fields/wave/textbook_sea.h"

namespace slackwater::height_course_test {
namespace {

using constants::pi;

SeaRealisation sea_of(double height_m, Stretching stretching = Stretching::wheeler) {
  PartitionedSea sea;
  sea.partitions = {{height_m, 7, 250, {}, 10}};
  const WaveWater water{35, {0.4, -0.1}};
  return {components_of(sea, water, 5, {.count = 64}).waves, water, UtcTime{}, stretching};
}

/// The same waves with other amplitudes.
SeaRealisation times(const SeaRealisation& sea, double factor) {
  std::vector<WaveComponent> waves = sea.waves();
  for (WaveComponent& wave : waves) wave.amplitude_m *= factor;
  return {std::move(waves), sea.water(), sea.epoch(), sea.stretching()};
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
void expect_same_bits(const WaveMotion& a, const WaveMotion& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_TRUE(same_bits(a.elevation_m, b.elevation_m)) << a.elevation_m << ' ' << b.elevation_m;
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(same_bits(a.velocity_m_s[i], b.velocity_m_s[i]));
}
void expect_same_bits(const WaveSample& a, const WaveSample& b) {
  expect_same_bits(a.motion, b.motion);
  EXPECT_TRUE(same_bits(a.pressure_pa, b.pressure_pa));
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(same_bits(a.acceleration_m_s2[i], b.acceleration_m_s2[i]));
}

std::vector<WavePlace> some_places(double t_s) {
  Rng rng(4, "tests/height_course");
  std::vector<WavePlace> places;
  for (int i = 0; i < 30; ++i)
    places.push_back({rng.uniform(-90, 90), rng.uniform(-90, 90), rng.uniform(-36, 1.5), t_s});
  return places;
}

TEST(HeightCourse, IsStraightBetweenItsNodesAndHeldBeyondThem) {
  const HeightCourse course(600, {1, 2, 0, 0.5});
  EXPECT_DOUBLE_EQ(course.at(0), 1);
  EXPECT_DOUBLE_EQ(course.at(150), 1.25);
  EXPECT_DOUBLE_EQ(course.at(600), 2);
  EXPECT_DOUBLE_EQ(course.at(900), 1);
  EXPECT_DOUBLE_EQ(course.at(1200), 0);
  EXPECT_DOUBLE_EQ(course.at(1500), 0.25);
  for (const double t_s : {1800.0, 1801.0, 1e300}) EXPECT_DOUBLE_EQ(course.at(t_s), 0.5);
  for (const double t_s : {-1.0, -1e300, std::nan("")}) EXPECT_DOUBLE_EQ(course.at(t_s), 1);
  EXPECT_EQ(HeightCourse().at(77), 1);
  EXPECT_EQ(HeightCourse(600, {3}).at(77), 3);
  EXPECT_THROW(HeightCourse(0, {1}), ContractViolation);
  EXPECT_THROW(HeightCourse(600, {1, std::nan("")}), ContractViolation);
  EXPECT_THROW(HeightCourse(600, {1, -0.1}), ContractViolation);
}

/// A factor of two changes no digit: the sea must be to the bit that of waves twice as high, in its
/// elevation, its stretching and all its motion, by every way it can be asked, on every path.
TEST(HeightCourse, DoublesASeaToTheBit) {
  const double t_s = 1200;
  for (const Stretching stretching : {Stretching::wheeler, Stretching::none}) {
    const SeaRealisation sea = sea_of(1.5, stretching).following({600, {1, 1.5, 2}});
    const SeaRealisation doubled = times(sea_of(1.5, stretching), 2);
    const std::vector<WavePlace> places = some_places(t_s);
    std::vector<WaveSample> got(places.size()), expected(places.size());
    std::vector<WaveMotion> moved(places.size()), expected_motion(places.size());
    std::vector<double> elevation_m(places.size());
    std::vector<MomentPlace> asked;
    for (const WavePlace& at : places)
      asked.push_back({at.east_m, at.north_m, at.up_m, {0.4, -0.1, 0.2}});
    std::vector<MomentSample> moment(places.size()), expected_moment(places.size());
    const WaveRow row{{3, -8, -0.4, t_s}, 1.5, 0.5, 0.02};
    std::vector<WaveSample> in_row(most_in_row), expected_row(most_in_row);
    sample_waves_on(KernelPath::baseline, doubled, places, expected);
    sample_motion_on(KernelPath::baseline, doubled, places, expected_motion);
    sample_moment_on(KernelPath::baseline, doubled, t_s, asked, expected_moment);
    sample_row_on(KernelPath::baseline, doubled, row, expected_row);
    sample_elevation(sea, places, elevation_m);
    for (const KernelPath path : supported_kernel_paths()) {
      sample_waves_on(path, sea, places, got);
      sample_motion_on(path, sea, places, moved);
      sample_moment_on(path, sea, t_s, asked, moment);
      sample_row_on(path, sea, row, in_row);
      for (std::size_t i = 0; i < places.size(); ++i) {
        expect_same_bits(got[i], expected[i]);
        expect_same_bits(moved[i], expected_motion[i]);
        EXPECT_TRUE(same_bits(elevation_m[i], expected[i].motion.elevation_m));
        expect_same_bits(moment[i].motion, expected_moment[i].motion);
        EXPECT_TRUE(same_bits(moment[i].rise_m_s, expected_moment[i].rise_m_s));
        for (int c = 0; c < 3; ++c)
          EXPECT_TRUE(
              same_bits(moment[i].acceleration_m_s2[c], expected_moment[i].acceleration_m_s2[c]));
      }
      for (std::size_t j = 0; j < in_row.size(); ++j) expect_same_bits(in_row[j], expected_row[j]);
    }
  }
}

TEST(HeightCourse, OfOtherFactorsIsASeaOfThatHeightToRounding) {
  const SeaRealisation plain = sea_of(2);
  for (const double factor : {0.0, 0.37, 1.3}) {
    const SeaRealisation sea = plain.following({600, {0.9, factor}});
    const SeaRealisation expected = times(plain, factor);
    for (const WavePlace& at : some_places(600)) {
      const WaveSample a = sample_waves(sea, at), b = sample_waves(expected, at);
      EXPECT_NEAR(a.motion.elevation_m, b.motion.elevation_m, 1e-12);
      ASSERT_EQ(a.motion.status, b.motion.status) << at.up_m;
      if (!has_value(a.motion.status)) continue;
      EXPECT_NEAR(a.pressure_pa, b.pressure_pa, 1e-8);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(a.motion.velocity_m_s[c], b.motion.velocity_m_s[c], 1e-12);
        EXPECT_NEAR(a.acceleration_m_s2[c], b.acceleration_m_s2[c], 1e-12);
      }
    }
  }
}

TEST(HeightCourse, TheVarianceOfTheSurfaceFollowsIt) {
  const SeaRealisation plain = sea_of(1.5);
  const SeaRealisation sea = plain.following({3600, {1, 2}});
  Rng rng(8, "tests/height_course/variance");
  for (const double t_s : {0.0, 900.0, 1800.0, 3600.0}) {
    constexpr int count = 20000;
    double sum_m2 = 0;
    for (int i = 0; i < count; ++i) {
      const WavePlace at{rng.uniform(-1e5, 1e5), rng.uniform(-1e5, 1e5), 0, t_s};
      double elevation_m = 0;
      sample_elevation(sea, {&at, 1}, {&elevation_m, 1});
      sum_m2 += elevation_m * elevation_m;
    }
    const double factor = 1 + t_s / 3600;
    // Four standard errors of a variance from so many places far from each other.
    EXPECT_NEAR(sum_m2 / count / plain.variance_m2(), factor * factor,
                factor * factor * 4 * std::sqrt(2.0 / count));
  }
}

/// Linear water at z = 0 goes with its surface, d eta/dt = w. What a sea that grows lacks of that
/// is what the header says: T / (2 pi tau) of w at most.
TEST(HeightCourse, WhatItLeavesOutIsAsSmallAsItSays) {
  const WaveWater water{40, {}};
  const double period_s = 10, omega = 2 * pi / period_s;
  const SeaRealisation plain({tests::one_wave(0.8, period_s, water)}, water, UtcTime{},
                             Stretching::none);
  const SeaRealisation sea = plain.following({3600, {1, 2}});
  const auto elevation = [&](double t_s) {
    return sample_waves(sea, {0, 0, 0, t_s}).motion.elevation_m;
  };
  double most = 0, most_w_m_s = 0;
  for (double t_s = 5; t_s < 25; t_s += 0.25) {
    constexpr double h_s = 0.02;  // error h^2 omega^3 / 6: 2e-5 of w
    const double rises = (elevation(t_s + h_s) - elevation(t_s - h_s)) / (2 * h_s);
    const double w_m_s = sample_waves(sea, {0, 0, 0, t_s}).motion.velocity_m_s[2];
    most = std::max(most, std::abs(rises - w_m_s));
    most_w_m_s = std::max(most_w_m_s, std::abs(w_m_s));
  }
  const double tau_s = 3600;  // r / r' at the start
  EXPECT_LT(most / most_w_m_s, 1.1 / (omega * tau_s));
  EXPECT_GT(most / most_w_m_s, 0.8 / (omega * tau_s)) << "it is there, and that is its size";
}

}  // namespace
}  // namespace slackwater::height_course_test
