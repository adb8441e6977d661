#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

#include "fields/base/config.h"
#include "twin/body/spatial.h"

namespace slackwater::twin {

enum class InstrumentKind {
  rgb,
  infrared,
  lidar,
  multibeam,
  side_scan,
  thickness,           ///< ultrasonic
  potential,           ///< cathodic protection, mV against Ag/AgCl in sea water
  magnetometer,        ///< burial of a cable
  acoustic_detection,  ///< passive, of animals
  optical_detection,   ///< by eye or camera, of animals and people
  radar,
  ais,
};
[[nodiscard]] const char* name_of(InstrumentKind kind) noexcept;
/// Whether what is between dims it as it dims light: cameras and LiDAR, not sound and probes.
[[nodiscard]] bool works_by_light(InstrumentKind kind) noexcept;

// Where an instrument measures at one moment, about its axis.

/// A picture: a pyramid about the axis.
struct FrameFootprint {
  double horizontal_rad = 0;  ///< whole angle, in the medium
  double vertical_rad = 0;
  int pixels_wide = 0;
  int pixels_high = 0;
  double exposure_s = 0;
};
/// A fan of beams across the track: plane upright on the vehicle's way.
struct FanFootprint {
  double across_rad = 0;  ///< whole angle
  double blind_rad = 0;   ///< whole angle about the axis in which nothing is measured (side-scan)
  double beam_across_rad = 0;  ///< of one beam
  double beam_along_rad = 0;
  double pings_per_s = 0;
};
/// A probe that touches, or nearly.
struct SpotFootprint {
  double spot_m = 0;        ///< diameter
  double dwell_s = 0;       ///< that a reading takes
  double speaks_for_m = 0;  ///< how far about the spot a reading stands for the surface
};
/// All round, as far as it reaches.
struct RoundFootprint {
  double detail_m = 0;  ///< what it makes out at its longest range
};
using InstrumentFootprint =
    std::variant<FrameFootprint, FanFootprint, SpotFootprint, RoundFootprint>;

/// Which way an instrument looks.
enum class Aim {
  fixed,    ///< on the hull, along `axis`
  surface,  ///< turned to the nearest place of the surface, kept upright: a gimbal, a pilot's hand
};

/// What measures, as data/instruments has it.
struct Instrument {
  std::string name;
  InstrumentKind kind{};
  InstrumentFootprint footprint;
  Aim aim = Aim::fixed;
  Triple<double> axis{1, 0, 0};  ///< unit, body axes; of a fixed one
  Triple<double> position_m;     ///< body axes
  double least_range_m = 0;
  double most_range_m = 0;
  /// To which its own lamp lights enough in water that takes nothing; 0: it has none or needs none.
  double lamp_range_m = 0;
  double lamp_aside_m = 0.2;  ///< how far beside the lens the lamp is
  bool needs_light = false;
  double noise_sd = 0;         ///< of what it measures, in its unit (m, V, ...)
  double noise_per_range = 0;  ///< more of it for each metre of range
  double bias_sd = 0;          ///< of a whole sortie
  std::string unit;
  std::string source;
  std::string status;
};

/// One file of data/instruments:
///
///     name: Camera of a small ROV
///     source: ...
///     status: estimate
///     kind: rgb
///     range_m: [0.3, 6]
///     frame: {horizontal_deg: 64, pixels_wide: 1920, pixels_high: 1080, exposure_s: 0.01}
///     aim: {axis: [1, 0, 0]}      # on the hull; or `aim: surface`: a gimbal
///     position_m: [0.2, 0, 0.1]   # optional, body axes
///     needs_light: true           # optional
///     lamp_range_m: 3             # optional: in water that takes nothing
///     lamp_aside_m: 0.2           # optional, beside lamp_range_m
///     noise: {sd: 0.002, per_range: 0.001, bias_sd: 0.001, unit: m}   # optional
///
/// The footprint is one of
///
///     frame: {horizontal_deg, vertical_deg (square pixels if absent), pixels_wide, pixels_high,
///             exposure_s}
///     fan:   {across_deg, blind_deg (0 if absent), beam_across_deg, beam_along_deg, pings_per_s}
///     spot:  {spot_m, dwell_s, speaks_for_m (half of spot_m if absent)}
///     round: {detail_m}
///
/// @throws Error(invalid_input) for none of them or two, ranges the wrong way round, angles that no
///         lens has, a kind that is not known, noise without its unit, a fan along the hull
[[nodiscard]] Instrument read_instrument(const Config& config);
/// The one of data/instruments of that name.
/// @throws Error(invalid_input) for a name that is none of those in the folder, and as above
[[nodiscard]] Instrument read_named_instrument(const std::string& name,
                                               const std::filesystem::path& data_folder);

}  // namespace slackwater::twin
