#include "twin/render/ranging/current_profile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "tests/twin/render/ranging_for_tests.h"
#include "twin/body/attitude.h"

namespace slackwater::twin::current_profile_test {
namespace {

constexpr double reach_m = 100;

Adcp profiler(double slant_deg) {
  Adcp adcp;
  adcp.slant_rad = slant_deg * constants::degree;
  adcp.azimuth_rad = 0.6;
  adcp.bins = 20;
  adcp.pings = 1;
  adcp.noise_sd_m_s = 0;
  adcp.ambiguity_m_s = 5;
  return adcp;
}

WaterAt always(const Triple<double>& velocity_m_s) {
  return [=](const Triple<double>&) { return velocity_m_s; };
}

double away(const Triple<double>& a, const Triple<double>& b) { return length_of(a - b); }

const Cast& deep() {
  static const Cast cast(sloping_mesh(90, 0));
  return cast;
}

// Turned and driven anyhow: the water over ground comes out.
TEST(CurrentProfile, AUniformCurrentIsTakenBackExactly) {
  const Triple<double> current{0.3, -0.5, 0.02};
  Rng rng(4, "test/current_profile");
  for (int i = 0; i < 50; ++i) {
    const Rotation<double> r = rotation_of(attitude_of(
        EulerAngles{rng.uniform(-0.4, 0.4), rng.uniform(-0.4, 0.4), rng.uniform(-3, 3)}));
    Pose pose;
    pose.axis = r.to_ned({0, 0, 1});
    pose.right = r.to_ned({0, 1, 0});
    pose.velocity_m_s = {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-0.2, 0.2)};
    const CurrentProfile told =
        profiled(deep().caster, profiler(i % 2 == 0 ? 20 : 25), always(current), pose, reach_m, 1);
    ASSERT_EQ(told.bins.size(), 20U);
    for (const ProfileBin& bin : told.bins) {
      EXPECT_LT(away(bin.velocity_m_s, current), 1e-12);
      EXPECT_LT(away(bin.true_velocity_m_s, current), 1e-12);
      EXPECT_NEAR(bin.error_m_s, 0, 1e-12);
      EXPECT_EQ(bin.flaw, BinFlaw::none);
      for (std::size_t beam = 0; beam < 4; ++beam)
        EXPECT_NEAR(bin.approach_m_s[beam], dot(pose.velocity_m_s - current, told.beams[beam]),
                    1e-6);
    }
  }
}

TEST(CurrentProfile, BeamsStandOffTheAxisByTheirSlant) {
  const CurrentProfile told =
      profiled(deep().caster, profiler(25), always({}), looking_down(), reach_m, 1);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(told.beams[i].z, std::cos(25 * constants::degree), 1e-12);
    EXPECT_NEAR(told.boundary_range_m[i], 90 / std::cos(25 * constants::degree), 1e-4);
  }
  // From forward of one that looks down, towards the right.
  EXPECT_NEAR(std::atan2(told.beams[0].y, told.beams[0].x), 0.6, 1e-12);
}

// The bin's triangle: what is linear in depth is told as it is at the bin's middle, and of k z^2
// there is 5/32 k bin^2 more (for all of the triangle it would be 1/6).
TEST(CurrentProfile, ShearIsAveragedOverTheBin) {
  constexpr double s = 0.03, k = 0.002;
  const WaterAt water = [](const Triple<double>& at_m) -> Triple<double> {
    return {0.1 + s * at_m.z, k * at_m.z * at_m.z, 0};
  };
  Adcp adcp = profiler(20);
  adcp.bin_m = 2;
  const CurrentProfile told = profiled(deep().caster, adcp, water, looking_down(), reach_m, 1);
  for (std::size_t i = 0; i < told.bins.size(); ++i) {
    const ProfileBin& bin = told.bins[i];
    const double z = adcp.blanking_m + (static_cast<double>(i) + 1) * 2;
    EXPECT_EQ(bin.distance_m, z);
    EXPECT_EQ(bin.depth_m, z);
    EXPECT_NEAR(bin.velocity_m_s.x, 0.1 + s * z, 1e-12);
    EXPECT_NEAR(bin.velocity_m_s.y, k * z * z + 5.0 / 32 * k * 4, 1e-12);
    EXPECT_LT(away(bin.true_velocity_m_s, bin.velocity_m_s), 1e-12);
  }
}

