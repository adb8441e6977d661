#pragma once
#include <vector>

#include "api/made_up/synthetic/product_files.h"
#include "fields/geo/geo_point.h"

namespace slackwater::api {

/// The axes of a `SyntheticGrid` around an ocean's site.
struct ProductAxes {
  std::vector<double> latitude_deg;
  std::vector<double> longitude_deg;

  ProductAxes(const SyntheticOcean& ocean, const SyntheticGrid& grid);
  [[nodiscard]] std::size_t cells() const noexcept {
    return latitude_deg.size() * longitude_deg.size();
  }
  /// Centre of the cell, longitude fastest.
  [[nodiscard]] GeoPoint point(std::size_t cell) const {
    return GeoPoint::from_degrees(latitude_deg[cell / longitude_deg.size()],
                                  longitude_deg[cell % longitude_deg.size()]);
  }
};

/// The hourly instants of the days [first, last].
[[nodiscard]] std::vector<UtcTime> hourly_instants(UtcDay first, UtcDay last);
/// The hourly instants from `start` to `start + hours`, both included.
[[nodiscard]] std::vector<UtcTime> hourly_instants(UtcTime start, int hours);
/// FOLDER/DATASET_FIRST.nc, or DATASET_FIRST_LAST.nc where they differ; makes the folder.
[[nodiscard]] std::filesystem::path product_path(const std::filesystem::path& folder,
                                                 const std::string& dataset, UtcDay first,
                                                 UtcDay last, const std::string& extension);
/// FOLDER/DATASET_fc20250303T000000Z.nc.
[[nodiscard]] std::filesystem::path forecast_path(const std::filesystem::path& folder,
                                                  const std::string& dataset, UtcTime issued,
                                                  const std::string& extension);

}  // namespace slackwater::api
