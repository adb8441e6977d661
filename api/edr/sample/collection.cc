#include "api/edr/sample/collection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/wave/growth.h"

namespace slackwater::api::edr {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
/// Heights at which a range of wind is given.
constexpr std::array wind_heights_m{10.0,  20.0,  40.0,  60.0,  80.0,
                                    100.0, 120.0, 150.0, 200.0, 300.0};

enum Kind : std::size_t { currents, currents_members, wind, wind_members, waves };

Kind kind_of(const Collection& collection) {
  return static_cast<Kind>(&collection - collections().data());
}

Parameter speed(const std::string& name, const std::string& standard_name, const std::string& label,
                const std::string& method) {
  return {name, standard_name, label, label + ", " + method, "m/s", "metre per second", method};
}

Parameter direction(const std::string& name, const std::string& label) {
  return {
      name,  name,     label,    label + ", degrees clockwise from true north, central forecast",
      "deg", "degree", "central"};
}

void add_components(std::vector<Parameter>& list, const std::string& ending, const char* east,
                    const char* north, const std::string& what, const std::string& method) {
  const auto tail = ending.empty() ? "" : "_" + ending;
  list.push_back(speed(std::string(east) + tail, east, "Eastward " + what, method));
  list.push_back(speed(std::string(north) + tail, north, "Northward " + what, method));
}

constexpr const char* east_current = "eastward_sea_water_velocity";
constexpr const char* north_current = "northward_sea_water_velocity";

std::vector<Parameter> member_parameters(std::size_t members, const char* east, const char* north,
                                         const std::string& what) {
  std::vector<Parameter> list;
  for (std::size_t m = 0; m < members; ++m) {
    const std::string number = std::to_string(m);
    add_components(list, "member_" + number, east, north, what, "member " + number);
  }
  return list;
}

double degrees_from_north(Horizontal towards) {
  const double degrees = std::atan2(towards.real(), towards.imag()) * 180 / constants::pi;
  return degrees < 0 ? degrees + 360 : degrees;
}

/// One of the parameters of `currents`, in the order of parameters_of.
double current_value(const CurrentSample& s, std::size_t parameter) {
  switch (parameter) {
    case 0:
      return s.velocity_m_s.real();
    case 1:
      return s.velocity_m_s.imag();
    case 2:
      return std::abs(s.velocity_m_s);
    case 3:
      return degrees_from_north(s.velocity_m_s);
    default:
      break;
  }
  const CurrentQuantiles q = quantiles_of(s);
  const std::array quantile{q.p10_m_s, q.p50_m_s, q.p90_m_s};
  const Horizontal w = quantile[(parameter - 4) / 2];
  return parameter % 2 == 0 ? w.real() : w.imag();
}

double wind_value(const WindSample& s, std::size_t parameter) {
  switch (parameter) {
    case 0:
      return s.velocity_m_s.real();
    case 1:
      return s.velocity_m_s.imag();
    case 2:
      return std::abs(s.velocity_m_s);
    default:
      return degrees_from_north(-s.velocity_m_s);
  }
}

double sea_value(const SeaSample& s, std::size_t parameter) {
  switch (parameter) {
    case 0:
      return s.sea.significant_height_m;
    case 1:
      return s.sea.peak_period_s;
    default:
      return s.sea.from_direction_deg;
  }
}

template <typename Sample, typename Value>
void append(std::span<const Sample> samples, std::span<const std::size_t> selected, Value value,
            std::vector<std::vector<double>>& values, Absences& absences) {
  for (const Sample& s : samples)
    if (!has_value(s.status)) ++absences.count[static_cast<std::size_t>(s.status)];
  for (std::size_t p = 0; p < selected.size(); ++p) {
    for (const Sample& s : samples)
      values[p].push_back(has_value(s.status) ? value(s, selected[p]) : nan);
  }
}

/// Members: two parameters each; a member is sampled once for both.
template <typename Sample, typename SampleAll>
void append_members(std::span<const Place> places, std::span<const std::size_t> selected,
                    SampleAll sample_all, std::vector<std::vector<double>>& values,
                    Absences& absences) {
  std::vector<Sample> samples(places.size());
  std::size_t held = std::numeric_limits<std::size_t>::max();
  for (std::size_t p = 0; p < selected.size(); ++p) {
    const std::size_t member = selected[p] / 2;
    if (member != held) {
      sample_all(member, std::span<Sample>(samples));
      held = member;
    }
    for (const Sample& s : samples) {
      if (!has_value(s.status)) ++absences.count[static_cast<std::size_t>(s.status)];
      const Horizontal w = s.velocity_m_s;
      values[p].push_back(!has_value(s.status) ? nan : selected[p] % 2 == 0 ? w.real() : w.imag());
    }
  }
}

}  // namespace

