#include <cmath>
#include <string_view>

#include "fields/base/advice.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/curve/named_file.h"
#include "twin/render/sheet/render_sensor.h"

namespace slackwater::twin {
namespace {

constexpr double most_pixels = 64e6;

Triple<double> read_triple(const Config& c, std::string_view key, Range range) {
  const auto n = c.numbers(key, range);
  if (n.size() != 3)
    c.refuse(key,
             formatted("found {} numbers, expected three: forward, to the right, down", n.size()));
  return {n[0], n[1], n[2]};
}

Triple<double> read_axis(const Config& c, const Triple<double>& otherwise) {
  if (!c.has("axis")) return otherwise;
  const Triple<double> axis = read_triple(c, "axis", {-1, 1});
  const double length = length_of(axis);
  if (!(length > 0)) c.refuse("axis", "points nowhere; [1, 0, 0] is ahead, [0, 0, 1] down");
  return (1 / length) * axis;
}

SensorMedium read_medium(const Config& c) {
  const std::string word = c.text("medium");
  const std::vector<std::string> known{"water", "air", "both"};
  for (const SensorMedium medium : {SensorMedium::water, SensorMedium::air, SensorMedium::both})
    if (word == name_of(medium)) return medium;
  c.refuse("medium", "found " + word + did_you_mean(word, known) + ", expected water, air or both");
}

FrameFootprint read_lens(const Config& c) {
  FrameFootprint frame;
  frame.horizontal_rad = constants::degree * c.number("horizontal_deg", {0.1, 170});
  frame.pixels_wide = c.integer("pixels_wide", 2, 16384);
  frame.pixels_high = c.integer("pixels_high", 2, 16384);
  frame.exposure_s = c.number("exposure_s", {0, 60});
  if (static_cast<double>(frame.pixels_wide) * frame.pixels_high > most_pixels)
    c.refuse("pixels_wide", formatted("found a picture of {} x {} pixels, expected 64 million at "
                                      "most",
                                      frame.pixels_wide, frame.pixels_high));
  const double square =
      2 * std::atan(std::tan(frame.horizontal_rad / 2) * frame.pixels_high / frame.pixels_wide);
  if (const auto vertical_deg = c.optional_number("vertical_deg", {0.1, 170}))
    frame.vertical_rad = constants::degree * *vertical_deg;
  else
    frame.vertical_rad = square;
  constexpr double widest_deg = 170, most_oblong = 4;
  if (frame.vertical_rad > constants::degree * widest_deg)
    c.refuse("horizontal_deg",
             formatted("makes a picture of square pixels {:.0f} degrees high, which no pinhole "
                       "sees (at most {:g}); take a narrower one, or fewer pixels upright",
                       frame.vertical_rad / constants::degree, widest_deg));
  const double oblong = std::tan(frame.vertical_rad / 2) / std::tan(square / 2);
  if (oblong > most_oblong || oblong < 1 / most_oblong)
    c.refuse(
        "vertical_deg",
        formatted("makes pixels {:.1f} times as high as wide; expected up to {:g} times: leave "
                  "it out for square ones",
                  oblong, most_oblong));
  return frame;
}

CameraSheet read_camera(const Config& c) {
  CameraSheet camera;
  camera.frame = read_lens(c.child("frame"));
  if (const auto sensor = c.optional_child("sensor")) {
    camera.sensor.full_well_e = sensor->number("full_well_e", {100, 1e7});
    camera.sensor.read_noise_e = sensor->number("read_noise_e", {0, 1000});
    camera.sensor.most_gain = sensor->optional_number("most_gain", {1, 1000}).value_or(16);
  }
  for (const Config& one : c.children("lamps")) {
    MountedLamp lamp;
    lamp.position_m = read_triple(one, "position_m", {-50, 50});
    lamp.axis = read_axis(one, {1, 0, 0});
    lamp.range_m = one.number("range_m", {0.01, 200});
    lamp.half_beam_rad = 0.5 * constants::degree * one.number("beam_deg", {1, 180});
    camera.lamps.push_back(lamp);
  }
  return camera;
}

LidarSheet read_lidar(const Config& c) {
  LidarSheet lidar;
  lidar.channels = c.integer("channels", 1, 1024);
  lidar.columns = c.integer("columns", 1, 16384);
  lidar.lowest_rad = constants::degree * c.number("lowest_deg", {-90, 90});
  lidar.highest_rad = constants::degree * c.number("highest_deg", {-90, 90});
  if (!(lidar.highest_rad >= lidar.lowest_rad))
    c.refuse("highest_deg", "is below lowest_deg; elevations are counted upwards");
  lidar.noise_sd_m = c.number("noise_sd_m", {0, 10});
  lidar.step_m = c.optional_number("step_m", {1e-6, 1}).value_or(0.001);
  lidar.headroom = c.optional_number("headroom", {1, 1e6}).value_or(5);
  lidar.dropout = c.number("dropout", {0, 1});
  return lidar;
}

ImagingSonarSheet read_sonar(const Config& c) {
  ImagingSonarSheet sonar;
  sonar.beams = c.integer("beams", 2, 4096);
  sonar.across_rad = constants::degree * c.number("across_deg", {1, 180});
  sonar.beam_rad = constants::degree * c.number("beam_deg", {0.01, 45});
  sonar.upright_rad = constants::degree * c.number("upright_deg", {0.1, 60});
  sonar.rays = c.optional_integer("rays", 8, 4096).value_or(256);
  sonar.bins = c.integer("bins", 8, 8192);
  sonar.frequency_hz = 1e3 * c.number("frequency_khz", {10, 5000});
  sonar.absorption_db_m = c.number("absorption_db_m", {0, 5});
  sonar.mackenzie_db = c.optional_number("mackenzie_db", {-80, 10}).value_or(-27);
  sonar.noise_floor = c.optional_number("noise_floor", {0, 1}).value_or(1e-9);
  return sonar;
}

}  // namespace

RenderSensor read_render_sensor(const Config& c) {
  RenderSensor sensor;
  sensor.name = c.text("name");
  sensor.source = c.text("source");
  sensor.status = c.text("status");
  sensor.medium = read_medium(c);
  if (c.has("position_m")) sensor.position_m = read_triple(c, "position_m", {-200, 200});
  sensor.axis = read_axis(c, {1, 0, 0});
  if (const auto aim = c.optional_text("aim")) {
    if (*aim != "surface") c.refuse("aim", "found " + *aim + ", expected surface, or no such key");
    sensor.is_aimed = true;
  }
  const auto range = c.numbers("range_m", {0, 1e5});
  if (range.size() != 2 || !(range[0] < range[1]))
    c.refuse("range_m", "expected two numbers, the lesser first: from where and how far it sees");
  sensor.least_range_m = range[0];
  sensor.most_range_m = range[1];
  const std::string kind = c.text("kind");
  if (kind == "camera") {
    sensor.device = read_camera(c);
  } else if (kind == "lidar") {
    sensor.device = read_lidar(c.child("lidar"));
    if (sensor.medium != SensorMedium::air)
      c.refuse("medium", "found " + std::string(name_of(sensor.medium)) +
                             "; a lidar of this kind works in air alone");
  } else if (kind == "imaging_sonar") {
    sensor.device = read_sonar(c.child("sonar"));
    if (sensor.medium != SensorMedium::water)
      c.refuse("medium",
               "found " + std::string(name_of(sensor.medium)) + "; a sonar works in water alone");
  } else {
    c.refuse("kind", "found " + kind + did_you_mean(kind, {"camera", "lidar", "imaging_sonar"}) +
                         ", expected camera, lidar or imaging_sonar");
  }
  c.expect_all_read();
  return sensor;
}

RenderSensor read_named_render_sensor(const std::string& name,
                                      const std::filesystem::path& data_folder) {
  return read_render_sensor(open_named(name, "sensor", data_folder / "sensors"));
}

}  // namespace slackwater::twin
