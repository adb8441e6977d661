#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fields/base/time.h"

namespace slackwater::ingest {

/// One field to be coded as a GRIB message, as a weather centre would: rows from north to south,
/// longitudes from 0 to 360.
struct GribField {
  std::string short_name;    ///< "10u", "10v", "100u", "i10fg", "swh" ... (ingest/grib/parameter.h)
  UtcTime reference_time{};  ///< run; whole minutes
  int step_hours = 0;
  std::optional<int> member;          ///< perturbation number; nothing for a deterministic run
  std::vector<double> latitude_deg;   ///< ascending, evenly spaced
  std::vector<double> longitude_deg;  ///< ascending, evenly spaced, may run past 180
  std::vector<double> values;  ///< row-major, latitude ascending, longitude fastest; NaN is masked
};

/// Writes the fields as messages of GRIB edition 1 or 2, packed in 24 bits a value, simply or
/// (edition 2 only) by CCSDS lossless compression; the packing error is at most 2^-24 of a field's
/// range. Throws Error(invalid_input) for what GRIB cannot say, Error(unavailable) where the file
/// cannot be written.
void write_grib(const std::filesystem::path& file, std::span<const GribField> fields, int edition,
                bool ccsds);

}  // namespace slackwater::ingest
