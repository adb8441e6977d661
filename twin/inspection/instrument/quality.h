#pragma once
#include <optional>

#include "twin/inspection/instrument/look.h"

namespace slackwater::twin {

/// How well an instrument at a pose measures a place of a surface, whether or not its footprint
/// holds it and anything stands between (view.h asks that). With q the way from the instrument to
/// the place, r = |q|, n the normal, and P s = s - q (n . s)/(n . q) what moves the place on the
/// surface when the instrument's frame moves by s there:
///
/// - frame: f = w / (2 tan(h/2)) pixels, z the depth along the axis; a pixel is |P right| z/f wide
///   and |P down| z/f high on the surface, and the longer side counts. It smears over exposure
///   |P (v + w x q)|: what moves along the line of sight does not.
/// - fan: r times a beam's angle, across and along, laid on the surface in the same way; or the way
///   from ping to ping, whichever is longest. No smear within a ping.
/// - spot: its diameter. What moves while it dwells is the caller's.
/// - round: the detail at its longest range, in proportion to the range. The water is seen however
///   flatly, and heard from below.
///
/// Contrast and light are those of seen_light.h, 1 for sound and probes.
///
/// @param centre_m  NED of the run
/// @param normal    unit, outward
/// @return nothing out of range, from behind or edge-on, where it is dark, and where the contrast
///         is one at which a black disc is lost from sight
[[nodiscard]] std::optional<LookQuality> quality_of(const Instrument& instrument, const Pose& pose,
                                                    const Clarity& clarity,
                                                    const Triple<double>& centre_m,
                                                    const Triple<double>& normal) noexcept;

}  // namespace slackwater::twin
