#include "fields/current/astronomy.h"

#include <array>
#include <cmath>
#include <string>

#include "fields/base/constants.h"
#include "fields/base/error.h"

namespace slackwater {
namespace {

/// Hourly rates in degrees: mean lunar time and the three longitudes.
constexpr Constituent make(std::string_view name, int tau, int s, int h, int p,
                           double offset_cycles) {
  const double deg_per_hour = tau * 14.49205212 + s * 0.54901653 + h * 0.04106864 + p * 0.00464183;
  return {name, tau, s, h, p, offset_cycles, deg_per_hour * constants::degree / 3600.0};
}

// Offsets in cycles after Foreman (1977): K1 alone among the diurnals is a quarter turn behind.
constexpr std::array table{
    make("M2", 2, 0, 0, 0, 0.0),    make("S2", 2, 2, -2, 0, 0.0),   make("N2", 2, -1, 0, 1, 0.0),
    make("K2", 2, 2, 0, 0, 0.0),    make("K1", 1, 1, 0, 0, -0.75),  make("O1", 1, -1, 0, 0, -0.25),
    make("P1", 1, 1, -2, 0, -0.25), make("Q1", 1, -2, 0, 1, -0.25), make("M4", 4, 0, 0, 0, 0.0),
    make("MS4", 4, 2, -2, 0, 0.0),  make("MN4", 4, -1, 0, 1, 0.0),  make("M6", 6, 0, 0, 0, 0.0),
    make("MSf", 0, 2, -2, 0, 0.0),
};

}  // namespace

std::span<const Constituent> tidal_constituents() noexcept { return table; }

const Constituent& tidal_constituent(std::string_view name) {
  std::string known;
  for (const Constituent& constituent : table) {
    if (constituent.name == name) return constituent;
    known += known.empty() ? "" : " ";
    known += constituent.name;
  }
  throw Error(ErrorKind::not_found, "tidal constituent '" + std::string(name) +
                                        "' is not in the table; use one of " + known);
}

MeanLongitudes mean_longitudes(UtcTime time) noexcept {
  constexpr UtcTime epoch =
      std::chrono::sys_days(std::chrono::year(1899) / 12 / 31) + std::chrono::hours(12);
  const double days = seconds_between(epoch, time) / 86400.0;
  return {(270.434164 + 13.1763965268 * days) * constants::degree,
          (279.696678 + 0.9856473354 * days) * constants::degree,
          (334.329556 + 0.1114040803 * days) * constants::degree};
}

double astronomical_argument_rad(const Constituent& constituent, UtcTime time) noexcept {
  constexpr double turn = 2.0 * constants::pi;
  const MeanLongitudes mean = mean_longitudes(time);
  const double day_fraction = seconds_between(UtcTime(day_of(time)), time) / 86400.0;
  const double tau_rad = turn * day_fraction + mean.h_rad - mean.s_rad;
  const double argument = constituent.tau * tau_rad + constituent.s * mean.s_rad +
                          constituent.h * mean.h_rad + constituent.p * mean.p_rad +
                          turn * constituent.offset_cycles;
  return argument - turn * std::floor(argument / turn);
}

}  // namespace slackwater
