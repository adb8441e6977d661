#pragma once
#include "api/door/dds/message/sensor_messages.h"
#include "twin/render/ranging/current_profile.h"
#include "twin/render/ranging/echo_sounder.h"
#include "twin/render/ranging/imaging_sonar.h"
#include "twin/render/ranging/multibeam.h"
#include "twin/render/ranging/side_scan.h"

namespace slackwater::dds {

// What sonars hear, as messages. Ranges are in metres: they need no speed of sound, which is told
// as unknown (0), as is a frequency that the sensor's file does not have. Beam widths are as
// PingInfo has them: tx along the track, rx across.

/// marine_acoustic_msgs/msg/ProjectedSonarImage: a row for each bin from the nearest, a column for
/// each beam from port. 32-bit intensities, of a source of 1 at 1 m; the speed of sound is not
/// needed for ranges in metres, and is told as unknown (0).
/// @param most_range_m  end of the last bin
[[nodiscard]] Bytes sonar_image(const twin::SonarImage& image, const twin::ImagingSonarSheet& sheet,
                                double most_range_m, const SensorStamp& of);

/// The same of a side-scan sonar: two columns, the middle of the fan to port and that to starboard.
[[nodiscard]] Bytes side_scan_image(const twin::SideScanPing& ping,
                                    const twin::SideScanSheet& sheet, const SensorStamp& of);

/// marine_acoustic_msgs/msg/SonarRanges, beam by beam from port: ranges as told, NaN and the flag
/// DETECT_BAD_SONAR where none was; intensities of a source of 1 at 1 m.
[[nodiscard]] Bytes sonar_ranges(const std::vector<twin::Sounding>& soundings,
                                 const twin::MultibeamSheet& sheet, const SensorStamp& of);

/// What an echo sounder hears between.
struct RangeGate {
  double least_m = 0;
  double most_m = 0;
};
/// sensor_msgs/msg/Range along x of a scanner's frame; +infinity where there was no bottom (REP
/// 117). Its variance is that of the noise, (noise_sd + noise_per_range r)^2, and 0, unknown, where
/// there is no range.
[[nodiscard]] Bytes range_message(const twin::EchoSounding& sounding,
                                  const twin::EchoSounderSheet& sheet, const RangeGate& gate,
                                  const SensorStamp& of);

/// sensor_msgs/msg/PointCloud2 of an ADCP's bins from the nearest: x, y, z of the bin on its axis
/// in a scanner's frame, metres, and east, north, up of the water over ground, m/s, as told; not a
/// number where the bin has none.
[[nodiscard]] Bytes current_cloud(const twin::CurrentProfile& profile, const SensorStamp& of);

}  // namespace slackwater::dds
