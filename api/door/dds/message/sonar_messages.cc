#include "api/door/dds/message/sonar_messages.h"

#include <cmath>
#include <limits>

#include "api/door/dds/message/cdr.h"
#include "api/door/dds/message/float_messages.h"
#include "api/door/dds/message/map_frame.h"
#include "fields/base/check.h"
#include "marine_acoustic_msgs.h"
#include "twin/render/ranging/fan.h"

namespace slackwater::dds {
namespace {

using marine_acoustic_msgs::msg::PingInfo;
using marine_acoustic_msgs::msg::ProjectedSonarImage;

/// Of as many beams, all alike.
PingInfo ping_info(std::size_t beams, double along_rad, double across_rad) {
  PingInfo info;
  info.tx_beamwidths().assign(beams, static_cast<float>(along_rad));
  info.rx_beamwidths().assign(beams, static_cast<float>(across_rad));
  return info;
}

/// In a fan's plane, so far to starboard of forward.
geometry_msgs::msg::Vector3 in_fan(double bearing_rad) {
  return xyz_message<geometry_msgs::msg::Vector3>(
      {0, std::sin(bearing_rad), std::cos(bearing_rad)});
}

/// Ranges of the bins' middles, and the numbers beam by beam turned to rows of a range.
void add_bins(ProjectedSonarImage& message, std::span<const float> by_beam, double bin_m) {
  constexpr std::uint32_t float32 = 8;
  const std::size_t beams = message.beam_directions().size(), bins = by_beam.size() / beams;
  expects(by_beam.size() == beams * bins, "a ping has a number for each beam and bin");
  std::vector<float> by_range;
  by_range.reserve(by_beam.size());
  for (std::size_t bin = 0; bin < bins; ++bin) {
    message.ranges().push_back(static_cast<float>((static_cast<double>(bin) + 0.5) * bin_m));
    for (std::size_t beam = 0; beam < beams; ++beam) by_range.push_back(by_beam[beam * bins + bin]);
  }
  message.image().dtype(float32);
  message.image().beam_count(static_cast<std::uint32_t>(beams));
  message.image().data(float_bytes_of(by_range));
}

}  // namespace

Bytes sonar_image(const twin::SonarImage& image, const twin::ImagingSonarSheet& sheet,
                  double most_range_m, const SensorStamp& of) {
  ProjectedSonarImage message;
  message.header(header_message(of.stamp, of.frame_id));
  message.ping_info(
      ping_info(static_cast<std::size_t>(image.beams), sheet.upright_rad, sheet.beam_rad));
  message.ping_info().frequency(static_cast<float>(sheet.frequency_hz));
  for (int beam = 0; beam < image.beams; ++beam)
    message.beam_directions().push_back(
        in_fan(twin::beam_bearing_rad(sheet.across_rad, sheet.beams, beam)));
  add_bins(message, image.intensity, most_range_m / image.bins);
  return encoded(message);
}

Bytes side_scan_image(const twin::SideScanPing& ping, const twin::SideScanSheet& sheet,
                      const SensorStamp& of) {
  ProjectedSonarImage message;
  message.header(header_message(of.stamp, of.frame_id));
  message.ping_info(ping_info(2, sheet.beam_rad, sheet.upright_rad));
  for (const double side : {-1.0, 1.0})
    message.beam_directions().push_back(xyz_message<geometry_msgs::msg::Vector3>(
        {-std::sin(sheet.depression_rad), side * std::cos(sheet.depression_rad), 0}));
  add_bins(message, ping.intensity, ping.bin_m);
  return encoded(message);
}

Bytes sonar_ranges(const std::vector<twin::Sounding>& soundings, const twin::MultibeamSheet& sheet,
                   const SensorStamp& of) {
  constexpr std::uint8_t detect_ok = 0, detect_bad_sonar = 1;
  marine_acoustic_msgs::msg::SonarRanges message;
  message.header(header_message(of.stamp, of.frame_id));
  message.ping_info(ping_info(soundings.size(), sheet.beam_along_rad, sheet.beam_across_rad));
  for (const twin::Sounding& one : soundings) {
    marine_acoustic_msgs::msg::DetectionFlag flag;
    flag.flag(std::isnan(one.range_m) ? detect_bad_sonar : detect_ok);
    message.flags().push_back(flag);
    message.intensities().push_back(one.level);
    message.beam_unit_vec().push_back(in_fan(one.bearing_rad));
    message.ranges().push_back(one.range_m);
  }
  return encoded(message);
}

Bytes range_message(const twin::EchoSounding& sounding, const twin::EchoSounderSheet& sheet,
                    const RangeGate& gate, const SensorStamp& of) {
  constexpr std::uint8_t ultrasound = 0;
  const double r = sounding.range_m, sd_m = sheet.noise_sd_m + sheet.noise_per_range * r;
  const bool is_told = !std::isnan(r);
  sensor_msgs::msg::Range message;
  message.header(header_message(of.stamp, of.frame_id));
  message.radiation_type(ultrasound);
  message.field_of_view(static_cast<float>(sheet.beam_rad));
  message.min_range(static_cast<float>(gate.least_m));
  message.max_range(static_cast<float>(gate.most_m));
  message.range(is_told ? sounding.range_m : std::numeric_limits<float>::infinity());
  message.variance(is_told ? static_cast<float>(sd_m * sd_m) : 0);
  return encoded(message);
}

Bytes current_cloud(const twin::CurrentProfile& profile, const SensorStamp& of) {
  std::vector<float> numbers;
  for (const twin::ProfileBin& bin : profile.bins) {
    const twin::Triple<double> enu = enu_ned(bin.velocity_m_s);
    for (const double number : {bin.distance_m, 0.0, 0.0, enu.x, enu.y, enu.z})
      numbers.push_back(static_cast<float>(number));
  }
  return encoded(cloud_message({"x", "y", "z", "east", "north", "up"}, 1, numbers, of));
}

}  // namespace slackwater::dds
