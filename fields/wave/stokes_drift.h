#pragma once
#include <span>

#include "fields/base/frame.h"
#include "fields/wave/wave_component.h"

namespace slackwater {

// The slow drift of water particles along the waves. It is not part of the Eulerian current: it is
// added only for what drifts where no wave motion is simulated.

/// Stokes drift of one wave in water of finite depth,
///
///   u_s = a^2 omega k cosh[2k(z + h)] / (2 sinh^2 kh)
///
/// along the wave. Written in exponentials that do not overflow, so that deep water, a^2 omega k
/// e^(2kz), is its limit for any k h.
///
/// @param frequency_rad_s   omega, relative to the water
/// @param wavenumber_rad_m  k > 0
/// @param water_depth_m     h > 0
/// @param height_m          z, up from still water, -h <= z <= 0
/// @return m/s.  Source: Dean & Dalrymple (1991), eq. 10.11.
[[nodiscard]] double monochromatic_stokes_drift_m_s(double amplitude_m, double frequency_rad_s,
                                                    double wavenumber_rad_m, double water_depth_m,
                                                    double height_m);

/// The sum over the sinusoids of a sea, towards, m/s: the drift that its simulated orbits have. The
/// waves above 6 omega_p that `components_of` leaves out would add to it at the surface (some 15 %
/// for a Pierson-Moskowitz sea) and nowhere else.
[[nodiscard]] Horizontal stokes_drift_m_s(std::span<const WaveComponent> waves,
                                          const WaveWater& water, double height_m);

/// Depth-integrated Stokes drift of a sea in deep water, m2/s: V = 2 pi Hs^2/(16 Tm01).
[[nodiscard]] double stokes_transport_m2_s(double significant_height_m, double tm01_s);

/// Shape of the drift over depth where only its surface value (a product's VSDX, VSDY) and its
/// transport are known.
enum class StokesProfile {
  /// u_s = us0 {e^(2kz) - beta sqrt(2 pi k|z|) erfc sqrt(2k|z|)}, beta = 1, k = us0 (1 - 2 beta/3)/
  /// (2V): the tail of Phillips. Its integral is V; the better shear near the surface. Breivik,
  /// Bidlot & Janssen (2016), Ocean Modelling 100, 49.
  phillips_2016,
  /// u_s = us0 e^(2 k_e z)/(1 - 8 k_e z), k_e = us0/(5.97 V). Breivik, Janssen & Bidlot (2014), J.
  /// Phys. Oceanogr. 44, 2433.
  exponential_integral_2014,
};

/// Share of the surface drift that is left at a height below it, 0 to 1.
///
/// @param surface_m_s       us0 >= 0, the magnitude at the surface; 0: the profile is 0
/// @param transport_m2_s    V > 0
/// @param height_m          z <= 0; deep water is assumed
[[nodiscard]] double stokes_share(double surface_m_s, double transport_m2_s, double height_m,
                                  StokesProfile profile = StokesProfile::phillips_2016);

/// The drift below a surface value, towards, m/s: that value times `stokes_share`.
[[nodiscard]] Horizontal stokes_drift_m_s(Horizontal surface_m_s, double transport_m2_s,
                                          double height_m,
                                          StokesProfile profile = StokesProfile::phillips_2016);

}  // namespace slackwater
