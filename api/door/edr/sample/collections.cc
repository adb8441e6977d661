#include <cmath>

#include "api/door/edr/sample/collection.h"
#include "fields/base/constants.h"
#include "fields/base/turn.h"

// The collections and their quantities, one table each.

namespace slackwater::api::edr {
namespace {

double degrees_from_north(Horizontal towards) {
  return compass_deg(std::atan2(towards.real(), towards.imag()) * 180 / constants::pi);
}

// --- how a value is had from a sample that has one ---

template <typename Sample>
double east(const Sample& s) {
  return s.velocity_m_s.real();
}
template <typename Sample>
double north(const Sample& s) {
  return s.velocity_m_s.imag();
}
template <typename Sample>
double speed(const Sample& s) {
  return std::abs(s.velocity_m_s);
}
double to_direction(const CurrentSample& s) { return degrees_from_north(s.velocity_m_s); }
double from_direction(const WindSample& s) { return degrees_from_north(-s.velocity_m_s); }

template <Horizontal CurrentQuantiles::*quantile>
double east_of(const CurrentSample& s) {
  return (quantiles_of(s).*quantile).real();
}
template <Horizontal CurrentQuantiles::*quantile>
double north_of(const CurrentSample& s) {
  return (quantiles_of(s).*quantile).imag();
}

double significant_height(const SeaSample& s) { return s.sea.significant_height_m; }
double peak_period(const SeaSample& s) { return s.sea.peak_period_s; }
double wave_from_direction(const SeaSample& s) { return s.sea.from_direction_deg; }

double level(const SeaLevelSample& s) { return s.level_m; }
template <double SeaLevelQuantiles::*quantile>
double level_of(const SeaLevelSample& s) {
  return quantiles_of(s).*quantile;
}

/// `Quantity::append` by one of the functions above.
template <auto value, typename Sample>
void each(std::span<const Sample> samples, std::vector<double>& values) {
  for (const Sample& s : samples) values.push_back(has_value(s.status) ? value(s) : constants::nan);
}

// --- what clients are told of it ---

struct Unit {
  const char* symbol;
  const char* label;
};
constexpr Unit metre_per_second{"m/s", "metre per second"};
constexpr Unit metre{"m", "metre"};
constexpr Unit second{"s", "second"};
constexpr Unit degree{"deg", "degree"};

// By their CF names; the description says which forecast.

Parameter central(const std::string& name, const std::string& label, Unit unit) {
  return {name, name, label, label + ", central", unit.symbol, unit.label, "central"};
}

Parameter described(const std::string& name, const std::string& label, Unit unit,
                    const std::string& description) {
  return {name,        name,       label,    description + ", central forecast",
          unit.symbol, unit.label, "central"};
}

Parameter direction(const std::string& name, const std::string& label) {
  return described(name, label, degree, label + ", degrees clockwise from true north");
}

Parameter quantile(const std::string& name, const std::string& label, const std::string& ending,
                   const std::string& method, Unit unit = metre_per_second) {
  return {name + "_" + ending, name, label, label + ", " + method, unit.symbol, unit.label, method};
}

// --- the tables; of velocities the two components come first ---

Quantities<CurrentSample> current_quantities() {
  const char* eastward = "eastward_sea_water_velocity";
  const char* northward = "northward_sea_water_velocity";
  using Now = CurrentSample;
  using Q = CurrentQuantiles;
  static const std::array<Quantity<Now>, 10> all{{
      {central(eastward, "Eastward current", metre_per_second), each<east<Now>>},
      {central(northward, "Northward current", metre_per_second), each<north<Now>>},
      {central("sea_water_speed", "Current speed", metre_per_second), each<speed<Now>>},
      {direction("sea_water_velocity_to_direction", "Direction the current goes to"),
       each<to_direction>},
      {quantile(eastward, "Eastward current", "p10", "quantile 0.1"), each<east_of<&Q::p10_m_s>>},
      {quantile(northward, "Northward current", "p10", "quantile 0.1"),
       each<north_of<&Q::p10_m_s>>},
      {quantile(eastward, "Eastward current", "p50", "quantile 0.5"), each<east_of<&Q::p50_m_s>>},
      {quantile(northward, "Northward current", "p50", "quantile 0.5"),
       each<north_of<&Q::p50_m_s>>},
      {quantile(eastward, "Eastward current", "p90", "quantile 0.9"), each<east_of<&Q::p90_m_s>>},
      {quantile(northward, "Northward current", "p90", "quantile 0.9"),
       each<north_of<&Q::p90_m_s>>},
  }};
  return all;
}

Quantities<WindSample> wind_quantities() {
  static const std::array<Quantity<WindSample>, 4> all{{
      {central("eastward_wind", "Eastward wind", metre_per_second), each<east<WindSample>>},
      {central("northward_wind", "Northward wind", metre_per_second), each<north<WindSample>>},
      {central("wind_speed", "Wind speed", metre_per_second), each<speed<WindSample>>},
      {direction("wind_from_direction", "Direction the wind comes from"), each<from_direction>},
  }};
  return all;
}

Quantities<SeaSample> wave_quantities() {
  static const std::array<Quantity<SeaSample>, 3> all{{
      {described("sea_surface_wave_significant_height", "Significant wave height", metre,
                 "Significant wave height"),
       each<significant_height>},
      {described("sea_surface_wave_period_at_variance_spectral_density_maximum", "Peak period",
                 second, "Period of the spectral peak"),
       each<peak_period>},
      {direction("sea_surface_wave_from_direction", "Direction the waves come from"),
       each<wave_from_direction>},
  }};
  return all;
}

Quantities<SeaLevelSample> sea_level_quantities() {
  const char* name = "sea_surface_height_above_geoid";
  const char* label = "Sea level";
  using Now = SeaLevelSample;
  using Q = SeaLevelQuantiles;
  static const std::array<Quantity<Now>, 4> all{{
      {described(name, label, metre,
                 "Height of the sea surface above mean sea level (the geoid), positive up"),
       each<level>},
      {quantile(name, label, "p10", "quantile 0.1", metre), each<level_of<&Q::p10_m>>},
      {quantile(name, label, "p50", "quantile 0.5", metre), each<level_of<&Q::p50_m>>},
      {quantile(name, label, "p90", "quantile 0.9", metre), each<level_of<&Q::p90_m>>},
  }};
  return all;
}

}  // namespace

std::span<const Collection> collections() {
  static const std::array<Collection, 6> all{
      {{"currents",
        "Currents",
        "Eulerian current of the central forecast and its 10, 50 and 90 % "
        "quantiles, towards, by "
        "depth below mean sea level",
        {"current", "velocity", "depth", "forecast"},
        Vertical::depth_down,
        current_quantities()},
       {"currents-members",
        "Currents, members",
        "Equally likely futures of the current; member 0 is the central one",
        {"current", "ensemble", "member"},
        Vertical::depth_down,
        current_quantities().first(2),
        true},
       {"wind",
        "Wind",
        "Mean wind, towards (components) and from (direction), by height above "
        "mean sea level, "
        "brought from 10 m by the neutral logarithmic profile",
        {"wind", "forecast"},
        Vertical::height_up,
        wind_quantities()},
       {"wind-members",
        "Wind, members",
        "The wind that drives each member of the current",
        {"wind", "ensemble", "member"},
        Vertical::height_up,
        wind_quantities().first(2),
        true},
       {"waves",
        "Waves",
        "Significant height, peak period and the direction that waves come "
        "from",
        {"waves", "sea state", "forecast"},
        Vertical::none,
        wave_quantities()},
       {"sea-level",
        "Sea level",
        "Height of the sea surface above mean sea level (the geoid), positive up, with its 10, 50 "
        "and 90 % quantiles: the tide, or a product's level where it forecasts one. Not above "
        "chart "
        "datum, which no forecast states. Depths and heights of other collections do not move with "
        "it",
        {"tide", "sea level", "water level", "forecast"},
        Vertical::none,
        sea_level_quantities()}}};
  return all;
}

}  // namespace slackwater::api::edr
