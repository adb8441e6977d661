#pragma once
#include <filesystem>

namespace slackwater::ingest::netcdf {

/// Refuses a netCDF classic file (CDF-1, CDF-2, CDF-5) that ends before the last value its header
/// announces.
///
/// The NetCDF library reads zeros past the end of such a file, and a truncated current must not
/// become calm water. The header is parsed here because the library does not tell where a
/// variable's data begin. Throws Error(invalid_input) with the sizes found and expected. Source:
/// NetCDF classic format specification, NetCDF User's Guide, appendix "File Format Specifications".
void expect_classic_file_is_whole(const std::filesystem::path& path);

}  // namespace slackwater::ingest::netcdf
