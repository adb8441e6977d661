#pragma once
#include <functional>
#include <optional>

#include "twin/scene/structure.h"
#include "twin/sensor/janus.h"
#include "twin/sensor/noise.h"

namespace slackwater::twin {

/// A Doppler velocity log: four Janus beams that listen to the bed (bottom track), or to a layer of
/// water (water track) when fewer than three of them hear it.
///
/// The speed of approach along a beam is that of the vehicle along it, plus an error of scale and
/// noise. A beam is lost nearer than `nearest_m`, beyond `farthest_m` along itself, and, more and
/// more, the more slantwise it meets the bed: below `least_squareness` nothing comes back.
///
/// Defaults: Water Linked DVL A50 (docs.waterlinked.com: four beams, 0.05-50 m altitude, 1 mm/s
/// long-term accuracy, water track 1.5-4.5 m); slant, scale, noise and least squareness are
/// estimates.
struct Dvl {
  double slant_rad = 0.5235987755982988;    ///< 30 degrees
  double azimuth_rad = 0.7853981633974483;  ///< 45 degrees: two beams look ahead
  double nearest_m = 0.05;
  double farthest_m = 57.7;  ///< along the beam
  double least_squareness = 0.5;
  double scale = 1.001;
  double noise_sd_m_s = 0.005;  ///< of one beam, one ping
  double layer_near_m = 1.5;    ///< below the instrument
  double layer_far_m = 4.5;
  double rate_hz = 5;  ///< of pings; the instrument of the defaults makes 2 to 15
};

/// Velocity of the water, NED, at a place.
using WaterAt = std::function<Triple<double>(const Triple<double>& at_m)>;

struct DvlReading {
  JanusVelocity track;  ///< against the bed, or against the water
  bool bottom = false;
  /// Against the layer of water, whether or not the bed is heard; nothing where too little of it
  /// lies below. One ping stands for the two that instruments send in turn.
  std::optional<JanusVelocity> water;
  std::optional<double> altitude_m;  ///< mean of the beams, along the instrument's axis
};

/// One ping. @param at_m, velocity_m_s NED
/// @return nothing where neither the bed nor enough water is heard
[[nodiscard]] std::optional<DvlReading> measured(const Dvl& dvl, NoiseStream& noise,
                                                 const Scene& scene, const WaterAt& water,
                                                 const Triple<double>& at_m,
                                                 const Rotation<double>& r,
                                                 const Triple<double>& velocity_m_s);

}  // namespace slackwater::twin
