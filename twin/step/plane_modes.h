#pragma once
#include <complex>
#include <vector>

#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// The modes of a vehicle that goes straight and level with nobody at its controls, by the plane in
/// which they move it: rates and frequencies, 1/s, those that grow or fade slowest first. Of a pair
/// that swings the one of positive frequency.
struct PlaneModes {
  std::vector<std::complex<double>> vertical;    ///< depth, pitch, u, w, q
  std::vector<std::complex<double>> horizontal;  ///< roll, v, p, r
};

/// Eigenvalues of the two blocks of `open_loop_matrix`. What couples the planes (a vehicle that is
/// not alike on both sides) is left out.
[[nodiscard]] PlaneModes plane_modes(const Vehicle& vehicle, double speed_m_s);

}  // namespace slackwater::twin
