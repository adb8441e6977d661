// The two surface craft in regular waves of the very sea that the field service serves.
#include <gtest/gtest.h>

#include <complex>

#include "tests/support/craft_in_waves.h"

namespace slackwater::twin::craft_in_waves_test {
namespace {

using constants::pi;
using tests::afloat;
using tests::elevation;
using tests::RegularWave;
using tests::respond;
using tests::Response;

const char* const both[] = {"wamv16", "ctv24"};
double length_of(const Body& body) { return 6 * body.hull.part[0].strip_length_m; }

TEST(CraftInWaves, RideLongWavesAsTheSurfaceDoes) {
  for (const char* id : both) {
    const Body body = tests::body_of(id);
    const double length = 60 * length_of(body);
    const Response head = respond(body, {length, 0.002 * length, 0});
    EXPECT_NEAR(std::abs(head.heave), 1, 0.01) << id;
    EXPECT_NEAR(std::arg(head.heave), 0, 0.02) << id;
    EXPECT_NEAR(std::abs(head.pitch), 1, 0.01) << id;
    EXPECT_NEAR(std::arg(head.pitch), 0, 0.02) << id;
    EXPECT_NEAR(std::abs(head.carried), 1, 0.01) << id;
    EXPECT_NEAR(std::arg(head.carried), 0, 0.02) << id;
    const Response beam = respond(body, {length, 0.002 * length, 90});
    EXPECT_NEAR(std::abs(beam.heave), 1, 0.01) << id;
    EXPECT_NEAR(std::abs(beam.roll), 1, 0.01) << id;
    EXPECT_NEAR(std::arg(beam.roll), 0, 0.02) << id;
    EXPECT_NEAR(std::abs(beam.carried), 1, 0.01) << id;
    EXPECT_NEAR(std::arg(beam.carried), 0, 0.02) << id;
  }
}

TEST(CraftInWaves, ComeNearerToTheSurfaceTheLongerTheWave) {
  for (const char* id : both) {
    const Body body = tests::body_of(id);
    double before = 1;
    for (const double lengths : {2.0, 4.0, 8.0, 16.0, 32.0}) {
      const double wave_m = lengths * length_of(body);
      const double missed = std::abs(respond(body, {wave_m, 0.001 * wave_m, 0}).heave - 1.0);
      EXPECT_LT(missed, 0.6 * before) << id << ", " << lengths << " lengths";
      before = missed;
    }
  }
}

/// The heave of two prismatic hulls in head seas, all in closed form,
///
///   z/zeta = S e^(-k A/B) (C + i w B_33 - w^2 A_33)/(C + i w B_33 - w^2 (m + A_33))
///
/// with S = sin(6 k l/2)/(6 sin(k l/2)), the mean of the wave over six strips of length l.
TEST(CraftInWaves, HeaveInHeadSeasAsTheClosedFormSays) {
  struct Form {
    const char* id;
    tests::TwinHull hull;
  };
  for (const Form& form : {Form{"wamv16", {4.9, 1.03, tests::of_circle(0.213, 0.10599)}},
                           Form{"ctv24", {23.5, 3.3, tests::of_wedge(57.1, 1.6993)}}}) {
    const Body body = tests::body_of(form.id);
    for (const double lengths : {16.0, 8.0, 4.0, 2.0, 1.5, 0.75}) {
      const RegularWave wave{lengths * form.hull.length_m, 0.0005 * form.hull.length_m, 0};
      const double k = wave.wavenumber(), w = wave.omega();
      const double half_strip = k * form.hull.length_m / 12;
      const double mean = std::sin(6 * half_strip) / (6 * std::sin(half_strip));
      const double fades = std::exp(-k * form.hull.at_rest.area_m2 / form.hull.at_rest.breadth_m);
      const std::complex<double> pushed(form.hull.heave_n_m() - w * w * body.added_mass.entry[2][2],
                                        w * body.linear_damping.linear.z);
      const std::complex<double> expected = mean * fades * pushed / (pushed - w * w * body.mass_kg);
      EXPECT_LT(std::abs(respond(body, wave).heave - expected), 0.01)
          << form.id << ", wave of " << lengths << " lengths";
    }
  }
}

TEST(CraftInWaves, AreLittleMovedByWavesShorterThanThemselves) {
  for (const char* id : both) {
    const Body body = tests::body_of(id);
    const double length = length_of(body);
    // As long as the hull: crest and trough under it take each other's lift away.
    EXPECT_LT(std::abs(respond(body, {length, 0.002 * length, 0}).heave), 0.01) << id;
    for (const double lengths : {1.0, 0.75, 0.5, 0.4}) {
      const Response head = respond(body, {lengths * length, 0.002 * length, 0});
      EXPECT_LT(std::abs(head.heave), 0.3) << id << ", " << lengths;
      EXPECT_LT(std::abs(head.pitch), 0.35) << id << ", " << lengths;
    }
  }
}

TEST(CraftInWaves, RideCrestsAndTroughsOfHighWavesAlike) {
  for (const char* id : both) {
    const Body body = tests::body_of(id);
    const double length = length_of(body);
    const RegularWave wave{8 * length, 0.15 * length, 0};  // steep: k a = 0.12
    const SeaRealisation sea = wave.sea();
    BodyState<double> state = afloat(body);
    const double rest_m = state.position_m.z;
    const int per_period = static_cast<int>(std::ceil(2 * pi / wave.omega() / 0.04));
    const double dt_s = 2 * pi / wave.omega() / per_period;
    double above_m = 0;
    for (int i = 0; i < 12 * per_period; ++i) {
      const double t = i * dt_s;
      const WaterAtStrips<double> water = waves_at_strips(sea, t + 0.5 * dt_s, body.hull, state);
      Forcing<double> forcing;
      forcing.waves = waves_met(body.hull, water);
      if (i >= 4 * per_period)
        above_m += (rest_m - state.position_m.z) -
                   elevation(sea, state.position_m.x, state.position_m.y, t);
      state = stepped(body, state, forcing, dt_s);
    }
    EXPECT_NEAR(above_m / (8 * per_period), 0, 0.01 * wave.amplitude_m) << id;
  }
}

/// Second-order drift by diffraction is not in the model; nor is any other, beside the drift of the
/// water itself.
TEST(CraftInWaves, DoNotDriftFasterThanTheWater) {
  for (const char* id : both) {
    const Body body = tests::body_of(id);
    for (const double from_deg : {0.0, 45.0, 90.0}) {
      const RegularWave wave{2 * length_of(body), 0.004 * length_of(body), from_deg};
      const double stokes = wave.omega() * wave.wavenumber() * wave.amplitude_m * wave.amplitude_m;
      EXPECT_LT(std::abs(respond(body, wave).drift_m_s), 0.01 + stokes) << id << ", " << from_deg;
    }
  }
}

TEST(WavesAtStrips, AreThoseOfTheSeaWhereEachStripIs) {
  const Body body = tests::body_of("ctv24");
  const RegularWave wave{40, 0.5, 60};
  const SeaRealisation sea = wave.sea();
  BodyState<double> state = afloat(body);
  state.position_m = {12, -7, 0.1};
  state.attitude = attitude_of({0.02, -0.03, 2.1});
  const WaterAtStrips<double> water = waves_at_strips(sea, 3.5, body.hull, state);
  const double k = wave.wavenumber(), w = wave.omega();
  for (std::size_t i = 0; i < body.hull.strips; ++i) {
    const Triple<double> at =
        strip_place(body.hull, body.hull.part[0], i, rotation_of(state.attitude), state.position_m);
    EXPECT_NEAR(at.z, 0.85, 0.5);
    // Towards 240 degrees from north.
    const double north = std::cos(240 * pi / 180), east = std::sin(240 * pi / 180);
    const double phase = k * (north * at.x + east * at.y) - w * 3.5 + 0.3;
    const double still = at.z + 0.5 * std::cos(phase);  // below the surface: Wheeler's level
    const double amplitude = 0.5 * std::exp(-k * still);
    // In 2 000 m Wheeler's level is 1 + eta/h of that.
    EXPECT_NEAR(water.head_m[i], amplitude * std::cos(phase), 1e-3);
    EXPECT_NEAR(water.velocity_m_s[i].x, amplitude * w * north * std::cos(phase), 2e-3);
    EXPECT_NEAR(water.velocity_m_s[i].y, amplitude * w * east * std::cos(phase), 2e-3);
    EXPECT_NEAR(water.velocity_m_s[i].z, -amplitude * w * std::sin(phase), 2e-3);
    EXPECT_NEAR(water.acceleration_m_s2[i].x, amplitude * w * w * north * std::sin(phase), 2e-3);
  }
}

TEST(WavesAtStrips, AboveTheSurfaceAreItsElevationAndNoMotionAndOutsideNothing) {
  const Body body = tests::body_of("ctv24");
  const RegularWave wave{40, 0.5, 0};
  BodyState<double> state = afloat(body);
  state.position_m.z = -5;
  const WaterAtStrips<double> water = waves_at_strips(wave.sea(), 3.5, body.hull, state);
  const double x = body.hull.keel_m[2].x;
  EXPECT_NEAR(water.head_m[2], elevation(wave.sea(), x, body.hull.keel_m[2].y, 3.5),
              1e-9);  // the phase of a row, 6e-11 a place
  EXPECT_EQ(water.acceleration_m_s2[2].x, 0);
  state.position_m.x = 2e6;
  EXPECT_TRUE(std::isnan(waves_at_strips(wave.sea(), 3.5, body.hull, state).head_m[0]));
}

}  // namespace
}  // namespace slackwater::twin::craft_in_waves_test
