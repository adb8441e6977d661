#include "ingest/grib/parameter.h"

#include <array>

namespace slackwater::ingest::grib {
namespace {

constexpr double own_level = -1.0;
constexpr double no_height = 0.0;

/// Parameter numbers and meanings: ECMWF parameter database
/// (https://codes.ecmwf.int/grib/param-db), which gives the GRIB 1 and GRIB 2 coding of each.
/// ECMWF's mean wave period 140232 is the one of the moment m_-1 (IFS documentation, part VII, ch.
/// 10); 140231 is the period of the one-dimensional spectrum's peak.
constexpr std::array parameters{
    Parameter{165, "10u", "eastward_wind", "m s-1", 10},
    Parameter{166, "10v", "northward_wind", "m s-1", 10},
    Parameter{228246, "100u", "eastward_wind", "m s-1", 100},
    Parameter{228247, "100v", "northward_wind", "m s-1", 100},
    Parameter{228239, "200u", "eastward_wind", "m s-1", 200},
    Parameter{228240, "200v", "northward_wind", "m s-1", 200},
    Parameter{131, "u", "eastward_wind", "m s-1", own_level},
    Parameter{132, "v", "northward_wind", "m s-1", own_level},
    Parameter{49, "10fg", "wind_speed_of_gust", "m s-1", 10},
    Parameter{228028, "10fg3", "wind_speed_of_gust", "m s-1", 10},
    Parameter{228029, "i10fg", "wind_speed_of_gust", "m s-1", 10},
    Parameter{260065, "gust", "wind_speed_of_gust", "m s-1", 10},
    Parameter{140229, "swh", "sea_surface_wave_significant_height", "m", no_height},
    Parameter{140230, "mwd", "sea_surface_wave_from_direction", "degree", no_height},
    Parameter{140231, "pp1d", "sea_surface_wave_period_at_variance_spectral_density_maximum", "s",
              no_height},
    Parameter{
        140232, "mwp",
        "sea_surface_wave_mean_period_from_variance_spectral_density_inverse_frequency_moment", "s",
        no_height},
    // NCEP's waves (GFS): "primary" is what WAVEWATCH III calls the peak, its fields FP and DP
    // (ww3_grib of NOAA-EMC/WW3), though the table of WMO says "mean" of the period.
    Parameter{260233, "dirpw",
              "sea_surface_wave_from_direction_at_variance_spectral_density_maximum", "degree",
              no_height},
    Parameter{260234, "perpw", "sea_surface_wave_period_at_variance_spectral_density_maximum", "s",
              no_height},
};

/// WMO code table 4.2, discipline 0 (meteorological), category 2 (momentum): how every centre codes
/// wind in GRIB 2, also where ecCodes has no short name for the combination with its statistics.
const Parameter* by_wmo_code(const Message& message) {
  if (message.integer_if_any("edition") != 2 || message.integer_if_any("discipline") != 0 ||
      message.integer_if_any("parameterCategory") != 2) {
    return nullptr;
  }
  switch (message.integer_if_any("parameterNumber").value_or(-1)) {
    case 2:
      return parameter_of("u");
    case 3:
      return parameter_of("v");
    case 22:
      return parameter_of("gust");
    default:
      return nullptr;
  }
}

}  // namespace

const Parameter* parameter_of(std::string_view short_name) noexcept {
  for (const Parameter& parameter : parameters) {
    if (parameter.short_name == short_name) return &parameter;
  }
  return nullptr;
}

std::string known_parameters() {
  std::string names;
  for (const Parameter& parameter : parameters) {
    names += (names.empty() ? "" : ", ") + std::string(parameter.short_name);
  }
  return names;
}

std::optional<Identified> identify(const Message& message) {
  const Parameter* parameter = nullptr;
  const long id = message.integer_if_any("paramId").value_or(0);
  for (const Parameter& candidate : parameters) {
    if (candidate.param_id == id) parameter = &candidate;
  }
  if (parameter == nullptr) parameter = by_wmo_code(message);
  if (parameter == nullptr) return std::nullopt;

  const std::string level_type = message.text_if_any("typeOfLevel").value_or("unknown");
  const bool at_height = level_type == "heightAboveGround" || level_type == "heightAboveSea";
  if (parameter->height_m == own_level) {
    if (!at_height) return std::nullopt;
    return Identified{parameter, message.real("level")};
  }
  if (!at_height && level_type != "surface" && level_type != "meanSea") return std::nullopt;
  if (parameter->height_m == no_height) return Identified{parameter, std::nullopt};
  return Identified{parameter, parameter->height_m};
}

}  // namespace slackwater::ingest::grib
