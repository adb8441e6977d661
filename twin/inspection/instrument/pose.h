#pragma once
#include "twin/inspection/instrument/bend.h"
#include "twin/inspection/instrument/look.h"

namespace slackwater::twin {

/// How a vehicle carries its instruments at a moment.
struct Carriage {
  Triple<double> position_m;    ///< of its origin, NED of the run
  Rotation<double> attitude;    ///< body to NED
  Triple<double> velocity_m_s;  ///< of its origin over ground, NED
  Triple<double> rates_rad_s;   ///< body axes
};

/// What an instrument is turned to.
struct AimedAt {
  Triple<double> place_m;  ///< NED of the run: the nearest place of the surface
  Bend bend;               ///< of the surface there
};

/// Where an instrument is, which way it looks, and how it turns.
///
/// Fixed: along its axis on the hull; `right` keeps the picture upright on the hull (down is the
/// hull's down; of one that looks straight down the hull's bow is up), and lays a fan across the
/// hull. It turns as the hull does.
///
/// Turned to the surface: at `target`; `right` is level, and lays a fan across the way over ground,
/// or level where there is no way. What holds it takes the hull's turning out, and turns it as its
/// aim goes. At v past a surface that bends by k1, k2 along e1, e2, with d the way off it, its
/// nearest place goes over it by u, and it turns by w:
///
///     u = sum (v . e) / (1 + d k) e,   w = sum k (v . e) / (1 + d k) n x e
///
/// so not at all past a wall, by v/(R + d) round a pile, and by v/d past a thin line, which it
/// tracks. To keep a picture level its turn about its own axis a is w . down a_z/down_z, but not
/// within 3 degrees of straight down or up. A surface that bends inward so that 1 + d k is near 0
/// or below has no one nearest place: it is taken for flat.
///
/// @param target  of no matter for a fixed one
[[nodiscard]] Pose pose_of(const Instrument& instrument, const Carriage& carriage,
                           const AimedAt& target) noexcept;

/// How far it moves from one look to the next over a surface at a range: half of its footprint,
/// across the narrower side. Of a fan, which is swept between looks, half of its swath, and no more
/// than half of the range; of a spot its radius; of what sees all round, a tenth of how far it
/// reaches.
[[nodiscard]] double step_between_looks_m(const Instrument& instrument, double range_m) noexcept;

}  // namespace slackwater::twin
