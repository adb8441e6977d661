// GNSS, inertial unit, depth and compass: what they show is the truth and their stated errors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fields/base/constants.h"
#include "fields/base/turn.h"
#include "twin/body/attitude.h"
#include "twin/sensor/compass.h"
#include "twin/sensor/depth_sensor.h"
#include "twin/sensor/gnss.h"
#include "twin/sensor/imu.h"

namespace slackwater::twin::navigation_sensors_test {
namespace {

using constants::gravity_m_s2;
using constants::pi;

TEST(GnssReceiver, ErrsByItsWhiteAndItsSlowPart) {
  Gnss gnss;
  gnss.slow_horizontal_m.correlation_time_s = gnss.slow_vertical_m.correlation_time_s = 60;
  GnssState state = started(gnss, NoiseStream(5, "usv/gnss"));
  constexpr int n = 200000;
  const Triple<double> antenna{100, -200, -2};
  double sum = 0, squares = 0, steps = 0, before = 0, doppler = 0;
  int within = 0;
  for (int i = 0; i < n; ++i) {
    const auto fix = measured(gnss, state, antenna, {1, 0, 0}, 0, 1.0);
    ASSERT_TRUE(fix.has_value());
    const Triple<double> error = fix->position_m - antenna;
    sum += error.x;
    squares += error.x * error.x;
    if (i > 0) steps += (error.x - before) * (error.x - before);
    before = error.x;
    within += std::hypot(error.x, error.y) < 2.4;
    doppler += std::pow(fix->velocity_m_s.x - 1, 2);
  }
  // n/120 independent values of the slow part: a relative standard error of 3.5 % of its variance.
  const double white2 = 0.3 * 0.3, slow2 = 0.93 * 0.93;
  EXPECT_NEAR(sum / n, 0, 5 * 0.93 * std::sqrt(120.0 / n));
  EXPECT_NEAR(squares / n, white2 + slow2, 5 * slow2 * std::sqrt(2 * 120.0 / n));
  // From second to second nearly all of it is white.
  EXPECT_NEAR(steps / n, 2 * white2 + 2 * slow2 * (1 - std::exp(-1 / 60.0)), 0.01);
  EXPECT_NEAR(static_cast<double>(within) / n, 0.95, 0.015);
  EXPECT_NEAR(doppler / n, 0.05 * 0.05, 5 * 0.0025 * std::sqrt(2.0 / n));
}

TEST(GnssReceiver, IsSilentUnderWaterAndForAWhileAfter) {
  const Gnss gnss;
  GnssState state = started(gnss, NoiseStream(5, "auv/gnss"));
  const auto has_fix = [&](double down_m, double surface_m) {
    return measured(gnss, state, {0, 0, down_m}, {}, surface_m, 1.0).has_value();
  };
  EXPECT_TRUE(has_fix(-0.3, 0));
  EXPECT_FALSE(has_fix(-0.3, -0.5));  // a crest
  EXPECT_FALSE(has_fix(5, 0));
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(has_fix(-0.3, 0)) << i;
  EXPECT_TRUE(has_fix(-0.3, 0));
}

TEST(GnssReceiver, DrawsAsMuchUnderWaterAsAbove) {
  const Gnss gnss;
  GnssState above = started(gnss, NoiseStream(5, "auv/gnss"));
  GnssState dives = above;
  for (int i = 0; i < 100; ++i) {
    (void)measured(gnss, above, {0, 0, -1}, {}, 0, 1.0);
    (void)measured(gnss, dives, {0, 0, i < 50 ? 9.0 : -1.0}, {}, 0, 1.0);
    EXPECT_NEAR(above.slow_m.x, dives.slow_m.x, 0);
  }
}

TEST(InertialUnit, AtRestFeelsWhatHoldsItUp) {
  for (const EulerAngles& a :
       {EulerAngles{0, 0, 1}, EulerAngles{0.3, -0.2, 2}, EulerAngles{-1, 0.7, 0}}) {
    const Triple<double> f = specific_force_m_s2(rotation_of(attitude_of(a)), {});
    EXPECT_NEAR(f.x, gravity_m_s2 * std::sin(a.pitch_rad), 1e-12);
    EXPECT_NEAR(f.y, -gravity_m_s2 * std::cos(a.pitch_rad) * std::sin(a.roll_rad), 1e-12);
    EXPECT_NEAR(f.z, -gravity_m_s2 * std::cos(a.pitch_rad) * std::cos(a.roll_rad), 1e-12);
  }
  // In free fall nothing; turned to the east, an acceleration eastward is forward.
  const Triple<double> falls =
      specific_force_m_s2(rotation_of(attitude_of({0.4, 0.2, 1})), {0, 0, gravity_m_s2});
  EXPECT_NEAR(dot(falls, falls), 0, 1e-24);
  EXPECT_NEAR(specific_force_m_s2(rotation_of(attitude_of({0, 0, pi / 2})), {0, 2, 0}).x, 2, 1e-12);
}

/// Overlapping Allan variance of rates, for averages over m samples.
double allan_variance(const std::vector<double>& rate, std::size_t m, double dt_s) {
  std::vector<double> angle(rate.size() + 1, 0.0);
  for (std::size_t i = 0; i < rate.size(); ++i) angle[i + 1] = angle[i] + rate[i] * dt_s;
  double sum = 0;
  const std::size_t n = angle.size() - 2 * m;
  for (std::size_t i = 0; i < n; ++i) {
    const double d = angle[i + 2 * m] - 2 * angle[i + m] + angle[i];
    sum += d * d;
  }
  const double t = static_cast<double>(m) * dt_s;
  return sum / (2 * t * t * static_cast<double>(n));
}

/// N^2/t + K^2 t/3: IEEE Std 952-1997, annex C.
TEST(InertialUnit, HasTheAllanVarianceOfItsDensities) {
  Imu imu;
  imu.gyro = {1e-3, 1e-4, 0, 100};
  imu.accelerometer = {2e-2, 1e-3, 0, 1000};
  ImuState state = started(imu, NoiseStream(9, "tests/allan"));
  constexpr double dt_s = 0.1;
  constexpr std::size_t n = 400000;
  std::vector<double> gyro(n), accelerometer(n);
  const Rotation<double> level = rotation_of(Attitude<double>{1, 0, 0, 0});
  for (std::size_t i = 0; i < n; ++i) {
    const ImuReading reading = measured(imu, state, level, {}, {}, dt_s);
    gyro[i] = reading.turn_rate_rad_s.x;
    accelerometer[i] = reading.specific_force_m_s2.y;
  }
  for (const std::size_t m :
       {std::size_t{1}, std::size_t{10}, std::size_t{100}, std::size_t{1000}}) {
    const double t = static_cast<double>(m) * dt_s;
    // An estimate from n/m averages; at m = 1 the walk within a sample is lumped, which is less
    // than 1e-4 of it.
    const double error = 5 * std::sqrt(3.0 * static_cast<double>(m) / n);
    const double g = 1e-6 / t + 1e-8 * t / 3, a = 4e-4 / t + 1e-6 * t / 3;
    EXPECT_NEAR(allan_variance(gyro, m, dt_s) / g, 1, error) << t << " s";
    EXPECT_NEAR(allan_variance(accelerometer, m, dt_s) / a, 1, error) << t << " s";
  }
}

TEST(InertialUnit, IsClippedAtItsRange) {
  Imu imu;
  ImuState state = started(imu, NoiseStream(9, "tests/clip"));
  const auto reading =
      measured(imu, state, rotation_of(Attitude<double>{1, 0, 0, 0}), {100, -100, 0}, {}, 0.01);
  EXPECT_EQ(reading.turn_rate_rad_s.x, imu.gyro.range);
  EXPECT_EQ(reading.turn_rate_rad_s.y, -imu.gyro.range);
}

TEST(DepthByPressure, IsScaledNoisyAndInSteps) {
  const DepthSensor sensor{1.002, 0.1, 0.05, 0.002, 300};
  NoiseStream noise(4, "rov/depth");
  constexpr int n = 20000;
  double sum = 0, squares = 0;
  for (int i = 0; i < n; ++i) {
    const double d = measured_depth_m(sensor, noise, 50, 0);
    EXPECT_NEAR(d / 0.002, std::round(d / 0.002), 1e-6);
    sum += d;
    squares += d * d;
  }
  const double mean = sum / n;
  EXPECT_NEAR(mean, 50.2, 5 * 0.05 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(squares / n - mean * mean), 0.05, 5 * 0.05 / std::sqrt(2.0 * n));
}

TEST(DepthByPressure, CountsFromTheSurfaceAsItStands) {
  const DepthSensor exact{1, 0, 0, 0, 300};
  NoiseStream noise(4, "rov/depth");
  EXPECT_EQ(measured_depth_m(exact, noise, 10, -2), 12);
  EXPECT_EQ(measured_depth_m(exact, noise, -1, 0), 0);
  EXPECT_EQ(measured_depth_m(exact, noise, 400, 0), 300);
}

/// Swinging the compass: the harmonics of what it shows are its coefficients.
TEST(MagneticCompass, DeviatesByItsFiveCoefficients) {
  const Compass compass{0.01, 0.03, -0.02, 0.004, 0.006, 0.05, 0};
  NoiseStream noise(6, "rov/compass");
  constexpr int n = 360;
  double a = 0, b = 0, c = 0, d = 0, e = 0;
  for (int i = 0; i < n; ++i) {
    const double h = 2 * pi * i / n;
    const double shown = measured_heading_rad(compass, noise, h);
    EXPECT_GE(shown, 0);
    EXPECT_LT(shown, 2 * pi);
    const double off = wrapped_rad(shown - h);
    a += off / n;
    b += 2 * off * std::sin(h) / n;
    c += 2 * off * std::cos(h) / n;
    d += 2 * off * std::sin(2 * h) / n;
    e += 2 * off * std::cos(2 * h) / n;
  }
  EXPECT_NEAR(a, 0.06, 1e-12);
  EXPECT_NEAR(b, 0.03, 1e-12);
  EXPECT_NEAR(c, -0.02, 1e-12);
  EXPECT_NEAR(d, 0.004, 1e-12);
  EXPECT_NEAR(e, 0.006, 1e-12);
}

}  // namespace
}  // namespace slackwater::twin::navigation_sensors_test
