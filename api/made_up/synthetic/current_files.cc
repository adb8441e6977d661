#include <cmath>

#include "api/made_up/synthetic/product_file.h"
#include "api/made_up/synthetic/product_files.h"
#include "api/made_up/synthetic/product_grid.h"
#include "fields/base/constants.h"

namespace slackwater::api {
namespace {

constexpr double white_noise_m_s = 0.004;
constexpr const char* physics_source = "Slackwater synthetic ocean in the shape of AMM15 (NEMO)";
constexpr const char* physics_title =
    "hourly instantaneous fields in the shape of NWSHELF_ANALYSISFORECAST_PHY_004_013";
using constants::nan;

/// How much of the model's error is left at a depth: all at the surface, 40 % at the bed.
double share_of_error(double depth_m, double water_depth_m) {
  return 1 - 0.6 * depth_m / water_depth_m;
}

/// `uo` and `vo` at the given times, as a model run issued at `issued` sees them.
void write_velocities(const SyntheticOcean& ocean, const std::vector<UtcTime>& times,
                      UtcTime issued, std::optional<UtcTime> reference_time,
                      const SyntheticGrid& grid, const std::filesystem::path& path) {
  const ProductAxes axes(ocean, grid);
  const std::vector<double>& levels = synthetic_levels_m();
  ProductFile file(path, {.time = times,
                          .depth_m = levels,
                          .latitude_deg = axes.latitude_deg,
                          .longitude_deg = axes.longitude_deg,
                          .reference_time = reference_time,
                          .title = physics_title,
                          .source = physics_source,
                          .dataset_id = "cmems_mod_nws_phy-cur_anfc_1.5km-3D_PT1H-i",
                          .variables = {{.name = "uo",
                                         .standard_name = "eastward_sea_water_velocity",
                                         .long_name = "Eastward velocity",
                                         .unit = "m s-1",
                                         .has_depth = true,
                                         .packed_scale = {}},
                                        {.name = "vo",
                                         .standard_name = "northward_sea_water_velocity",
                                         .long_name = "Northward velocity",
                                         .unit = "m s-1",
                                         .has_depth = true,
                                         .packed_scale = {}}}});
  const std::size_t cells = axes.cells();
  const OceanModelError error = ocean.model_error(issued);
  Rng white(ocean.settings().seed, "synthetic/white/" + path.filename().string());
  std::vector<CurrentSeries> series;
  std::vector<PlanePoint> places;
  std::vector<double> water_m;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    series.emplace_back(ocean, axes.point(cell), levels);
    places.push_back(ocean.plane(axes.point(cell)));
    water_m.push_back(ocean.water_depth_m(axes.point(cell)));
  }
  std::vector<double> east(levels.size() * cells);
  std::vector<double> north(levels.size() * cells);
  std::vector<Horizontal> profile(levels.size());
  for (std::size_t t = 0; t < times.size(); ++t) {
    for (std::size_t cell = 0; cell < cells; ++cell) {
      series[cell].at(times[t], profile);
      const Horizontal off = error.at(places[cell], times[t]);
      for (std::size_t k = 0; k < levels.size(); ++k) {
        const Horizontal noise = white_noise_m_s * Horizontal{white.normal(), white.normal()};
        const Horizontal seen = profile[k] + share_of_error(levels[k], water_m[cell]) * off + noise;
        east[k * cells + cell] = seen.real();
        north[k * cells + cell] = seen.imag();
      }
    }
    file.write(0, t, east);
    file.write(1, t, north);
  }
  file.finish();
}

/// A packed product of one variable whose values `value(cell, level, time)` gives; NaN where there
/// is none.
template <typename Value>
void write_scalar(const SyntheticOcean& ocean, const std::vector<UtcTime>& times,
                  const SyntheticGrid& grid, const std::filesystem::path& path,
                  const std::string& dataset, const ProductVariable& variable, const Value& value) {
  const ProductAxes axes(ocean, grid);
  const std::vector<double> levels =
      variable.has_depth ? synthetic_levels_m() : std::vector<double>{};
  ProductFile file(path, {.time = times,
                          .depth_m = levels,
                          .latitude_deg = axes.latitude_deg,
                          .longitude_deg = axes.longitude_deg,
                          .reference_time = {},
                          .title = physics_title,
                          .source = physics_source,
                          .dataset_id = dataset,
                          .variables = {variable}});
  const std::size_t level_count = levels.empty() ? 1 : levels.size();
  const std::size_t cells = axes.cells();
  std::vector<double> values(level_count * cells);
  for (std::size_t t = 0; t < times.size(); ++t) {
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const GeoPoint point = axes.point(cell);
      const bool land = ocean.is_land(point);
      const double bed_m = ocean.water_depth_m(point);
      for (std::size_t k = 0; k < level_count; ++k) {
        const double depth_m = levels.empty() ? 0 : levels[k];
        values[k * cells + cell] = land || depth_m > bed_m ? nan : value(point, depth_m, times[t]);
      }
    }
    file.write(0, t, values);
  }
  file.finish();
}

}  // namespace

