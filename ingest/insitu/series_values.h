#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fields/grid/status.h"
#include "ingest/copernicus/product_catalogue.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// The values of one quantity at one station, time by level, with what is known about each.
struct SeriesValues {
  std::string standard_name;
  std::string unit;
  std::string source_name;  ///< "UCUR", or "HCSP, HCDT" for a speed and its direction
  Realm realm = Realm::surface;
  Range gross;
  std::optional<double> spike;
  const netcdf::Variable* variable = nullptr;  ///< where axes and attributes are looked up
  std::optional<double> standard_error;        ///< stated by the file, in `unit`
  std::size_t times = 0;
  std::size_t levels = 1;
  std::vector<float> values;  ///< row-major (time, level), canonical unit, NaN where there is none
  std::vector<SampleStatus> status;

  [[nodiscard]] std::size_t at(std::size_t t, std::size_t k) const noexcept {
    return t * levels + k;
  }
};

/// Which dimension of a variable is which, by position in its shape.
struct SeriesDimensions {
  std::optional<std::size_t> time;
  std::optional<std::size_t> level;
  std::optional<std::size_t> station;
};

/// Sorts the dimensions of a variable: the one of time, the one of stations (may be empty), and at
/// most one other that is longer than 1, the levels. A lone other dimension counts as levels though
/// its length is 1. Throws Error(invalid_input) for a second long dimension.
[[nodiscard]] SeriesDimensions dimensions_of(const netcdf::Variable& variable,
                                             std::string_view time_dimension,
                                             std::string_view station_dimension);

/// Reads a variable at one station with the status that its quality flags give: values that are
/// there without a flag are not_checked; without a value, missing, and so is what looks like a
/// number for "not measured" (ingest/quality/sentinel.h); what the provider calls bad, suspect.
/// `unit` is the canonical one. The quality flags are the variable among `ancillary_variables` that
/// is one, else NAME_QC, NAME_quality_control, NAME_qc.
[[nodiscard]] SeriesValues read_series(const netcdf::File& file, const netcdf::Variable& variable,
                                       const SeriesDimensions& dimensions, std::size_t station,
                                       const std::string& unit, std::vector<std::string>& warnings);

/// Only the status that the flags of a variable give (also for TIME and POSITION); not_checked
/// where it has none.
[[nodiscard]] std::vector<SampleStatus> flags_of(const netcdf::File& file,
                                                 const netcdf::Variable& flags);
[[nodiscard]] const netcdf::Variable* flag_variable_of(const netcdf::File& file,
                                                       const netcdf::Variable& variable);

}  // namespace slackwater::ingest