// Of two planes of beams, each c (s0 - s1) / 2 sin(slant): sd / (2^(1/2) sin(slant)) across, and
// sd / (2 cos(slant)) along the axis.
TEST(CurrentProfile, ItsNoiseIsThatOfFourBeams) {
  Adcp adcp = profiler(20);
  adcp.noise_sd_m_s = 0.1;
  adcp.pings = 4;
  double north = 0, east = 0, down = 0, count = 0, beams = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed)
    for (const ProfileBin& bin :
         profiled(deep().caster, adcp, always({0.2, 0, 0}), looking_down(), reach_m, seed).bins) {
      north += std::pow(bin.velocity_m_s.x - 0.2, 2);
      east += std::pow(bin.velocity_m_s.y, 2);
      down += std::pow(bin.velocity_m_s.z, 2);
      beams += std::pow(bin.error_m_s, 2);
      ++count;
    }
  const double sd = 0.05, sine = std::sin(adcp.slant_rad), cosine = std::cos(adcp.slant_rad);
  const double tolerance = 4 * std::sqrt(2 / count);
  EXPECT_NEAR(north / count / std::pow(sd / (std::sqrt(2.0) * sine), 2), 1, tolerance);
  EXPECT_NEAR(east / count / std::pow(sd / (std::sqrt(2.0) * sine), 2), 1, tolerance);
  EXPECT_NEAR(down / count / std::pow(sd / (2 * cosine), 2), 1, tolerance);
  // A quarter of the sum of four beams over cos(slant).
  EXPECT_NEAR(beams / count / std::pow(0.5 * sd / cosine, 2), 1, tolerance);
}

// The last 1 - cos(slant) of the way to the bed, or to the surface of one that looks up, is lost,
// and the half of a bin's triangle.
TEST(CurrentProfile, NoBinReachesIntoTheSideLobesOfBedAndSurface) {
  Pose up = looking_down();
  up.axis = {0, 0, -1};
  for (const double slant_deg : {20.0, 25.0})
    for (const bool is_up : {false, true}) {
      const Adcp adcp = profiler(slant_deg);
      const Cast cast(sloping_mesh(is_up ? -15 : 15, 0));
      const Triple<double> current{0.2, -0.1, 0};
      const CurrentProfile told =
          profiled(cast.caster, adcp, always(current), is_up ? up : looking_down(), reach_m, 1);
      std::size_t lost = 0;
      for (const ProfileBin& bin : told.bins) {
        const bool is_free = bin.distance_m + adcp.bin_m <= 15 * std::cos(adcp.slant_rad);
        EXPECT_EQ(bin.flaw, is_free ? BinFlaw::none : BinFlaw::side_lobe) << bin.distance_m;
        EXPECT_EQ(std::isfinite(bin.velocity_m_s.x), is_free);
        EXPECT_EQ(bin.depth_m, is_up ? -bin.distance_m : bin.distance_m);
        if (is_free) {
          EXPECT_LT(away(bin.velocity_m_s, current), 1e-12);
        }
        lost += is_free ? 0 : 1;
      }
      EXPECT_GT(lost, 5U);
    }
}

// A post in one beam's way: three are enough, and cannot disagree.
TEST(CurrentProfile, ThreeBeamsAreEnough) {
  const Adcp adcp = profiler(20);
  const JanusBeams beams = janus_beams(adcp.slant_rad, adcp.azimuth_rad, false);
  const Triple<double> in_the_way = 6.0 * beams[2];
  TriangleMesh ball = sphere_mesh(0, 0.5, 20);
  ball.origin_m = in_the_way;
  const Cast cast({sloping_mesh(90, 0), ball});
  const Triple<double> current{0.3, -0.5, 0};
  const CurrentProfile told =
      profiled(cast.caster, adcp, always(current), looking_down(), reach_m, 1);
  EXPECT_NEAR(told.boundary_range_m[2], 5.5, 0.01);
  std::size_t by_three = 0;
  for (const ProfileBin& bin : told.bins) {
    EXPECT_LT(away(bin.velocity_m_s, current), 1e-12);
    by_three += std::isnan(bin.error_m_s) ? 1 : 0;
    EXPECT_EQ(std::isnan(bin.error_m_s), std::isnan(bin.approach_m_s[2]));
  }
  EXPECT_GT(by_three, 10U);
}

TEST(CurrentProfile, FoldsWhatIsFasterThanItKnows) {
  Adcp adcp = profiler(20);
  adcp.ambiguity_m_s = 0.5;
  Pose pose = looking_down();
  pose.velocity_m_s = {3, 0, 0};
  const CurrentProfile told = profiled(deep().caster, adcp, always({}), pose, reach_m, 1);
  for (std::size_t beam = 0; beam < 4; ++beam) {
    const double speed_m_s = 3 * told.beams[beam].x;
    EXPECT_NEAR(told.bins[0].approach_m_s[beam], std::remainder(speed_m_s, 1.0), 1e-6);
  }
  EXPECT_GT(away(told.bins[0].velocity_m_s, {}), 0.5);
}

TEST(CurrentProfile, WhereNobodyKnowsTheWaterThereIsNoValue) {
  const WaterAt water = [](const Triple<double>& at_m) -> Triple<double> {
    if (at_m.z > 8) return {std::nan(""), std::nan(""), std::nan("")};
    return {0.2, 0, 0};
  };
  for (const ProfileBin& bin :
       profiled(deep().caster, profiler(20), water, looking_down(), reach_m, 1).bins) {
    const bool is_wet = bin.distance_m + 0.75 <= 8;
    EXPECT_EQ(bin.flaw, is_wet ? BinFlaw::none : BinFlaw::no_water) << bin.distance_m;
    EXPECT_EQ(std::isfinite(bin.velocity_m_s.x), is_wet);
  }
}

}  // namespace
}  // namespace slackwater::twin::current_profile_test
