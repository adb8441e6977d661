#pragma once
#include <span>

#include "fields/current/steady_column.h"

namespace slackwater::calibration {

/// The responses of one level and how they change with the logarithms of the two parameters that
/// shape them.
struct ResponseDerivatives {
  Complex<double> interior, interior_by_log_viscosity, interior_by_log_bottom;
  Complex<double> stress, stress_by_log_viscosity, stress_by_log_bottom;  ///< stress factor 1
};

/// Evaluates the forward model of fields/current in dual numbers at every level; exact derivatives.
///
/// @param log_viscosity  ln of the eddy viscosity in m2/s
/// @param log_bottom     ln of the bottom friction in m/s (finite_depth) or of the bed layer's eddy
/// viscosity in
///                       m2/s (three_layer)
/// @param out            one per depth
/// About 1 us a level. No allocation beyond one scratch array; thread-safe.
void response_derivatives(SteadyForm form, double log_viscosity, double log_bottom, Angle latitude,
                          double water_depth_m, std::span<const double> depths_m,
                          std::span<ResponseDerivatives> out);

}  // namespace slackwater::calibration
