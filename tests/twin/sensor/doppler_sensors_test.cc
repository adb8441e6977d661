// DVL and ADCP: four beams make a velocity.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "twin/body/attitude.h"
#include "twin/sensor/adcp.h"

namespace slackwater::twin::doppler_sensors_test {
namespace {

using constants::pi;

const Rotation<double> level = rotation_of(Attitude<double>{1, 0, 0, 0});

double length(const Triple<double>& v) { return std::sqrt(dot(v, v)); }
Triple<double> still(const Triple<double>&) { return {}; }

TEST(JanusBeams, StandSlantedAndAcross) {
  const JanusBeams b = janus_beams(pi / 6, pi / 4, false);
  for (const auto& beam : b) {
    EXPECT_NEAR(length(beam), 1, 1e-15);
    EXPECT_NEAR(beam.z, std::cos(pi / 6), 1e-15);
  }
  EXPECT_NEAR(b[0].x, 0.5 * std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(b[0].x + b[1].x, 0, 1e-15);
  EXPECT_NEAR(b[2].y + b[3].y, 0, 1e-15);
  EXPECT_NEAR(b[0].x * b[2].x + b[0].y * b[2].y, 0, 1e-15);
  EXPECT_LT(janus_beams(pi / 6, 0, true)[0].z, 0);
}

TEST(JanusBeams, GiveAnyVelocityBackFromFourOrThree) {
  Rng random(1, "tests/janus");
  for (int i = 0; i < 100; ++i) {
    const JanusBeams beams = janus_beams(random.uniform(0.2, 1), random.uniform(-3, 3), i % 2);
    const Triple<double> v{random.normal(), random.normal(), random.normal()};
    for (int lost = -1; lost < 4; ++lost) {
      BeamSpeeds speeds;
      for (int k = 0; k < 4; ++k)
        if (k != lost)
          speeds[static_cast<std::size_t>(k)] = dot(v, beams[static_cast<std::size_t>(k)]);
      const auto found = janus_velocity(beams, speeds);
      ASSERT_TRUE(found);
      EXPECT_EQ(found->beams, lost < 0 ? 4 : 3);
      EXPECT_LT(length(found->velocity_m_s - v), 1e-11);
      EXPECT_NEAR(found->error_m_s, 0, 1e-12);
    }
  }
  EXPECT_FALSE(janus_velocity(janus_beams(0.5, 0, false), {1.0, std::nullopt, 2.0, std::nullopt}));
}

TEST(JanusBeams, TellByTheirErrorThatTheyDidNotSeeTheSame) {
  const JanusBeams beams = janus_beams(pi / 6, 0, false);
  // The water sinks at 1 m/s where the first plane looks, and not where the second does.
  const auto found = janus_velocity(beams, {beams[0].z, beams[1].z, 0.0, 0.0});
  EXPECT_NEAR(found->velocity_m_s.z, 0.5, 1e-12);
  EXPECT_NEAR(found->error_m_s, 0.5, 1e-12);
}

Dvl exact_dvl() {
  Dvl dvl;
  dvl.scale = 1;
  dvl.noise_sd_m_s = 0;
  return dvl;
}

TEST(DopplerLog, OverTheBedTellsTheVelocityWhateverTheAttitude) {
  NoiseStream noise(2, "rov/dvl");
  Rng random(2, "tests/dvl");
  const Scene sea{{}, 30, 0};
  for (int i = 0; i < 50; ++i) {
    const Rotation<double> r = rotation_of(
        attitude_of({random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(-3, 3)}));
    const Triple<double> v{random.normal(), random.normal(), 0.2 * random.normal()};
    const auto reading = measured(exact_dvl(), noise, sea, still, {5, 6, 12}, r, v);
    ASSERT_TRUE(reading);
    EXPECT_TRUE(reading->bottom);
    EXPECT_EQ(reading->track.beams, 4);
    EXPECT_LT(length(reading->track.velocity_m_s - r.to_body(v)), 1e-12);
  }
  const auto upright = measured(exact_dvl(), noise, sea, still, {5, 6, 12}, level, {});
  EXPECT_NEAR(upright->altitude_m.value(), 18, 1e-12);
}

/// The variance of a least-squares velocity: sd^2 (B^T B)^-1, for four beams 1/(2 sin^2), 1/(2
/// sin^2), 1/(4 cos^2).
TEST(DopplerLog, NoiseOfABeamComesOutByTheSlant) {
  Dvl dvl = exact_dvl();
  dvl.scale = 1.01;
  dvl.noise_sd_m_s = 0.02;
  NoiseStream noise(3, "rov/dvl");
  const Scene sea{{}, 30, 0};
  constexpr int n = 20000;
  double x = 0, xx = 0, zz = 0;
  for (int i = 0; i < n; ++i) {
    const auto v =
        measured(dvl, noise, sea, still, {0, 0, 10}, level, {1, 0, 0})->track.velocity_m_s;
    x += v.x / n;
    xx += (v.x - 1.01) * (v.x - 1.01) / n;
    zz += v.z * v.z / n;
  }
  const double error = 5 * std::sqrt(2.0 / n);
  EXPECT_NEAR(x, 1.01, 5 * 0.03 / std::sqrt(n));
  EXPECT_NEAR(xx / (4e-4 / (2 * 0.25)), 1, error);
  EXPECT_NEAR(zz / (4e-4 / (4 * 0.75)), 1, error);
}

TEST(DopplerLog, LosesTheBedBeyondItsRangeAndThenTracksTheWater) {
  NoiseStream noise(4, "auv/dvl");
  const WaterAt water = [](const Triple<double>& at) {
    return Triple<double>{0.5 - 0.01 * at.z, 0.2, 0};
  };
  const double highest_m = exact_dvl().farthest_m * std::cos(exact_dvl().slant_rad);
  EXPECT_NEAR(highest_m, 50, 0.1);  // the sheet
  const auto at_altitude = [&](double altitude_m) {
    return measured(exact_dvl(), noise, {{}, 200, 0}, water, {0, 0, 200 - altitude_m}, level,
                    {1, 0, 0});
  };
  EXPECT_TRUE(at_altitude(highest_m - 0.01)->bottom);
  const auto high = at_altitude(highest_m + 0.01);
  ASSERT_TRUE(high);
  EXPECT_FALSE(high->bottom);
  EXPECT_FALSE(high->altitude_m);
  // Against the water of the layer's middle, 3 m below.
  const double middle_z = 200 - highest_m - 0.01 + 3;
  EXPECT_NEAR(high->track.velocity_m_s.x, 1 - (0.5 - 0.01 * middle_z), 1e-12);
  EXPECT_NEAR(high->track.velocity_m_s.y, -0.2, 1e-12);
  // Nearer than 5 cm it hears neither bed nor layer.
  EXPECT_FALSE(at_altitude(0.04));
}

TEST(DopplerLog, OneBeamOnAStructureStillCountsTwoMissingLeaveNothing) {
  NoiseStream noise(5, "rov/dvl");
  // A deep sea, water track, and a pile in the way of the forward starboard beam.
  const std::vector<Structure> pile{Cylinder{1.5, 1.5, 0.5, -10, 300}};
  const auto one =
      measured(exact_dvl(), noise, {pile, 300, 0}, still, {0, 0, 10}, level, {1, 0, 0});
  ASSERT_TRUE(one);
  EXPECT_EQ(one->track.beams, 3);
  EXPECT_NEAR(one->track.velocity_m_s.x, 1, 1e-12);
  const std::vector<Structure> piles{Cylinder{1.5, 1.5, 0.5, -10, 300},
                                     Cylinder{1.5, -1.5, 0.5, -10, 300}};
  EXPECT_FALSE(measured(exact_dvl(), noise, {piles, 300, 0}, still, {0, 0, 10}, level, {1, 0, 0}));
}

Adcp exact_adcp() {
  Adcp adcp;
  adcp.noise_sd_m_s = 0;
  return adcp;
}

TEST(CurrentProfiler, SeesALinearProfileExactlyAndACurvedOneSmoothed) {
  NoiseStream noise(6, "site/adcp");
  const Triple<double> bed{0, 0, 30};
  const Rotation<double> turned = rotation_of(attitude_of({0, 0, 0.7}));
  const auto linear = [](const Triple<double>& at) {
    return Triple<double>{0.8 - 0.02 * at.z, 0.01 * at.z, 0.001 * at.z};
  };
  int seen = 0;
  for (const AdcpBin& bin : measured(exact_adcp(), noise, {{}, 30, 0}, linear, bed, turned, {})) {
    if (!bin.velocity_m_s) continue;
    ++seen;
    EXPECT_LT(length(*bin.velocity_m_s - linear({0, 0, bin.down_m})), 1e-12);
    EXPECT_NEAR(bin.error_m_s, 0, 1e-12);
  }
  EXPECT_GT(seen, 20);
  // The triangle of half width b has variance b^2/6; as a sum of eight steps b^2/6 (1 - 1/16).
  const auto curved = [](const Triple<double>& at) {
    return Triple<double>{0.001 * at.z * at.z, 0, 0};
  };
  for (const AdcpBin& bin : measured(exact_adcp(), noise, {{}, 30, 0}, curved, bed, level, {})) {
    if (!bin.velocity_m_s) continue;
    EXPECT_NEAR(bin.velocity_m_s->x, 0.001 * (bin.down_m * bin.down_m + 1.0 / 6 * (1 - 1.0 / 16)),
                1e-12);
  }
}

TEST(CurrentProfiler, LosesWhatTheSideLobesOfTheSurfaceSpoil) {
  NoiseStream noise(7, "site/adcp");
  double shallowest = 1e9, deepest = 0;
  for (const AdcpBin& bin :
       measured(exact_adcp(), noise, {{}, 30, 0}, still, {0, 0, 30}, level, {})) {
    if (!bin.velocity_m_s) continue;
    shallowest = std::min(shallowest, bin.down_m);
    deepest = std::max(deepest, bin.down_m);
  }
  // 6 % of 30 m, 1.81 m, and a bin's triangle: from 2.81 m down, in bins at 30 - 0.9 - n.
  EXPECT_NEAR(shallowest, 3.1, 1e-9);
  EXPECT_NEAR(deepest, 28.1, 1e-9);
}

TEST(CurrentProfiler, NoiseFallsWithTheRootOfThePings) {
  Adcp adcp;
  adcp.bins = 20;
  NoiseStream noise(8, "site/adcp");
  for (const int pings : {1, 100}) {
    adcp.pings = pings;
    double xx = 0;
    int n = 0;
    for (int profile = 0; profile < 1000; ++profile)
      for (const AdcpBin& bin : measured(adcp, noise, {{}, 60, 0}, still, {0, 0, 60}, level, {})) {
        xx += bin.velocity_m_s->x * bin.velocity_m_s->x;
        ++n;
      }
    const double sd =
        adcp.noise_sd_m_s / std::sqrt(pings) / (std::sqrt(2.0) * std::sin(adcp.slant_rad));
    EXPECT_NEAR(std::sqrt(xx / n) / sd, 1, 5 / std::sqrt(2.0 * n));
  }
}

TEST(CurrentProfiler, FoldsWhatIsFasterThanItsAmbiguity) {
  EXPECT_NEAR(folded(1.7, 1.75), 1.7, 1e-15);
  EXPECT_NEAR(folded(1.8, 1.75), -1.7, 1e-15);
  EXPECT_NEAR(folded(-1.8, 1.75), 1.7, 1e-15);
  EXPECT_NEAR(folded(3.6, 1.75), 0.1, 1e-12);
  // 1.75 m/s along a beam of 20 degrees is 5.1 m/s across it: 6 m/s shows as 6 - 3.5/sin 20.
  NoiseStream noise(9, "site/adcp");
  const auto fast = [](const Triple<double>&) { return Triple<double>{6, 0, 0}; };
  const auto profile = measured(exact_adcp(), noise, {{}, 60, 0}, fast, {0, 0, 60}, level, {});
  EXPECT_NEAR(profile[5].velocity_m_s->x, 6 - 3.5 / std::sin(20 * pi / 180), 1e-9);
}

TEST(CurrentProfiler, OnAMovingVesselTakesTheVesselsMotionOut) {
  Adcp adcp = exact_adcp();
  adcp.looks_up = false;
  NoiseStream noise(10, "usv/adcp");
  const auto flow = [](const Triple<double>&) { return Triple<double>{0.4, -0.3, 0}; };
  const Rotation<double> r = rotation_of(attitude_of({0, 0, 2}));
  const auto profile = measured(adcp, noise, {{}, 40, 0}, flow, {0, 0, 0.5}, r, {1.5, 1, 0});
  EXPECT_NEAR(profile[3].velocity_m_s->x, 0.4, 1e-12);
  EXPECT_NEAR(profile[3].velocity_m_s->y, -0.3, 1e-12);
  EXPECT_GT(profile[3].down_m, 0.5);
  EXPECT_FALSE(profile.back().velocity_m_s);  // below the bed
}

}  // namespace
}  // namespace slackwater::twin::doppler_sensors_test
