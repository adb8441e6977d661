#include "twin/sensor/read_sensors.h"

#include <string>

#include "fields/base/angle.h"
#include "fields/base/text.h"
#include "twin/sensor/read_adcp.h"

namespace slackwater::twin {
namespace {

void take(const Config& config, const char* key, Range range, double& value) {
  value = config.optional_number(key, range).value_or(value);
}
void take(const Config& config, const char* key, int low, int high, int& value) {
  value = config.optional_integer(key, low, high).value_or(value);
}
void take_degrees(const Config& config, const char* key, Range range_deg, double& value_rad) {
  if (const auto degrees = config.optional_number(key, range_deg))
    value_rad = Angle::from_degrees(*degrees).radians();
}

void expect_order(const Config& config, const char* key, const char* near_key, double near_m,
                  double far_m) {
  if (near_m < far_m) return;
  config.refuse(key, formatted("found {:g} m, not beyond {}, {:g} m; nothing would be heard", far_m,
                               near_key, near_m));
}

constexpr Range rates{0.01, 1000};  ///< Hz, of readings

Gnss read_gnss(const Config& c) {
  Gnss g;
  take(c, "white_horizontal_sd_m", {0, 100}, g.white_horizontal_sd_m);
  take(c, "white_vertical_sd_m", {0, 100}, g.white_vertical_sd_m);
  take(c, "slow_horizontal_sd_m", {0, 100}, g.slow_horizontal_m.sd);
  take(c, "slow_vertical_sd_m", {0, 100}, g.slow_vertical_m.sd);
  take(c, "correlation_time_s", {1, 86400}, g.slow_horizontal_m.correlation_time_s);
  g.slow_vertical_m.correlation_time_s = g.slow_horizontal_m.correlation_time_s;
  take(c, "velocity_sd_m_s", {0, 10}, g.velocity_sd_m_s);
  take(c, "reacquisition_s", {0, 3600}, g.reacquisition_s);
  take(c, "rate_hz", rates, g.rate_hz);
  take(c, "antenna_up_m", {-10, 100}, g.antenna_up_m);
  return g;
}

Imu read_imu(const Config& c) {
  Imu imu;
  take(c, "gyro_white_rad_s_rthz", {0, 0.1}, imu.gyro.white_density);
  take(c, "gyro_walk_rad_s_rts", {0, 0.01}, imu.gyro.walk_density);
  take(c, "gyro_start_bias_sd_rad_s", {0, 1}, imu.gyro.start_bias_sd);
  take(c, "gyro_range_rad_s", {0.1, 1000}, imu.gyro.range);
  take(c, "accelerometer_white_m_s2_rthz", {0, 1}, imu.accelerometer.white_density);
  take(c, "accelerometer_walk_m_s2_rts", {0, 0.1}, imu.accelerometer.walk_density);
  take(c, "accelerometer_start_bias_sd_m_s2", {0, 5}, imu.accelerometer.start_bias_sd);
  take(c, "accelerometer_range_m_s2", {10, 10000}, imu.accelerometer.range);
  return imu;
}

DepthSensor read_depth(const Config& c) {
  DepthSensor d;
  take(c, "scale", {0.9, 1.1}, d.scale);
  take(c, "offset_m", {-5, 5}, d.offset_m);
  take(c, "noise_sd_m", {0, 5}, d.noise_sd_m);
  take(c, "resolution_m", {0, 1}, d.resolution_m);
  take(c, "deepest_m", {1, 12000}, d.deepest_m);
  take(c, "rate_hz", rates, d.rate_hz);
  return d;
}

Compass read_compass(const Config& c) {
  Compass k;
  const Range small{-45, 45};
  take_degrees(c, "constant_deg", small, k.constant_rad);
  take_degrees(c, "sine_deg", small, k.sine_rad);
  take_degrees(c, "cosine_deg", small, k.cosine_rad);
  take_degrees(c, "double_sine_deg", small, k.double_sine_rad);
  take_degrees(c, "double_cosine_deg", small, k.double_cosine_rad);
  take_degrees(c, "declination_error_deg", small, k.declination_error_rad);
  take_degrees(c, "noise_sd_deg", {0, 45}, k.noise_sd_rad);
  take(c, "rate_hz", rates, k.rate_hz);
  // Beyond, some headings show alike: |d delta/dh| < 1 keeps them apart.
  if (std::hypot(k.sine_rad, k.cosine_rad) +
          2 * std::hypot(k.double_sine_rad, k.double_cosine_rad) >=
      1)
    c.refuse("sine_deg",
             "the deviation turns faster than the vehicle, so that two headings show "
             "alike; give a compass that has been compensated");
  return k;
}

Dvl read_dvl(const Config& c) {
  Dvl d;
  take_degrees(c, "slant_deg", {5, 60}, d.slant_rad);
  take_degrees(c, "azimuth_deg", {-180, 180}, d.azimuth_rad);
  take(c, "nearest_m", {0, 100}, d.nearest_m);
  take(c, "farthest_m", {0.1, 2000}, d.farthest_m);
  expect_order(c, "farthest_m", "nearest_m", d.nearest_m, d.farthest_m);
  take(c, "least_squareness", {0, 1}, d.least_squareness);
  if (d.least_squareness >= std::cos(d.slant_rad))
    c.refuse("least_squareness",
             "found more than the cosine of slant_deg; over a level bed no beam "
             "would be heard");
  take(c, "scale", {0.9, 1.1}, d.scale);
  take(c, "noise_sd_m_s", {0, 1}, d.noise_sd_m_s);
  take(c, "layer_near_m", {0, 100}, d.layer_near_m);
  take(c, "layer_far_m", {0.1, 200}, d.layer_far_m);
  expect_order(c, "layer_far_m", "layer_near_m", d.layer_near_m, d.layer_far_m);
  take(c, "rate_hz", rates, d.rate_hz);
  return d;
}

RangeSonar read_sonar(const Config& c) {
  RangeSonar s;
  take_degrees(c, "sector_deg", {0.1, 360}, s.sector_rad);
  take(c, "beams", 1, 4096, s.beams);
  take_degrees(c, "tilt_deg", {-90, 90}, s.tilt_rad);
  take(c, "nearest_m", {0, 100}, s.nearest_m);
  take(c, "farthest_m", {0.1, 2000}, s.farthest_m);
  expect_order(c, "farthest_m", "nearest_m", s.nearest_m, s.farthest_m);
  take(c, "least_squareness", {0, 1}, s.least_squareness);
  take(c, "noise_sd_m", {0, 10}, s.noise_sd_m);
  take(c, "resolution_m", {0, 10}, s.resolution_m);
  return s;
}

Camera read_camera(const Config& c) {
  Camera k;
  take(c, "pixels_wide", 16, 20000, k.pixels_wide);
  take(c, "pixels_high", 16, 20000, k.pixels_high);
  take_degrees(c, "horizontal_field_deg", {1, 170}, k.horizontal_field_rad);
  take_degrees(c, "tilt_deg", {-90, 90}, k.tilt_rad);
  take(c, "visibility_m", {0.01, 10000}, k.visibility_m);
  const std::vector<double> at = c.numbers("position_m", {-200, 200});
  if (!at.empty() && at.size() != 3)
    c.refuse("position_m", "found " + std::to_string(at.size()) +
                               " numbers; give [x, y, z] in metres, body axes");
  if (!at.empty()) k.position_m = {at[0], at[1], at[2]};
  return k;
}

template <typename Sensor>
std::optional<Sensor> read(const Config& sensors, const char* key, Sensor (*one)(const Config&)) {
  const std::optional<Config> config = sensors.optional_child(key);
  return config ? std::optional<Sensor>(one(*config)) : std::nullopt;
}

}  // namespace

Adcp read_adcp(const Config& c) {
  Adcp a;
  take_degrees(c, "slant_deg", {5, 45}, a.slant_rad);
  take_degrees(c, "azimuth_deg", {-180, 180}, a.azimuth_rad);
  a.looks_up = c.optional_flag("looks_up").value_or(a.looks_up);
  take(c, "bin_m", {0.02, 64}, a.bin_m);
  take(c, "blanking_m", {0, 100}, a.blanking_m);
  take(c, "bins", 1, 256, a.bins);
  take(c, "pings", 1, 100000, a.pings);
  take(c, "noise_sd_m_s", {0, 5}, a.noise_sd_m_s);
  take(c, "ambiguity_m_s", {0.05, 50}, a.ambiguity_m_s);
  return a;
}

Sensors read_sensors(const Config& vehicle) {
  const std::optional<Config> sensors = vehicle.optional_child("sensors");
  if (!sensors) return {};
  Sensors out;
  out.gnss = read(*sensors, "gnss", read_gnss);
  out.imu = read(*sensors, "imu", read_imu);
  out.depth = read(*sensors, "depth", read_depth);
  out.compass = read(*sensors, "compass", read_compass);
  out.dvl = read(*sensors, "dvl", read_dvl);
  out.adcp = read(*sensors, "adcp", read_adcp);
  out.sonar = read(*sensors, "sonar", read_sonar);
  out.camera = read(*sensors, "camera", read_camera);
  return out;
}

}  // namespace slackwater::twin
