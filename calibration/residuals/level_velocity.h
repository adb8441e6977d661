#pragma once
#include <cstddef>

#include "calibration/residuals/response_derivatives.h"

namespace slackwater::calibration {

/// The order in which the estimated parameters stand in every vector of this room. A day without
/// wind estimates the first four, a day in the equatorial band the first two.
enum ParameterIndex : std::size_t {
  interior_east = 0,       ///< m/s
  interior_north = 1,      ///< m/s
  log_eddy_viscosity = 2,  ///< ln(m2/s)
  log_bottom = 3,  ///< ln of the bottom friction (m/s) or of the bed layer's eddy viscosity (m2/s)
  log_stress_factor = 4,  ///< ln, no dimension
  parameter_count = 5,
};

/// One observed current: a level at an instant, or its mean over an interval.
struct LevelVelocity {
  Horizontal observed_m_s{};
  Horizontal stress_pa{};  ///< of the same instant, or averaged over the same interval; 0 when no
                           ///< wind is used
  std::size_t level = 0;   ///< position in the list of depths
};

/// Residual of one observed current: (model - observed)/sigma, two numbers (east, north).
///
///   model = W_interior A + e^{log_stress_factor} T B
///
/// Whitened by `sigma_m_s`, the standard deviation of each component of model minus observation,
/// the same at all levels of a day: the one stated for the product or, where it is larger, that of
/// the day's own misfit.
///
/// @param response    of the observation's level at the current parameters
/// @param parameters  `count` values in the order of `ParameterIndex`, count in {2, 4, 5}
/// @param residual    2 values
/// @param jacobian    2 x count, row-major, d residual / d parameter; may be null
/// A few nanoseconds; no allocation, thread-safe.
inline void level_velocity_residual(const LevelVelocity& observation,
                                    const ResponseDerivatives& response, const double* parameters,
                                    std::size_t count, double stress_factor, double sigma_m_s,
                                    double* residual, double* jacobian) noexcept {
  const double whitening = 1.0 / sigma_m_s;
  const Complex<double> flow{parameters[interior_east], parameters[interior_north]};
  const Complex<double> stress{stress_factor * observation.stress_pa.real(),
                               stress_factor * observation.stress_pa.imag()};
  const Complex<double> by_wind = stress * response.stress;
  const Complex<double> model = flow * response.interior + by_wind;
  residual[0] = whitening * (model.re - observation.observed_m_s.real());
  residual[1] = whitening * (model.im - observation.observed_m_s.imag());
  if (jacobian == nullptr) return;
  const auto column = [&](std::size_t i, const Complex<double>& derivative) {
    jacobian[i] = whitening * derivative.re;
    jacobian[count + i] = whitening * derivative.im;
  };
  column(interior_east, response.interior);
  column(interior_north, {-response.interior.im, response.interior.re});
  if (count > log_bottom) {
    column(log_eddy_viscosity,
           flow * response.interior_by_log_viscosity + stress * response.stress_by_log_viscosity);
    column(log_bottom,
           flow * response.interior_by_log_bottom + stress * response.stress_by_log_bottom);
  }
  if (count > log_stress_factor) column(log_stress_factor, by_wind);
}

}  // namespace slackwater::calibration
