#include "fields/current/wind_stress.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"

namespace slackwater {

std::string_view name_of(DragLaw law) noexcept {
  return law == DragLaw::paper_linear ? "paper_linear" : "saturating_2p6";
}

double drag_coefficient(double wind_speed_10m_m_s, DragLaw law) noexcept {
  const double ceiling = law == DragLaw::paper_linear ? 2.43e-3 : 2.6e-3;
  return std::min((0.79 + 0.08 * wind_speed_10m_m_s) * 1e-3, ceiling);
}

Horizontal wind_stress_pa(Horizontal wind_10m_m_s, DragLaw law) noexcept {
  const double speed = std::hypot(wind_10m_m_s.real(), wind_10m_m_s.imag());
  const double factor = constants::air_density_kg_m3 * drag_coefficient(speed, law) * speed;
  return {factor * wind_10m_m_s.real(), factor * wind_10m_m_s.imag()};
}

}  // namespace slackwater
