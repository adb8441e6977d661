#pragma once
#include <optional>

namespace slackwater {

/// Wavenumber of a linear wave in still water of finite depth,
///
///   omega^2 = g k tanh(k h)
///
/// by Newton's method from Eckart's k0 = omega^2 / (g sqrt(tanh(omega^2 h / g))), to rounding.
///
/// @param frequency_rad_s  omega >= 0, relative to the water
/// @param water_depth_m    h > 0
/// @return k in rad/m, 0 for omega = 0.  Thread-safe, no allocation.
/// Source: Eckart (1952); Dean & Dalrymple (1991), eq. 3.35.
[[nodiscard]] double wavenumber_rad_m(double frequency_rad_s, double water_depth_m);

/// omega(k) = sqrt(g k tanh(k h)), rad/s: the inverse of `wavenumber_rad_m`. k >= 0, h > 0.
[[nodiscard]] double intrinsic_frequency_rad_s(double wavenumber_rad_m, double water_depth_m);

/// Speed at which the energy of a wave travels through the water,
/// cg = n omega/k,  n = (1 + 2 k h / sinh 2 k h)/2;  sqrt(g h) for k = 0.  k >= 0, h > 0.
[[nodiscard]] double group_speed_m_s(double wavenumber_rad_m, double water_depth_m);

/// Wavenumber of the wave that a resting observer sees at frequency omega in a current U along the
/// wave (positive with it, negative against it),
///
///   (omega - k U)^2 = g k tanh(k h),   omega - k U >= 0
///
/// the root whose energy still travels with the wave, cg + U > 0. The other root of an opposing
/// current, a short wave swept back, is never meant by a wave spectrum.
///
/// @param absolute_rad_s  omega >= 0, at a fixed place
/// @return k in rad/m; nothing where the current blocks the wave (no wave of this frequency
///         advances against it; in deep water beyond omega |U| / g = 1/4)
/// Source: Peregrine (1976), Adv. Appl. Mech. 16, 9.
[[nodiscard]] std::optional<double> wavenumber_in_current_rad_m(double absolute_rad_s,
                                                                double water_depth_m,
                                                                double current_along_wave_m_s);

}  // namespace slackwater
