#include <cmath>
#include <string_view>

#include "fields/base/advice.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/curve/named_file.h"
#include "twin/render/sheet/read_ranging_sheet.h"
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

Specks read_specks(const Config& c, const CameraSheet& camera, const char* what) {
  Specks specks;
  specks.per_m3 = c.number("per_m3", {0, 1e5});
  specks.diameter_m = 1e-3 * c.number("diameter_mm", {0.05, 50});
  specks.nearest_m = c.number("nearest_m", {0.01, 10});
  specks.reach_m = c.number("reach_m", {0.02, 20});
  if (!(specks.nearest_m < specks.reach_m))
    c.refuse("reach_m", formatted("expected more than nearest_m; no {} would be seen", what));
  constexpr double most = 1e6;
  const Pinhole camera_at({{}, {1, 0, 0}, {0, 1, 0}, {}, {}}, camera.frame);
  const double mean =
      specks.per_m3 * volume_in_view_m3(camera_at, specks.nearest_m, specks.reach_m);
  if (mean > most)
    c.refuse("per_m3", formatted("makes {:.0f} {} a picture, expected {:.0f} at most; take fewer, "
                                 "or a shorter reach_m",
                                 mean, what, most));
  return specks;
}

void read_effects(const Config& c, CameraSheet& camera) {
  if (const auto shutter = c.optional_child("shutter"))
    camera.shutter = {camera.frame.exposure_s, shutter->number("line_time_s", {0, 0.01})};
  if (const auto scatter = c.optional_child("forward_scatter"))
    camera.forward_scatter = {scatter->number("per_length", {0, 10}),
                              constants::degree * scatter->number("spread_deg", {0, 10})};
  if (const auto snow = c.optional_child("marine_snow"))
    camera.marine_snow = {read_specks(*snow, camera, "flakes"),
                          snow->number("reflectance", {0, 1})};
  if (const auto spray = c.optional_child("spray"))
    camera.spray = read_specks(*spray, camera, "drops");
}

CameraSheet read_camera(const Config& c) {
  CameraSheet camera;
  camera.frame = read_lens(c.child("frame"));
  if (const auto sensor = c.optional_child("sensor")) {
    camera.sensor.full_well_e = sensor->number("full_well_e", {100, 1e7});
    camera.sensor.read_noise_e = sensor->number("read_noise_e", {0, 1000});
    camera.sensor.most_gain = sensor->optional_number("most_gain", {1, 1000}).value_or(16);
  }
  if (const auto pair = c.optional_child("stereo"))
    camera.baseline_m = pair->number("baseline_m", {0.001, 20});
  read_effects(c, camera);
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

InfraredSheet read_infrared(const Config& c) {
  InfraredSheet infrared;
  infrared.frame = read_lens(c.child("frame"));
  const Config of = c.child("infrared");
  const auto band_um = of.numbers("band_um", {1, 100});
  if (band_um.size() != 2 || !(band_um[0] < band_um[1]))
    of.refuse("band_um", "expected two wavelengths in micrometres, the shorter first");
  infrared.sensor.from_m = 1e-6 * band_um[0];
  infrared.sensor.to_m = 1e-6 * band_um[1];
  infrared.sensor.netd_k = of.number("netd_k", {0, 10});
  return infrared;
}

/// What a kind needs to be, and how its part of the file is read.
struct KindOfSensor {
  const char* name;
  std::optional<SensorMedium> needs;  ///< absent: works in any
  RenderDevice (*read)(const Config& sensor);
};

const std::vector<KindOfSensor>& kinds_of_sensors() {
  static const std::vector<KindOfSensor> kinds{
      {"camera", std::nullopt, [](const Config& c) -> RenderDevice { return read_camera(c); }},
      {"infrared", SensorMedium::air,
       [](const Config& c) -> RenderDevice { return read_infrared(c); }},
      {"lidar", SensorMedium::air,
       [](const Config& c) -> RenderDevice { return read_lidar_sheet(c.child("lidar")); }},
      {"imaging_sonar", SensorMedium::water,
       [](const Config& c) -> RenderDevice { return read_imaging_sonar_sheet(c.child("sonar")); }},
      {"side_scan", SensorMedium::water,
       [](const Config& c) -> RenderDevice { return read_side_scan_sheet(c.child("side_scan")); }},
      {"multibeam", SensorMedium::water,
       [](const Config& c) -> RenderDevice { return read_multibeam_sheet(c.child("multibeam")); }},
      {"echo_sounder", SensorMedium::water,
       [](const Config& c) -> RenderDevice {
         return read_echo_sounder_sheet(c.child("echo_sounder"));
       }},
      {"adcp", SensorMedium::water,
       [](const Config& c) -> RenderDevice { return read_profiler_sheet(c); }},
  };
  return kinds;
}

const KindOfSensor& read_kind(const Config& c, SensorMedium medium) {
  const std::string kind = c.text("kind");
  std::vector<std::string> known;
  for (const KindOfSensor& one : kinds_of_sensors()) {
    known.emplace_back(one.name);
    if (kind != one.name) continue;
    if (one.needs && *one.needs != medium)
      c.refuse("medium", formatted("found {}; a sensor of the kind {} works in {} alone",
                                   name_of(medium), kind, name_of(*one.needs)));
    return one;
  }
  c.refuse("kind",
           "found " + kind + did_you_mean(kind, known) + ", expected " + joined(known, ", "));
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
  sensor.device = read_kind(c, sensor.medium).read(c);
  c.expect_all_read();
  return sensor;
}

RenderSensor read_named_render_sensor(const std::string& name,
                                      const std::filesystem::path& data_folder) {
  return read_render_sensor(open_named(name, "sensor", data_folder / "sensors"));
}

}  // namespace slackwater::twin
