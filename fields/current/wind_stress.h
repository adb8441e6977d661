#pragma once
#include <string_view>

#include "fields/base/frame.h"

namespace slackwater {

/// How the drag coefficient grows with the wind at 10 m, U in m/s:
///
///   paper_linear    Cd = (0.79 + 0.08 U) 1e-3 below 20.5 m/s, 2.43e-3 above (continuous there)
///   saturating_2p6  the same line up to 22.625 m/s, where it reaches 2.6e-3, and 2.6e-3 above
///
/// The pair 0.79 + 0.08 U is the one of the LOTUSim-Energy paper; we found no older source for it.
/// The second law keeps its slope and takes the saturation of Curcic and Haus (2020, GRL 47,
/// 2020GL087647).
enum class DragLaw { paper_linear, saturating_2p6 };
[[nodiscard]] std::string_view name_of(DragLaw law) noexcept;

/// Drag coefficient of the sea surface, without dimension, for a wind speed >= 0 at 10 m.
[[nodiscard]] double drag_coefficient(double wind_speed_10m_m_s, DragLaw law) noexcept;

/// Stress of the wind on the water, tau = rho_air Cd |U| U, Pa, along the wind (towards).
///
/// @param wind_10m_m_s  wind at 10 m, ENU, towards; relative to the water where the difference
/// matters
/// @note  A mean wind gives less than the mean stress; callers with gusty means know their factor.
[[nodiscard]] Horizontal wind_stress_pa(Horizontal wind_10m_m_s,
                                        DragLaw law = DragLaw::paper_linear) noexcept;

}  // namespace slackwater