std::vector<std::filesystem::path> write_current_product(const SyntheticOcean& ocean, UtcDay first,
                                                         UtcDay last,
                                                         const std::filesystem::path& folder,
                                                         const SyntheticGrid& grid) {
  const std::vector<UtcTime> times = hourly_instants(first, last);
  std::vector<std::filesystem::path> files;
  const auto path_of = [&](const std::string& dataset) {
    return files.emplace_back(product_path(folder, dataset, first, last, ".nc"));
  };
  write_velocities(ocean, times, times.back(), std::nullopt, grid,
                   path_of("cmems_mod_nws_phy-cur_anfc_1.5km-3D_PT1H-i"));
  const std::string temperature = "cmems_mod_nws_phy-tem_anfc_1.5km-3D_PT1H-i";
  write_scalar(ocean, times, grid, path_of(temperature), temperature,
               {.name = "thetao",
                .standard_name = "sea_water_potential_temperature",
                .long_name = "Temperature",
                .unit = "degrees_C",
                .has_depth = true,
                .packed_scale = 0.001},
               [&](const GeoPoint& point, double depth_m, UtcTime time) {
                 // Nearly mixed, as tidal water is in March; the sun warms the top by a tenth of a
                 // degree.
                 const double sun =
                     std::sin(2 * constants::pi * (ocean.hours_since_epoch(time) - 9) / 24);
                 return 9.6 + 2e-5 * ocean.plane(point).north_m +
                        (0.1 + 0.05 * sun) * std::exp(-depth_m / 8);
               });
  const std::string mixed = "cmems_mod_nws_phy-mld_anfc_1.5km-2D_PT1H-i";
  write_scalar(ocean, times, grid, path_of(mixed), mixed,
               {.name = "mlotst",
                .standard_name = "ocean_mixed_layer_thickness_defined_by_sigma_theta",
                .long_name = "Mixed layer depth",
                .unit = "m",
                .packed_scale = 0.01},
               [&](const GeoPoint& point, double, UtcTime) { return ocean.water_depth_m(point); });
  const std::string level = "cmems_mod_nws_phy-ssh_anfc_1.5km-2D_PT1H-i";
  write_scalar(ocean, times, grid, path_of(level), level,
               {.name = "zos",
                .standard_name = "sea_surface_height_above_geoid",
                .long_name = "Sea surface height",
                .unit = "m",
                .packed_scale = 0.001},
               [&](const GeoPoint& point, double, UtcTime time) {
                 return ocean.elevation_truth_m(point, time).value_or(nan);
               });
  return files;
}

std::filesystem::path write_current_forecast(const SyntheticOcean& ocean, UtcTime issued, int hours,
                                             const std::filesystem::path& folder,
                                             const SyntheticGrid& grid) {
  auto path = forecast_path(folder, "cmems_mod_nws_phy-cur_anfc_1.5km-3D_PT1H-i", issued, ".nc");
  write_velocities(ocean, hourly_instants(issued, hours), issued, issued, grid, path);
  return path;
}

std::filesystem::path write_bathymetry(const SyntheticOcean& ocean,
                                       const std::filesystem::path& folder,
                                       const SyntheticGrid& grid) {
  const ProductAxes axes(ocean, grid);
  const std::vector<double>& levels = synthetic_levels_m();
  std::filesystem::create_directories(folder);
  auto path = folder / "cmems_mod_nws_phy_anfc_1.5km_static_bathy.nc";
  ProductFile file(path,
                   {.time = {},
                    .depth_m = levels,
                    .latitude_deg = axes.latitude_deg,
                    .longitude_deg = axes.longitude_deg,
                    .reference_time = {},
                    .title = "static fields in the shape of NWSHELF_ANALYSISFORECAST_PHY_004_013",
                    .source = physics_source,
                    .dataset_id = "cmems_mod_nws_phy_anfc_1.5km_static",
                    .variables = {{.name = "deptho",
                                   .standard_name = "sea_floor_depth_below_geoid",
                                   .long_name = "Bathymetry",
                                   .unit = "m",
                                   .packed_scale = {}},
                                  {.name = "mask",
                                   .standard_name = "sea_binary_mask",
                                   .long_name = "Land-sea mask: 1 = sea, 0 = land",
                                   .unit = "1",
                                   .has_depth = true,
                                   .packed_scale = 1.0}}});
  std::vector<double> depth;
  std::vector<double> mask(levels.size() * axes.cells());
  for (std::size_t cell = 0; cell < axes.cells(); ++cell) {
    const GeoPoint point = axes.point(cell);
    const bool land = ocean.is_land(point);
    const double bed_m = ocean.water_depth_m(point);
    depth.push_back(land ? nan : bed_m);
    for (std::size_t k = 0; k < levels.size(); ++k) {
      mask[k * axes.cells() + cell] = !land && levels[k] <= bed_m ? 1 : 0;
    }
  }
  file.write(0, 0, depth);
  file.write(1, 0, mask);
  file.finish();
  return path;
}

}  // namespace slackwater::api
