#pragma once
#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "fields/base/time.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// What the name of a dataset of Copernicus Marine says of its times: "…_PT1H-m" are hourly means,
/// "…_PT15M-i" instants a quarter of an hour apart, "…_P1M-m" means of calendar months.
struct DatasetPeriod {
  bool is_mean = false;
  Duration step{};        ///< of a mean; of a month: nothing
  bool is_month = false;  ///< a calendar month
};

/// Reads it from a name, e.g. "cmems_mod_ibi_phy_anfc_0.027deg-3D_PT1H-m"; nothing where it does
/// not say so. Source: Copernicus Marine, nomenclature of datasets (periods by ISO 8601).
[[nodiscard]] std::optional<DatasetPeriod> period_in(std::string_view text);

/// From the global attributes of a file, which subset services fill: the first that names one.
[[nodiscard]] std::optional<DatasetPeriod> stated_period(const netcdf::File& file);

}  // namespace slackwater::ingest
