#pragma once
#include <string>
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
  double spot_m = 0;   ///< diameter
  double dwell_s = 0;  ///< that a reading takes
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
  double lamp_range_m = 0;  ///< to which its own lamp lights enough; 0: it has none or needs none
  bool needs_light = false;
  double noise_sd = 0;         ///< of what it measures, in its unit (m, V, ...)
  double noise_per_range = 0;  ///< more of it for each metre of range
  double bias_sd = 0;          ///< of a whole sortie
  std::string unit;
  std::string source;
  std::string status;
};

/// One file of data/instruments.
/// @throws Error(invalid_input) for one without a footprint, ...
[[nodiscard]] Instrument read_instrument(const Config& config);

}  // namespace slackwater::twin
