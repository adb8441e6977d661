#pragma once
#include "twin/inspection/instrument/look.h"

namespace slackwater::twin {

/// How a vehicle carries its instruments at a moment.
struct Carriage {
  Triple<double> position_m;    ///< of its origin, NED of the run
  Rotation<double> attitude;    ///< body to NED
  Triple<double> velocity_m_s;  ///< of its origin over ground, NED
  Triple<double> rates_rad_s;   ///< body axes
};

/// Where an instrument is, and which way it looks.
///
/// Fixed: along its axis on the hull; `right` keeps the picture upright on the hull (down is the
/// hull's down; of one that looks straight down the hull's bow is up), and lays a fan across the
/// hull. It turns as the hull does.
///
/// Turned to the surface: at `target_m`; `right` is level, and lays a fan across the way over
/// ground, or level where there is no way. It does not turn: what holds it takes the hull's turning
/// out.
///
/// @param target_m  NED of the run: the nearest place of the surface; of no matter for a fixed one
[[nodiscard]] Pose pose_of(const Instrument& instrument, const Carriage& carriage,
                           const Triple<double>& target_m) noexcept;

/// How far it moves from one look to the next over a surface at a range: half of its footprint,
/// across the narrower side. Of a fan, which is swept between looks, half of its swath, and no more
/// than half of the range; of a spot its radius; of what sees all round, a tenth of how far it
/// reaches.
[[nodiscard]] double step_between_looks_m(const Instrument& instrument, double range_m) noexcept;

}  // namespace slackwater::twin
