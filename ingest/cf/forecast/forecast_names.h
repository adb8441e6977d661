#pragma once

/// Names and constants that the writer and the reader of forecast files share.
namespace slackwater::ingest::forecast_names {

inline constexpr double fill = 9.969209968386869e+36;  // NC_FILL_DOUBLE
inline constexpr auto member_fill = static_cast<float>(fill);
inline constexpr const char* east = "eastward_sea_water_velocity";
inline constexpr const char* north = "northward_sea_water_velocity";
inline constexpr const char* sigma = "sea_water_velocity_component_standard_deviation";
inline constexpr const char* status = "sea_water_velocity_status";
inline constexpr const char* wave_height = "sea_surface_wave_significant_height";
inline constexpr const char* wave_period =
    "sea_surface_wave_period_at_variance_spectral_density_maximum";
inline constexpr const char* wave_direction = "sea_surface_wave_from_direction";
inline constexpr const char* wave_height_spread = "sea_surface_wave_significant_height_spread";
inline constexpr const char* sea_level = "sea_surface_height_above_geoid";
inline constexpr const char* sea_level_sigma = "sea_surface_height_standard_deviation";
inline constexpr const char* sea_level_source = "sea_surface_height_source";
inline constexpr const char* wind_member = "wind_member";
inline constexpr const char* wind_ensemble = "slackwater_wind_ensemble";

}  // namespace slackwater::ingest::forecast_names
