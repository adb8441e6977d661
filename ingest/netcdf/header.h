#pragma once
#include <filesystem>
#include <vector>

#include "ingest/netcdf/file.h"

namespace slackwater::ingest::netcdf {

/// What the header of an open file says, read with bounds that a sound product file never meets.
/// `file` is the library's handle, `variable` its number (or that of the global attributes), `path`
/// is for messages. Each throws Error(invalid_input) with the library's own text, or where a bound
/// is passed.
[[nodiscard]] std::vector<Dimension> read_dimensions(int file, const std::filesystem::path& path);
[[nodiscard]] std::vector<Attribute> read_attributes(int file, int variable, int count,
                                                     const std::filesystem::path& path);
[[nodiscard]] Variable read_variable(int file, int id, const std::filesystem::path& path);

}  // namespace slackwater::ingest::netcdf
