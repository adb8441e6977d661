#include <cmath>
#include <optional>

#include "api/made_up/synthetic/product_files.h"
#include "api/made_up/synthetic/product_grid.h"
#include "ingest/grib/grib_writer.h"

namespace slackwater::api {
namespace {

using ingest::GribField;

constexpr double step_deg = 0.1;

/// A regular axis on multiples of 0.1 degree that covers [low, high].
std::vector<double> covering_axis(double low_deg, double high_deg) {
  std::vector<double> axis;
  const auto first = std::lround(std::floor(low_deg / step_deg));
  const auto last = std::lround(std::ceil(high_deg / step_deg));
  for (auto i = first; i <= last; ++i)
    axis.push_back(static_cast<double>(i) / static_cast<double>(std::lround(1 / step_deg)));
  return axis;
}

/// Adds `10u` and `10v` of one run at one step.
void add_step(const SyntheticOcean& ocean, const WeatherForecast& run, UtcTime reference_time,
              int step_hours, std::vector<GribField>& fields) {
  const ProductAxes cover(ocean, {});
  GribField east{
      .short_name = "10u",
      .reference_time = reference_time,
      .step_hours = step_hours,
      .member = std::nullopt,
      .latitude_deg = covering_axis(cover.latitude_deg.front(), cover.latitude_deg.back()),
      .longitude_deg = covering_axis(cover.longitude_deg.front(), cover.longitude_deg.back()),
      .values = {}};
  GribField north = east;
  north.short_name = "10v";
  const double hours = ocean.hours_since_epoch(reference_time) + step_hours;
  for (const double latitude_deg : east.latitude_deg) {
    for (const double longitude_deg : east.longitude_deg) {
      const Horizontal wind =
          run.wind_m_s(ocean.plane(GeoPoint::from_degrees(latitude_deg, longitude_deg)), hours);
      east.values.push_back(wind.real());
      north.values.push_back(wind.imag());
    }
  }
  fields.push_back(std::move(east));
  fields.push_back(std::move(north));
}

}  // namespace

std::filesystem::path write_wind_analysis(const SyntheticOcean& ocean, UtcDay first, UtcDay last,
                                          const std::filesystem::path& folder) {
  // A run issued when all is over never leads: its error is that of an analysis, smooth from day to
  // day.
  const WeatherForecast analysis = ocean.weather_forecast(ocean.end());
  std::vector<GribField> fields;
  for (const UtcTime time : hourly_instants(first, last))
    add_step(ocean, analysis, time, 0, fields);
  auto path = product_path(folder, "nwp_wind_analysis", first, last, ".grib2");
  ingest::write_grib(path, fields, 2, true);
  return path;
}

std::filesystem::path write_wind_forecast(const SyntheticOcean& ocean, UtcTime issued, int hours,
                                          const std::filesystem::path& folder) {
  const WeatherForecast run = ocean.weather_forecast(issued);
  std::vector<GribField> fields;
  for (int step = 0; step <= hours; ++step) add_step(ocean, run, issued, step, fields);
  auto path = forecast_path(folder, "nwp_wind_forecast", issued, ".grib2");
  ingest::write_grib(path, fields, 2, true);
  return path;
}

}  // namespace slackwater::api
