#include "fields/wave/sea_moment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"

namespace slackwater::sea_moment_test {
namespace {

SeaRealisation sea_of(double height_m, double period_s, double depth_m, std::uint64_t seed,
                      Stretching stretching = Stretching::wheeler) {
  PartitionedSea sea;
  sea.partitions = {{height_m, period_s, 250, {}, 10}};
  const WaveWater water{depth_m, {0.4, -0.1}};
  return {components_of(sea, water, seed).waves, water, UtcTime{}, stretching};
}

/// A place within a tether's reach and a day.
WavePlace random_place(double depth_m, Rng& rng) {
  return {rng.uniform(-150, 150), rng.uniform(-150, 150), rng.uniform(-1.1 * depth_m, 2),
          rng.uniform(0, 86400)};
}

/// Sum of what all waves can do at once at the surface.
struct Most {
  double elevation_m = 0, velocity_m_s = 0, acceleration_m_s2 = 0;
};
Most most_of(const SeaRealisation& sea) {
  Most most;
  for (const WaveComponent& wave : sea.waves()) {
    const double kh = std::abs(wave.wavenumber_rad_m) * sea.water().depth_m;
    const double speed = wave.amplitude_m * wave.intrinsic_rad_s / std::tanh(kh);
    most.elevation_m += wave.amplitude_m;
    most.velocity_m_s += speed;
    most.acceleration_m_s2 += speed * wave.intrinsic_rad_s;
  }
  return most;
}

TEST(SeaMoment, IsTheSeaOfDoublePrecision) {
  Rng rng(3, "tests/sea_moment");
  constexpr double tolerance = 5e-5;  // as the header says
  for (const double depth_m : {8.0, 35.0, 300.0}) {
    for (const Stretching stretching : {Stretching::wheeler, Stretching::none}) {
      const SeaRealisation sea = sea_of(1.5, rng.uniform(4, 10), depth_m, 5, stretching);
      const Most most = most_of(sea);
      std::size_t in_water = 0;
      for (int round = 0; round < 20; ++round) {
        std::vector<MomentPlace> places;
        std::vector<WavePlace> same;
        const double t_s = rng.uniform(0, 86400);
        for (int i = 0; i < 18; ++i) {
          same.push_back(random_place(depth_m, rng));
          same.back().t_s = t_s;
          // Gone with the current, so that the accelerations are of one kind.
          const Horizontal current_m_s = sea.water().current_m_s;
          places.push_back({same.back().east_m,
                            same.back().north_m,
                            same.back().up_m,
                            {current_m_s.real(), current_m_s.imag(), 0}});
        }
        std::vector<MomentSample> got(places.size());
        std::vector<WaveSample> expected(places.size());
        sample_moment(sea, t_s, places, got);
        sample_waves(sea, same, expected);
        for (std::size_t i = 0; i < places.size(); ++i) {
          const WaveMotion& a = got[i].motion;
          const WaveMotion& b = expected[i].motion;
          EXPECT_NEAR(a.elevation_m, b.elevation_m, tolerance * most.elevation_m);
          if (a.status != b.status) {
            // Only where rounding decides which side of the surface it is on.
            EXPECT_NEAR(places[i].up_m, b.elevation_m, 1e-4);
            continue;
          }
          if (!has_value(a.status)) continue;
          ++in_water;
          for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(a.velocity_m_s[axis], b.velocity_m_s[axis], tolerance * most.velocity_m_s);
            if (stretching == Stretching::none) {
              EXPECT_NEAR(got[i].acceleration_m_s2[axis], expected[i].acceleration_m_s2[axis],
                          tolerance * most.acceleration_m_s2);
            }
          }
        }
      }
      EXPECT_GT(in_water, 200U);
    }
  }
}

TEST(SeaMoment, TellsHowTheVelocityChangesAlongAWay) {
  Rng rng(7, "tests/sea_moment");
  for (int round = 0; round < 100; ++round) {
    const SeaRealisation sea =
        sea_of(1.5, 5, 30, 5, round % 2 == 0 ? Stretching::none : Stretching::wheeler);
    const Most most = most_of(sea);
    const double v[3] = {rng.uniform(-2, 2), rng.uniform(-2, 2), rng.uniform(-1, 1)};
    const WavePlace at{rng.uniform(-50, 50), rng.uniform(-50, 50), rng.uniform(-15, -1), 500};
    constexpr double h_s = 1e-3;
    const auto moved = [&](double by_s) {
      return sample_waves(sea, {at.east_m + by_s * v[0], at.north_m + by_s * v[1],
                                at.up_m + by_s * v[2], at.t_s + by_s});
    };
    const WaveSample before = moved(-h_s), after = moved(h_s);
    const MomentPlace place{at.east_m, at.north_m, at.up_m, {v[0], v[1], v[2]}};
    MomentSample got;
    sample_moment(sea, at.t_s, {&place, 1}, {&got, 1});
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(got.acceleration_m_s2[axis],
                  (after.motion.velocity_m_s[axis] - before.motion.velocity_m_s[axis]) / (2 * h_s),
                  1e-4 * most.acceleration_m_s2);
    }
  }
}

TEST(SeaMoment, HasTheSameBitsOnEveryInstructionSet) {
  Rng rng(4, "tests/sea_moment");
  const SeaRealisation sea = sea_of(1, 6, 40, 9);
  std::vector<MomentPlace> places;
  for (int i = 0; i < 32; ++i)
    places.push_back({rng.uniform(-90, 90),
                      rng.uniform(-90, 90),
                      rng.uniform(-40, 1),
                      {rng.normal(), rng.normal(), rng.normal()}});
  std::vector<MomentSample> first(places.size()), other(places.size());
  sample_moment_on(KernelPath::baseline, sea, 1234.5, places, first);
  for (const KernelPath path : supported_kernel_paths()) {
    sample_moment_on(path, sea, 1234.5, places, other);
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_EQ(first[i].motion.status, other[i].motion.status);
      EXPECT_EQ(std::memcmp(&first[i].motion.elevation_m, &other[i].motion.elevation_m, 32), 0);
      EXPECT_EQ(std::memcmp(first[i].acceleration_m_s2, other[i].acceleration_m_s2, 24), 0)
          << name_of(path) << ", " << i;
    }
  }
}

TEST(SeaMoment, SaysWhatLiesOutside) {
  const SeaRealisation sea = sea_of(1, 6, 40, 9);
  const std::vector<MomentPlace> places{
      {0, 0, -5, {}}, {0, 0, 3, {}}, {0, 0, -41, {}}, {3000, 0, -5, {}}, {0, std::nan(""), -5, {}}};
  std::vector<MomentSample> got(places.size());
  sample_moment(sea, 10, places, got);
  EXPECT_EQ(got[0].motion.status, SampleStatus::ok);
  EXPECT_EQ(got[1].motion.status, SampleStatus::above_surface);
  EXPECT_TRUE(std::isfinite(got[1].motion.elevation_m));
  EXPECT_TRUE(std::isnan(got[1].motion.velocity_m_s[0]));
  EXPECT_EQ(got[2].motion.status, SampleStatus::below_bed);
  EXPECT_EQ(got[3].motion.status, SampleStatus::outside_area);
  EXPECT_EQ(got[4].motion.status, SampleStatus::outside_area);
  sample_moment(sea, 1e9, places, got);
  EXPECT_EQ(got[0].motion.status, SampleStatus::outside_time);
  std::vector<MomentSample> few(2);
  EXPECT_THROW(sample_moment(sea, 0, places, few), ContractViolation);
}

}  // namespace
}  // namespace slackwater::sea_moment_test
