#include "twin/render/sheet/read_ranging_sheet.h"

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/sensor/read_adcp.h"

namespace slackwater::twin {
namespace {

double radians_of(const Config& c, const char* key, Range degrees) {
  return constants::degree * c.number(key, degrees);
}

/// Keys that all sonars have, by the same names.
template <typename Sheet>
void read_water(const Config& c, Sheet& sheet) {
  sheet.absorption_db_m = c.number("absorption_db_m", {0, 5});
  sheet.mackenzie_db = c.optional_number("mackenzie_db", {-80, 10}).value_or(sheet.mackenzie_db);
  sheet.noise_floor = c.optional_number("noise_floor", {0, 1}).value_or(sheet.noise_floor);
}

/// Keys of those that tell a range.
template <typename Sheet>
void read_telling(const Config& c, Sheet& sheet) {
  sheet.noise_sd_m = c.number("noise_sd_m", {0, 10});
  sheet.noise_per_range = c.number("noise_per_range", {0, 1});
  sheet.step_m = c.optional_number("step_m", {0, 1}).value_or(sheet.step_m);
  sheet.detected_db = c.optional_number("detected_db", {0, 100}).value_or(sheet.detected_db);
}

}  // namespace

LidarSheet read_lidar_sheet(const Config& c) {
  LidarSheet lidar;
  lidar.channels = c.integer("channels", 1, 1024);
  lidar.columns = c.integer("columns", 1, 16384);
  lidar.lowest_rad = radians_of(c, "lowest_deg", {-90, 90});
  lidar.highest_rad = radians_of(c, "highest_deg", {-90, 90});
  if (!(lidar.highest_rad >= lidar.lowest_rad))
    c.refuse("highest_deg", "is below lowest_deg; elevations are counted upwards");
  lidar.noise_sd_m = c.number("noise_sd_m", {0, 10});
  lidar.step_m = c.optional_number("step_m", {1e-6, 1}).value_or(0.001);
  lidar.headroom = c.optional_number("headroom", {1, 1e6}).value_or(5);
  lidar.dropout = c.number("dropout", {0, 1});
  lidar.drops_per_m = c.optional_number("drops_per_m", {0, 10}).value_or(lidar.drops_per_m);
  lidar.drops_told = c.optional_number("drops_told", {0, 1}).value_or(lidar.drops_told);
  return lidar;
}

ImagingSonarSheet read_imaging_sonar_sheet(const Config& c) {
  ImagingSonarSheet sonar;
  sonar.beams = c.integer("beams", 2, 4096);
  sonar.across_rad = radians_of(c, "across_deg", {1, 180});
  sonar.beam_rad = radians_of(c, "beam_deg", {0.01, 45});
  sonar.upright_rad = radians_of(c, "upright_deg", {0.1, 60});
  sonar.rays = c.optional_integer("rays", 8, 4096).value_or(sonar.rays);
  sonar.bins = c.integer("bins", 8, 8192);
  sonar.frequency_hz = 1e3 * c.number("frequency_khz", {10, 5000});
  read_water(c, sonar);
  return sonar;
}

SideScanSheet read_side_scan_sheet(const Config& c) {
  SideScanSheet scan;
  scan.beam_rad = radians_of(c, "beam_deg", {0.01, 20});
  scan.upright_rad = radians_of(c, "upright_deg", {1, 90});
  scan.depression_rad = radians_of(c, "depression_deg", {0, 90});
  scan.rays = c.optional_integer("rays", 64, 65536).value_or(scan.rays);
  scan.slices = c.optional_integer("slices", 1, 64).value_or(scan.slices);
  scan.bins = c.integer("bins", 8, 8192);
  read_water(c, scan);
  return scan;
}

MultibeamSheet read_multibeam_sheet(const Config& c) {
  MultibeamSheet fan;
  fan.beams = c.integer("beams", 2, 4096);
  fan.across_rad = radians_of(c, "across_deg", {1, 178});
  fan.beam_across_rad = radians_of(c, "beam_across_deg", {0.01, 45});
  fan.beam_along_rad = radians_of(c, "beam_along_deg", {0.01, 45});
  fan.bearing_sd_rad = constants::degree * c.optional_number("bearing_sd_deg", {0, 5}).value_or(0);
  read_telling(c, fan);
  read_water(c, fan);
  return fan;
}

EchoSounderSheet read_echo_sounder_sheet(const Config& c) {
  EchoSounderSheet sounder;
  sounder.beam_rad = radians_of(c, "beam_deg", {0.1, 90});
  sounder.rings = c.optional_integer("rings", 4, 4096).value_or(sounder.rings);
  sounder.round = c.optional_integer("round", 4, 4096).value_or(sounder.round);
  sounder.bins = c.integer("bins", 8, 8192);
  read_telling(c, sounder);
  read_water(c, sounder);
  return sounder;
}

Adcp read_profiler_sheet(const Config& sensor) {
  const Config c = sensor.child("adcp");
  if (c.has("looks_up"))
    c.refuse("looks_up", "which way it looks is said by `axis`: [0, 0, 1] is down, [0, 0, -1] up");
  const Adcp adcp = read_adcp(c);
  // The bins have a triangle each, as wide as two of them; along a beam they are farther off.
  const double needed_m =
      (adcp.blanking_m + (adcp.bins + 1) * adcp.bin_m) / std::cos(adcp.slant_rad);
  const auto range = sensor.numbers("range_m", {0, 1e5});
  if (!range.empty() && range.back() < needed_m)
    sensor.refuse("range_m", formatted("found up to {:g} m, expected {:.1f} m or more: along a "
                                       "slanted beam {} bins of {:g} m reach as far; take fewer",
                                       range.back(), needed_m, adcp.bins, adcp.bin_m));
  return adcp;
}

}  // namespace slackwater::twin
