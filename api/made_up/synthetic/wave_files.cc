#include <algorithm>
#include <cmath>
#include <optional>

#include "api/made_up/synthetic/product_file.h"
#include "api/made_up/synthetic/product_files.h"
#include "api/made_up/synthetic/product_grid.h"
#include "fields/base/constants.h"

namespace slackwater::api {
namespace {

using constants::nan;
constexpr const char* dataset = "cmems_mod_nws_wav_anfc_1.5km_PT1H-i";

ProductVariable packed(const char* name, const char* standard_name, const char* long_name,
                       const char* unit, double scale, double offset = 0) {
  return {.name = name,
          .standard_name = standard_name,
          .long_name = long_name,
          .unit = unit,
          .packed_scale = scale,
          .packed_offset = offset};
}

/// Relative errors of one wave-model run at one time: uniform over the small grid.
struct WaveError {
  double height = 0;  ///< relative
  double period = 0;  ///< relative
  double direction_deg = 0;
};

WaveError draw_error(Rng& rng, const RandomVectorField& growth, double hours, double lead_h) {
  const double lead_days = std::max(lead_h, 0.0) / 24;
  const Horizontal grown = lead_days * growth.at({}, hours);
  return {.height = std::max(-0.6, 0.03 * rng.normal() + 0.06 * grown.real()),
          .period = std::max(-0.4, 0.02 * rng.normal() + 0.03 * grown.real()),
          .direction_deg = 3 * rng.normal() + 5 * grown.imag()};
}

void write_waves(const SyntheticOcean& ocean, const std::vector<UtcTime>& times, UtcTime issued,
                 std::optional<UtcTime> reference_time, const SyntheticGrid& grid,
                 const std::filesystem::path& path) {
  const ProductAxes axes(ocean, grid);
  ProductFile file(
      path,
      {.time = times,
       .depth_m = {},
       .latitude_deg = axes.latitude_deg,
       .longitude_deg = axes.longitude_deg,
       .reference_time = reference_time,
       .title =
           "hourly instantaneous wave fields in the shape of NWSHELF_ANALYSISFORECAST_WAV_004_014",
       .source = "Slackwater synthetic ocean in the shape of WAVEWATCH III",
       .dataset_id = dataset,
       .variables = {packed("VHM0", "sea_surface_wave_significant_height",
                            "Spectral significant wave height (Hm0)", "m", 0.001),
                     packed("VTPK", "sea_surface_wave_period_at_variance_spectral_density_maximum",
                            "Wave period at spectral peak", "s", 0.001),
                     packed("VTM02",
                            "sea_surface_wave_mean_period_from_variance_spectral_density_second_"
                            "frequency_moment",
                            "Spectral moments (0,2) wave period (Tm02)", "s", 0.001),
                     packed("VMDR", "sea_surface_wave_from_direction",
                            "Mean wave direction from (Mdir)", "degree", 0.01, 180),
                     packed("VSDX", "sea_surface_wave_stokes_drift_x_velocity", "Stokes drift U",
                            "m s-1", 0.0001),
                     packed("VSDY", "sea_surface_wave_stokes_drift_y_velocity", "Stokes drift V",
                            "m s-1", 0.0001)}});
  Rng rng(ocean.settings().seed, "synthetic/waves/" + path.filename().string());
  const RandomVectorField growth(
      {.component_sigma_m_s = 1, .shortest_period_h = 10, .longest_period_h = 60},
      ocean.settings().seed, "synthetic/wave_forecast/" + format_utc(issued));
  std::vector<std::vector<double>> values(6, std::vector<double>(axes.cells()));
  for (std::size_t t = 0; t < times.size(); ++t) {
    const WaveError error =
        draw_error(rng, growth, ocean.hours_since_epoch(times[t]), hours_between(issued, times[t]));
    for (std::size_t cell = 0; cell < axes.cells(); ++cell) {
      const std::optional<SyntheticSea> sea = ocean.sea_truth(axes.point(cell), times[t]);
      if (!sea) {
        for (auto& row : values) row[cell] = nan;
        continue;
      }
      const double heading =
          std::remainder(sea->from_direction_deg + error.direction_deg - 180, 360.0) + 180;
      // Drift goes with the square of the height and turns with the waves.
      const Horizontal drift = sea->stokes_drift_m_s * (1 + error.height) * (1 + error.height) *
                               std::polar(1.0, -error.direction_deg * constants::pi / 180);
      values[0][cell] = sea->significant_height_m * (1 + error.height);
      values[1][cell] = sea->peak_period_s * (1 + error.period);
      values[2][cell] = sea->mean_period_tm02_s * (1 + error.period);
      values[3][cell] = heading;
      values[4][cell] = drift.real();
      values[5][cell] = drift.imag();
    }
    for (std::size_t v = 0; v < values.size(); ++v) file.write(v, t, values[v]);
  }
  file.finish();
}

}  // namespace

std::filesystem::path write_wave_product(const SyntheticOcean& ocean, UtcDay first, UtcDay last,
                                         const std::filesystem::path& folder,
                                         const SyntheticGrid& grid) {
  const std::vector<UtcTime> times = hourly_instants(first, last);
  auto path = product_path(folder, dataset, first, last, ".nc");
  write_waves(ocean, times, times.back(), std::nullopt, grid, path);
  return path;
}

std::filesystem::path write_wave_forecast(const SyntheticOcean& ocean, UtcTime issued, int hours,
                                          const std::filesystem::path& folder,
                                          const SyntheticGrid& grid) {
  auto path = forecast_path(folder, dataset, issued, ".nc");
  write_waves(ocean, hourly_instants(issued, hours), issued, issued, grid, path);
  return path;
}

}  // namespace slackwater::api
