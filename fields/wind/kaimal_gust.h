#pragma once
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "fields/wind/gust.h"
#include "fields/wind/kaimal_spectrum.h"

namespace slackwater {

/// How finely a Kaimal series is cut.
struct KaimalBands {
  int bands = 128;                  ///< components per axis, 2 or more
  double lowest_hz = 1.0 / 3600.0;  ///< the first band reaches from 0 to here
  double highest_hz = 10.0;         ///< nothing faster is generated
};

/// A seeded realisation of the Kaimal spectrum that can be asked at any instant, in any order, and
/// keeps no state: a sum of cosines,
///
///   u_k(t) = sum_j sqrt(2 V_kj) cos(2 pi f_kj t + phi_kj),
///
/// one per band of the spectrum, the bands equal in log n. V_kj is the exact variance of the band,
/// so every realisation carries the variance asked below `highest_hz` (99.3 % of the whole along
/// and 96.3 % up at 12 m/s and hub height); phases are uniform, and frequencies are drawn
/// evenly inside their band so that the sum has no period. The three axes are independent, as IEC
/// 61400-1 has them without its coherence.
///
/// The series belongs to one point. For a moving vehicle ask at t - s/U, with s the distance along
/// the mean wind (Taylor's frozen turbulence); separation across the wind is not modelled.
/// Source: Shinozuka & Deodatis (1991), Appl. Mech. Rev. 44, 191.
class KaimalGust {
 public:
  /// The same seed and stream name give the same gusts on every machine of one mathematics library.
  KaimalGust(const KaimalSpectrum& spectrum, std::uint64_t run_seed,
             std::string_view stream_name = "fields/kaimal_gust", KaimalBands bands = {});

  /// The gust at t_s seconds since the epoch of the caller; cost: 3 x bands cosines, no allocation.
  [[nodiscard]] Gust at(double t_s) const noexcept;
  /// Mean square over all times of one axis, m2/s2: the variance of its bands together.
  [[nodiscard]] double variance_m2_s2(GustAxis axis) const noexcept;

 private:
  struct Component {
    double amplitude_m_s;
    double angular_frequency_rad_s;
    double phase_rad;
  };
  [[nodiscard]] double sum(GustAxis axis, double t_s) const noexcept;
  std::array<std::vector<Component>, 3> axes_;
};

}  // namespace slackwater
