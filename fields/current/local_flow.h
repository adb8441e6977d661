#pragma once
#include <optional>

#include "fields/base/frame.h"

namespace slackwater {

/// A circular foundation that stands in the current.
struct Pile {
  double diameter_m = 0;  ///< > 0; 0 stands for no pile
  /// Cd of a section, > 0 and at most 2: DNV-RP-C205, ch. 6, gives 0.65 for a smooth and 1.05 for a
  /// rough pile beyond the drag crisis, where monopiles with their growth are.
  double drag_coefficient = 1.05;
  bool operator==(const Pile&) const = default;
};

/// The horizontal current that a vehicle feels near a pile, instead of the free stream U:
///
///   velocity = U + (potential flow around a circle) + (wake behind it)
///
/// Potential flow, with xi = position from the axis turned so that U points along the real axis and
/// R = d/2:  u - iv = |U| (1 - R^2/xi^2).  It is 2U at the sides, 0 at the front, and passes no
/// water through the wall.
///
/// Wake, x down the stream from the axis and y across (Schlichting's far wake of a cylinder with
/// Gaussian section, as Huse 1993 has it for risers: half-width 0.25 sqrt(Cd d x)):
///
///   -a |U| exp(-y^2/(2 s^2)),  s^2 = s0^2 + 0.0451 Cd d x,  s0 = Cd d/sqrt(pi)
///   a = [1 - sqrt(1 - s0/s)]/sqrt(2),  from  int (U - w) w dy = Cd d U^2/2: the drag
///
/// s0, the width at the axis, is the least that can carry the drag; a there is 0.71. The wake is
/// faded in by smooth steps of x from 0 to d and of the distance from the wall from 0 to d, so that
/// the field has no jump and still no flow through the wall; from x = 3 d/2 on the momentum
/// deficit is the drag to rounding.
///
/// Wake and potential flow are added as Huse's method for arrays of risers adds wake and dipole.
/// It is stated for Reynolds numbers of 3e5 to 3.6e6 (0.1 to 0.8 m/s at 5 m) and from a few
/// diameters on; nearer it is a smooth continuation, not a measurement.
///
/// Steady mean flow of a current alone: no vortex street (it shakes a vehicle with up to a third of
/// U, Strouhal number near 0.2 to 0.3), no reversed flow in the bubble right behind the pile, no
/// horseshoe vortex at the bed, no free-surface wave. Small orbital motion does not separate: give
/// it the current, not the waves. Vertical velocity is left as it is.
///
/// @param current_m_s      U, ENU, towards
/// @param from_axis_m      position east and north of the pile's axis
/// @return m/s, ENU, towards; nothing inside the pile, where there is no water (serve it as land).
///         On the wall itself there is a value. Cost: two roots and an exp. No allocation,
///         thread-safe.
/// Source: Lamb (1932), Hydrodynamics, art. 68; Schlichting & Gersten, Boundary-Layer Theory, ch.
/// 22; Huse (1993), OTC 7237.
[[nodiscard]] std::optional<Horizontal> flow_around_pile(const Pile& pile, Horizontal current_m_s,
                                                         Horizontal from_axis_m) noexcept;

/// The two parts apart, for tests and for pictures: outside the pile alone, r >= R.
[[nodiscard]] Horizontal potential_flow_around_pile(const Pile& pile, Horizontal current_m_s,
                                                    Horizontal from_axis_m) noexcept;
/// What the wake takes away (m/s, against the current).
[[nodiscard]] Horizontal wake_behind_pile(const Pile& pile, Horizontal current_m_s,
                                          Horizontal from_axis_m) noexcept;

}  // namespace slackwater