std::span<const Collection> collections() {
  static const std::array<Collection, 5> all{
      {{"currents",
        "Currents",
        "Eulerian current of the central forecast and its 10, 50 and 90 % quantiles, towards, by "
        "depth below mean sea level",
        {"current", "velocity", "depth", "forecast"},
        Vertical::depth_down},
       {"currents-members",
        "Currents, members",
        "Equally likely futures of the current; member 0 is the central one",
        {"current", "ensemble", "member"},
        Vertical::depth_down},
       {"wind",
        "Wind",
        "Mean wind, towards (components) and from (direction), by height above mean sea level, "
        "brought from 10 m by the neutral logarithmic profile",
        {"wind", "forecast"},
        Vertical::height_up},
       {"wind-members",
        "Wind, members",
        "The wind that drives each member of the current",
        {"wind", "ensemble", "member"},
        Vertical::height_up},
       {"waves",
        "Waves",
        "Significant height, peak period and the direction that waves come from",
        {"waves", "sea state", "forecast"},
        Vertical::none}}};
  return all;
}

const Collection& collection_named(const std::string& id) {
  std::string known;
  for (const Collection& collection : collections()) {
    if (collection.id == id) return collection;
    known += (known.empty() ? "" : ", ") + collection.id;
  }
  throw Error(ErrorKind::not_found,
              "found no collection of that name; there are " + known + " (see /collections)");
}

std::vector<Parameter> parameters_of(const Collection& collection, std::size_t members) {
  std::vector<Parameter> list;
  switch (kind_of(collection)) {
    case currents:
      add_components(list, "", east_current, north_current, "current", "central");
      list.push_back(speed("sea_water_speed", "sea_water_speed", "Current speed", "central"));
      list.push_back(direction("sea_water_velocity_to_direction", "Direction the current goes to"));
      for (const auto& [ending, method] :
           {std::pair{"p10", "quantile 0.1"}, {"p50", "quantile 0.5"}, {"p90", "quantile 0.9"}})
        add_components(list, ending, east_current, north_current, "current", method);
      break;
    case currents_members:
      return member_parameters(members, east_current, north_current, "current");
    case wind:
      add_components(list, "", "eastward_wind", "northward_wind", "wind", "central");
      list.push_back(speed("wind_speed", "wind_speed", "Wind speed", "central"));
      list.push_back(direction("wind_from_direction", "Direction the wind comes from"));
      break;
    case wind_members:
      return member_parameters(members, "eastward_wind", "northward_wind", "wind");
    case waves:
      list.push_back({"sea_surface_wave_significant_height", "sea_surface_wave_significant_height",
                      "Significant wave height", "Significant wave height, central forecast", "m",
                      "metre", "central"});
      list.push_back({"sea_surface_wave_period_at_variance_spectral_density_maximum",
                      "sea_surface_wave_period_at_variance_spectral_density_maximum", "Peak period",
                      "Period of the spectral peak, central forecast", "s", "second", "central"});
      list.push_back(direction("sea_surface_wave_from_direction", "Direction the waves come from"));
      break;
  }
  return list;
}

std::vector<double> native_levels(const Collection& collection, const Field& field) {
  if (collection.vertical == Vertical::depth_down) return field.snapshot().depth_m;
  if (collection.vertical == Vertical::height_up) return {10.0};
  return {};
}

std::vector<double> all_levels(const Collection& collection, const Field& field) {
  if (collection.vertical == Vertical::height_up)
    return {wind_heights_m.begin(), wind_heights_m.end()};
  return native_levels(collection, field);
}

std::pair<double, double> vertical_range(const Collection& collection, const Field& field) {
  if (collection.vertical == Vertical::height_up) return {lowest_wind_m, highest_wind_m};
  return {0.0, field.range().deepest_m};
}

void sample(const Collection& collection, const Field& field, std::span<const std::size_t> selected,
            std::span<const Place> places, std::vector<std::vector<double>>& values,
            Absences& absences) {
  values.resize(selected.size());
  switch (kind_of(collection)) {
    case currents: {
      std::vector<CurrentSample> samples(places.size());
      field.sample_current(places, samples);
      append(std::span<const CurrentSample>(samples), selected, current_value, values, absences);
      break;
    }
    case wind: {
      std::vector<WindSample> samples(places.size());
      field.sample_wind(places, samples);
      append(std::span<const WindSample>(samples), selected, wind_value, values, absences);
      break;
    }
    case waves: {
      std::vector<SeaSample> samples(places.size());
      field.sample_sea(places, samples);
      for (const SeaSample& s : samples) {
        const SeaState& sea = s.sea;
        if (has_value(s.status) && sea.significant_height_m > steepest_height_m(sea.peak_period_s))
          ++absences.too_steep;
      }
      append(std::span<const SeaSample>(samples), selected, sea_value, values, absences);
      break;
    }
    case currents_members:
      append_members<CurrentSample>(
          places, selected,
          [&](std::size_t member, std::span<CurrentSample> out) {
            field.sample_current(places, out, member);
          },
          values, absences);
      break;
    case wind_members:
      append_members<WindSample>(
          places, selected,
          [&](std::size_t member, std::span<WindSample> out) {
            field.sample_wind(places, out, member);
          },
          values, absences);
      break;
  }
}

}  // namespace slackwater::api::edr
