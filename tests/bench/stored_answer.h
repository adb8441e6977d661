#pragma once
#include <filesystem>
#include <string>

#include "tests/bench/big_product_file.h"

namespace slackwater::bench {

/// Whether a store holds what it was given.
struct StoredAnswer {
  bool right = false;
  std::string found;  ///< how much was compared, or the first difference
};

/// Reads seeded random lines of every stored granule back and compares each value, to the bit, with
/// the one that the file's indices determine.
[[nodiscard]] StoredAnswer compare_with(const std::filesystem::path& store,
                                        const BigProductFile& file);

/// Reads the stored granules back whole and compares each value, to the bit, with the float
/// variables `uo` and `vo` of a NetCDF product in ascending order.
[[nodiscard]] StoredAnswer compare_with_netcdf(const std::filesystem::path& store,
                                               const std::filesystem::path& product);

}  // namespace slackwater::bench
