#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "fields/base/config.h"
#include "twin/inspection/instrument/instrument.h"
#include "twin/inspection/instrument/pose.h"
#include "twin/render/lens/forward_scatter.h"
#include "twin/render/lens/marine_snow.h"
#include "twin/render/lens/picture.h"
#include "twin/render/lens/shutter.h"
#include "twin/render/lens/specks.h"
#include "twin/render/light/infrared_frame.h"
#include "twin/render/light/lit_scene.h"
#include "twin/render/ranging/current_profile.h"
#include "twin/render/ranging/echo_sounder.h"
#include "twin/render/ranging/imaging_sonar.h"
#include "twin/render/ranging/lidar.h"
#include "twin/render/ranging/multibeam.h"
#include "twin/render/ranging/side_scan.h"

namespace slackwater::twin {

/// What a sensor can work in.
enum class SensorMedium { water, air, both };
[[nodiscard]] const char* name_of(SensorMedium medium) noexcept;

/// A lamp on the hull, body axes.
struct MountedLamp {
  Triple<double> position_m;
  Triple<double> axis{1, 0, 0};  ///< unit
  double range_m = 0;            ///< to which it lights enough in clear water (seen_light.h)
  double half_beam_rad = 0;
};

struct CameraSheet {
  FrameFootprint frame;
  ImageSensor sensor;
  std::vector<MountedLamp> lamps;
  /// Of a pair: how far to the right of it the second camera is, which is like it. 0: it is alone.
  double baseline_m = 0;
  // What a picture costs more for; absent: left out. The truth knows nothing of it.
  std::optional<Shutter> shutter;  ///< of a camera that moves while it sees
  std::optional<ForwardScatter> forward_scatter;
  std::optional<MarineSnow> marine_snow;
  std::optional<Specks> spray;
};

/// A camera of heat.
struct InfraredSheet {
  FrameFootprint frame;
  InfraredSensor sensor;
};

using RenderDevice = std::variant<CameraSheet, InfraredSheet, LidarSheet, ImagingSonarSheet,
                                  SideScanSheet, MultibeamSheet, EchoSounderSheet, Adcp>;

/// What sees, as data/sensors has it: on the hull, along an axis.
struct RenderSensor {
  std::string name;
  std::string source;
  std::string status;
  SensorMedium medium = SensorMedium::both;
  Triple<double> position_m;     ///< body axes
  Triple<double> axis{1, 0, 0};  ///< unit, body axes
  /// Turned to what is inspected, or the nearest structure, and kept level: a gimbal, a pilot's
  /// hand. Along its axis where neither is within its reach.
  bool is_aimed = false;
  double least_range_m = 0;
  double most_range_m = 0;
  RenderDevice device;

  [[nodiscard]] bool is_camera() const noexcept {
    return std::holds_alternative<CameraSheet>(device);
  }
};

/// One file of data/sensors:
///
///     name: Camera of a small ROV
///     source: ...
///     status: estimate
///     kind: camera                 # or infrared, lidar, imaging_sonar, side_scan, multibeam,
///                                  # echo_sounder, adcp
///     medium: water                # or air, both: outside of it, it sees nothing
///     position_m: [0.2, 0, 0]      # body axes: forward, right, down
///     axis: [1, 0, 0]
///     aim: surface                 # optional: turned to what is inspected
///     range_m: [0.05, 12]
///     frame: {horizontal_deg, vertical_deg (square pixels if absent), pixels_wide, pixels_high,
///             exposure_s}                                            # of a camera, of infrared
///     sensor: {full_well_e, read_noise_e, most_gain}                             # of a camera
///     infrared: {band_um: [8, 14], netd_k: 0.05}                     # of an infrared camera
///     stereo: {baseline_m}         # of a pair of cameras: what is said is of the left one
///     shutter: {line_time_s}                  # optional: what moves smears, row after row
///     forward_scatter: {per_length, spread_deg}                   # optional: water that blurs
///     marine_snow: {per_m3, diameter_mm, reflectance, nearest_m, reach_m}  # optional, in water
///     spray: {per_m3, diameter_mm, nearest_m, reach_m}                     # optional, in air
///     lamps: [{position_m, axis, range_m, beam_deg (whole)}, ...]                # of a camera
///     lidar: {channels, lowest_deg, highest_deg, columns, noise_sd_m, dropout, ...}   # lidar.h
///     sonar: {beams, across_deg, beam_deg, upright_deg, rays, bins, ...}    # imaging_sonar.h
///     side_scan: {beam_deg, upright_deg, depression_deg, bins, ...}         # side_scan.h
///     multibeam: {beams, across_deg, beam_across_deg, beam_along_deg, ...}  # multibeam.h
///     echo_sounder: {beam_deg, bins, noise_sd_m, ...}                       # echo_sounder.h
///     adcp: {slant_deg, bins, bin_m, blanking_m, noise_sd_m_s, ...}         # current_profile.h
///
/// @throws Error(invalid_input) for a lens or a fan that cannot be, a kind that is not known, keys
///         that its kind does not have
[[nodiscard]] RenderSensor read_render_sensor(const Config& config);
/// The one of data/sensors of that name.
/// @throws Error(invalid_input) for a name that is none of those in the folder, and as above
[[nodiscard]] RenderSensor read_named_render_sensor(const std::string& name,
                                                    const std::filesystem::path& data_folder);

/// Where it is and which way it looks on a vehicle: upright on the hull, of one that looks straight
/// down with the bow up.
[[nodiscard]] Pose pose_of(const RenderSensor& sensor, const Carriage& carriage) noexcept;
/// The same of one that is turned to a place: as the inspection turns its instruments (pose.h).
[[nodiscard]] Pose pose_of(const RenderSensor& sensor, const Carriage& carriage,
                           const Triple<double>& place_m) noexcept;
/// A hull that has the sensor at its pose, body axes along the picture's: what turns lamps with a
/// camera that is turned.
[[nodiscard]] Carriage hull_that_has(const RenderSensor& sensor, const Pose& pose) noexcept;
/// A lamp of the vehicle, where it is then.
[[nodiscard]] Lamp lamp_of(const MountedLamp& lamp, const Carriage& carriage) noexcept;

/// @param is_under_water  where it is
/// @throws Error(invalid_input) for a sensor outside its medium, with what to do
void expect_in_medium(const RenderSensor& sensor, bool is_under_water, const std::string& where);

}  // namespace slackwater::twin
