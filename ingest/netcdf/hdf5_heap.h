#pragma once
#include <filesystem>

namespace slackwater::ingest::netcdf {

/// Refuses a netCDF-4 (HDF5) file whose global heaps are damaged: HDF5 1.10 walks such a heap
/// forever or copies beyond it. Names of dimensions and text attributes lie there, so every file is
/// read through them.
///
/// Files above 512 MiB are not searched: reading them twice would cost more than the guard is
/// worth. Throws Error(invalid_input). Cost: one pass over the file. Source: HDF5 File Format
/// Specification 3.0, section III.E (global heap).
void expect_sound_global_heaps(const std::filesystem::path& path);

}  // namespace slackwater::ingest::netcdf
