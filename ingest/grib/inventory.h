#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "fields/geo/geo_point.h"
#include "ingest/grib/message_file.h"
#include "ingest/grib/parameter.h"
#include "ingest/grib/regular_grid.h"

namespace slackwater::ingest::grib {

/// One wanted field of a file, without its values.
struct FieldEntry {
  FieldPosition position;
  const Parameter* parameter = nullptr;
  std::optional<double> height_m;
  UtcTime run{};              ///< reference time
  TimeCell cell;              ///< valid time
  std::optional<int> member;  ///< perturbation number of an ensemble
  bool is_ensemble_mean = false;
  std::size_t grid = 0;  ///< index into Inventory::grids
  std::string centre;    ///< e.g. "ecmf"
};

/// What a file holds of what we keep, after one walk through its headers.
struct Inventory {
  std::vector<FieldEntry> fields;
  std::vector<RegularGrid> grids;
  std::vector<std::string> warnings;
};

/// Walks the file once. `on_bytes` hears the offset that was reached.
/// Statistics of a quantity (`statistic_of`) are left out, counted by name in a warning.
/// Throws Error(invalid_input) for a damaged file, a grid that is not regular, or a file without
/// wanted fields, which it names.
[[nodiscard]] Inventory take_inventory(MessageFile& file, const std::optional<BoundingBox>& cut,
                                       const std::function<void(std::uint64_t)>& on_bytes);

/// When a field is valid: an instant; the mean over an interval of steps; and for a gust, which is
/// the maximum over an interval, the instant at its end, as the centres stamp it. Nothing for other
/// statistics.
[[nodiscard]] std::optional<TimeCell> valid_time_of(Message& message, const Parameter& parameter);

}  // namespace slackwater::ingest::grib
