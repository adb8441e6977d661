#include "api/pipeline/load_site_data.h"

#include "api/pipeline/stored_pieces.h"
#include "fields/base/error.h"

namespace slackwater::api {
namespace {

/// Cells up to this far from a column take part in its interpolation: more than the coarsest wind
/// grid's step.
constexpr double margin_deg = 0.3;

}  // namespace

SiteData load_site_data(store::Store& store, const Site& site, UtcTime from, UtcTime to) {
  SitePieces pieces;
  const Window window{from, to, site.box(margin_deg)};
  pieces.current = read_vector_pieces(store, "eastward_sea_water_velocity",
                                      "northward_sea_water_velocity", window);
  pieces.wind = read_vector_pieces(store, "eastward_wind", "northward_wind", window);
  const auto read_scalar = [&](const char* name) {
    return std::move(read_scalar_pieces(store, {name}, window).front());
  };
  pieces.mixed_layer_depth = read_scalar("ocean_mixed_layer_thickness_defined_by_sigma_theta");
  if (pieces.mixed_layer_depth.empty())
    pieces.temperature = read_scalar("sea_water_potential_temperature");
  auto waves = read_scalar_pieces(store,
                                  {"sea_surface_wave_significant_height",
                                   "sea_surface_wave_period_at_variance_spectral_density_maximum",
                                   "sea_surface_wave_from_direction"},
                                  window);
  pieces.significant_height = std::move(waves[0]);
  pieces.peak_period = std::move(waves[1]);
  pieces.wave_direction = std::move(waves[2]);
  pieces.water_depth = std::move(read_scalar_pieces(store, {"sea_floor_depth_below_geoid"},
                                                    {std::nullopt, std::nullopt, window.box})[0]);

  SiteData data = site_data_of(site, std::move(pieces));
  if (data.is_empty()) {
    throw Error(ErrorKind::not_found,
                "the store holds nothing for site " + site.id + " at " + position_text(site.point) +
                    " from " + format_utc(from) + " to " + format_utc(to) +
                    "; ingest product files first (`forecast --print-downloads` shows which)");
  }
  return data;
}

}  // namespace slackwater::api
