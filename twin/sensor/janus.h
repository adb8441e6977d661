#pragma once
#include <array>
#include <optional>

#include "twin/body/spatial.h"

namespace slackwater::twin {

/// Four beams in two planes across each other, slanted from the axis of the instrument by the same
/// angle, body axes. Beam 0 looks `azimuth` to the right of forward, 1 opposite, 2 a quarter turn
/// further right than 0, 3 opposite.
using JanusBeams = std::array<Triple<double>, 4>;
[[nodiscard]] JanusBeams janus_beams(double slant_rad, double azimuth_rad, bool looks_up) noexcept;

/// Speeds of approach along beams, m/s; nothing where a beam gave none.
using BeamSpeeds = std::array<std::optional<double>, 4>;

/// What an instrument makes of its beams.
struct JanusVelocity {
  Triple<double> velocity_m_s;  ///< of the instrument against what scattered the sound, body axes
  double error_m_s =
      0;          ///< by which the two planes disagree about the speed along the axis, halved
  int beams = 0;  ///< 4, or 3 with one left out and no measure of error
};

/// Least squares over the beams that are there; nothing with fewer than three. Exact for what moves
/// alike in all beams.
[[nodiscard]] std::optional<JanusVelocity> janus_velocity(const JanusBeams& beams,
                                                          const BeamSpeeds& speeds) noexcept;

}  // namespace slackwater::twin
