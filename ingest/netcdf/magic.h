#pragma once
#include <filesystem>

namespace slackwater::ingest::netcdf {

/// Classic NetCDF begins with "CDF", netCDF-4 as HDF5 does.
[[nodiscard]] bool begins_as_netcdf(const std::filesystem::path& file);

}  // namespace slackwater::ingest::netcdf
