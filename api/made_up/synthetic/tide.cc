#include "api/made_up/synthetic/tide.h"

#include <cmath>

#include "fields/base/constants.h"

namespace slackwater::api {
namespace {

/// Multiples of the lunar hour angle tau and of the mean longitudes of moon s, sun h and lunar
/// perigee p, a constant, and what the constituent does at the site.
struct Constituent {
  std::string_view name;
  int tau, s, h, p;
  double constant_deg;
  double major_m_s, minor_m_s, inclination_deg,
      lag_deg;  ///< ellipse; inclination counter-clockwise from east
  double elevation_m, elevation_lag_deg;
};

constexpr std::array<Constituent, Tide::constituents> table{{
    {"M2", 2, 0, 0, 0, 0, 0.50, -0.045, 18, 95, 3.60, 170},
    {"S2", 2, 2, -2, 0, 0, 0.18, -0.015, 18, 142, 1.33, 218},
    {"N2", 2, -1, 0, 1, 0, 0.095, -0.009, 18, 77, 0.71, 152},
    {"K1", 1, 1, 0, 0, -90, 0.018, 0.006, 25, 40, 0.09, 98},
    {"O1", 1, -1, 0, 0, -90, 0.015, 0.004, 25, 320, 0.07, 355},
    {"M4", 4, 0, 0, 0, 0, 0.040, 0.010, 30, 210, 0.17, 280},
}};

// Degrees per hour: Doodson's rates, as in every table of constituents.
constexpr double tau_rate = 14.49205212;
constexpr double s_rate = 0.54901653;
constexpr double h_rate = 0.04106864;
constexpr double p_rate = 0.00464183;

constexpr double amplitude_gain(PlanePoint point) noexcept {
  return 1 - 4e-6 * point.north_m +
         2e-6 * point.east_m;  // 4 % per 10 km towards the coast, 2 % eastwards
}

/// The wave travels east: 0.25 degrees of M2 per km.
double travel_lag_rad(PlanePoint point, std::size_t constituent) noexcept {
  return constants::degree * 0.25e-3 * point.east_m * Tide::speed_deg_h(constituent) /
         Tide::speed_deg_h(0);
}

}  // namespace

std::string_view Tide::name(std::size_t constituent) noexcept { return table[constituent].name; }

double Tide::speed_deg_h(std::size_t constituent) noexcept {
  const Constituent& c = table[constituent];
  return c.tau * tau_rate + c.s * s_rate + c.h * h_rate + c.p * p_rate;
}

Tide::Arguments Tide::arguments(UtcTime time) noexcept {
  // Mean longitudes at 2000-01-01T12:00Z (Meeus, Astronomical Algorithms, ch. 25 and 47), in
  // degrees.
  static const UtcTime j2000 = UtcDay(std::chrono::year{2000} / 1 / 1) + std::chrono::hours{12};
  const double hours = hours_between(j2000, time);
  const double s = 218.3164 + s_rate * hours;
  const double h = 280.4665 + h_rate * hours;
  const double p = 83.3532 + p_rate * hours;
  const double tau = h - s + 15 * hours;  // the mean sun culminates at 12:00
  Arguments result;
  for (std::size_t j = 0; j < constituents; ++j) {
    const Constituent& c = table[j];
    result[j] = std::polar(
        1.0, constants::degree * (c.tau * tau + c.s * s + c.h * h + c.p * p + c.constant_deg));
  }
  return result;
}

Tide::RotaryParts Tide::parts(const ColumnPhysics& physics, PlanePoint point, double water_depth_m,
                              double depth_m) noexcept {
  RotaryParts result;
  const double gain = amplitude_gain(point);
  for (std::size_t j = 0; j < constituents; ++j) {
    const Constituent& c = table[j];
    const double sigma_rad_s = constants::degree * speed_deg_h(j) / 3600;
    const double lag = constants::degree * c.lag_deg + travel_lag_rad(point, j);
    const double turn = constants::degree * c.inclination_deg;
    result.counter_clockwise[j] = std::polar(gain * 0.5 * (c.major_m_s + c.minor_m_s), turn - lag) *
                                  bottom_layer_factor(physics, water_depth_m, depth_m, sigma_rad_s);
    result.clockwise[j] = std::polar(gain * 0.5 * (c.major_m_s - c.minor_m_s), turn + lag) *
                          bottom_layer_factor(physics, water_depth_m, depth_m, -sigma_rad_s);
  }
  return result;
}

Horizontal Tide::current(const RotaryParts& parts, const Arguments& arguments) noexcept {
  Horizontal sum = 0;
  for (std::size_t j = 0; j < constituents; ++j) {
    sum += parts.counter_clockwise[j] * arguments[j] + parts.clockwise[j] * std::conj(arguments[j]);
  }
  return sum;
}

double Tide::elevation_m(PlanePoint point, const Arguments& arguments) noexcept {
  double sum = 0;
  for (std::size_t j = 0; j < constituents; ++j) {
    const double lag = constants::degree * table[j].elevation_lag_deg + travel_lag_rad(point, j);
    sum += amplitude_gain(point) * table[j].elevation_m *
           std::real(arguments[j] * std::polar(1.0, -lag));
  }
  return sum;
}

}  // namespace slackwater::api
