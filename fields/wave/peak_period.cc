#include "fields/wave/peak_period.h"

#include "fields/wave/spectrum.h"

namespace slackwater {
namespace {

/// Of a JONSWAP sea; its ratios of periods depend on gamma alone.
const SpectralMoments& moments() {
  static const SpectralMoments found = moments_of(jonswap_spectrum(1, 1, 3.3));
  return found;
}

}  // namespace

double peak_period_of_energy_period_s(double energy_period_s) {
  return energy_period_s / moments().energy_period_s();
}

double peak_period_of_zero_crossing_period_s(double zero_crossing_period_s) {
  return zero_crossing_period_s / moments().tm02_s();
}

}  // namespace slackwater
