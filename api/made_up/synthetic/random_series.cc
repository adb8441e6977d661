#include "api/made_up/synthetic/random_series.h"

#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::api {

RandomVectorField::RandomVectorField(const Scales& scales, std::uint64_t run_seed,
                                     std::string_view stream_name) {
  expects(scales.terms > 0 && scales.shortest_period_h > 0 &&
              scales.longest_period_h > scales.shortest_period_h &&
              scales.shortest_wavelength_m > 0,
          "a random field needs terms, and periods and wavelengths above zero");
  Rng rng(run_seed, stream_name);
  const double highest = 2 * constants::pi / scales.shortest_period_h;
  const double lowest = 2 * constants::pi / scales.longest_period_h;
  for (int j = 0; j < scales.terms; ++j) {
    const double share = (j + rng.uniform()) / scales.terms;
    const double sense = j % 2 == 0 ? 1.0 : -1.0;
    const double wavenumber = rng.uniform() * 2 * constants::pi / scales.shortest_wavelength_m;
    const double heading = rng.uniform(0, 2 * constants::pi);
    terms_.push_back({.frequency_rad_h = sense * (lowest + share * (highest - lowest)),
                      .east_rad_m = wavenumber * std::cos(heading),
                      .north_rad_m = wavenumber * std::sin(heading),
                      .phase_rad = rng.uniform(0, 2 * constants::pi)});
  }
  amplitude_m_s_ = scales.component_sigma_m_s * std::sqrt(2.0 / scales.terms);
}

Horizontal RandomVectorField::at(PlanePoint point, double hours) const noexcept {
  Horizontal sum = 0;
  for (const Term& term : terms_) {
    sum +=
        std::polar(amplitude_m_s_, term.frequency_rad_h * hours + term.east_rad_m * point.east_m +
                                       term.north_rad_m * point.north_m + term.phase_rad);
  }
  return sum;
}

}  // namespace slackwater::api
