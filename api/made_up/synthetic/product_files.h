#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "api/made_up/synthetic/synthetic_ocean.h"
#include "fields/base/time.h"

namespace slackwater::api {

/// The grid of the synthetic products: cells of the North-West Shelf model (1/33 by 1/74 degree),
/// the site in the middle of a cell.
struct SyntheticGrid {
  std::size_t rows = 24;
  std::size_t columns = 24;
};

/// Native levels of the North-West Shelf model down to 75 m.
[[nodiscard]] const std::vector<double>& synthetic_levels_m();

/// Currents (`uo`, `vo`: float, hourly instants 00:00 to 23:00 of each day) and beside them
/// `thetao`, `mlotst` and `zos` (packed), one file per dataset as the provider cuts them, for the
/// days [first, last]. The values are the truth plus the model's analysis error and 4 mm/s of white
/// noise.
///
/// Writes FOLDER/cmems_mod_nws_phy-cur_anfc_1.5km-3D_PT1H-i_FIRST_LAST.nc and its three companions
/// (FIRST alone for a single day). @return the files; errors are those of the NetCDF writer.
std::vector<std::filesystem::path> write_current_product(const SyntheticOcean& ocean, UtcDay first,
                                                         UtcDay last,
                                                         const std::filesystem::path& folder,
                                                         const SyntheticGrid& grid = {});

/// The provider's own forecast of `uo`, `vo` issued at `issued`, hourly from the issue time for
/// `hours`, with an error that grows with lead. The file carries `forecast_reference_time`.
std::filesystem::path write_current_forecast(const SyntheticOcean& ocean, UtcTime issued, int hours,
                                             const std::filesystem::path& folder,
                                             const SyntheticGrid& grid = {});

/// Waves (`VHM0 VTPK VTM02 VMDR VSDX VSDY`, packed shorts, hourly instants) as analysed over the
/// days [first, last]: the truth with 3 % of noise in height, 2 % in period and 3 degrees in
/// direction.
std::filesystem::path write_wave_product(const SyntheticOcean& ocean, UtcDay first, UtcDay last,
                                         const std::filesystem::path& folder,
                                         const SyntheticGrid& grid = {});

/// Waves as forecast at `issued` for `hours`: the same with a height error that grows by 6 % a day
/// of lead and a direction error of 5 degrees a day. The file carries `forecast_reference_time`.
std::filesystem::path write_wave_forecast(const SyntheticOcean& ocean, UtcTime issued, int hours,
                                          const std::filesystem::path& folder,
                                          const SyntheticGrid& grid = {});

/// `deptho` and `mask(depth, latitude, longitude)` (1 wet, 0 land or bed), static.
std::filesystem::path write_bathymetry(const SyntheticOcean& ocean,
                                       const std::filesystem::path& folder,
                                       const SyntheticGrid& grid = {});

/// Analysed 10 m wind (`10u`, `10v`, GRIB 2, CCSDS packing), hourly, 00:00 to 23:00 of each day in
/// [first, last]. The grid is regular, 0.1 degree, and covers the product grid.
std::filesystem::path write_wind_analysis(const SyntheticOcean& ocean, UtcDay first, UtcDay last,
                                          const std::filesystem::path& folder);

/// One weather-model run issued at `issued`: steps 0 to `hours`, hourly, with its error.
std::filesystem::path write_wind_forecast(const SyntheticOcean& ocean, UtcTime issued, int hours,
                                          const std::filesystem::path& folder);

/// FOLDER/synthetic.yaml: the site with its name, place and water depth, a made-up farm of two
/// turbines and the tasks that are done there.
/// @param more  lines of YAML beside these
std::filesystem::path write_site_yaml(const SyntheticOcean& ocean,
                                      const std::filesystem::path& folder,
                                      const std::string& more = {});

}  // namespace slackwater::api
