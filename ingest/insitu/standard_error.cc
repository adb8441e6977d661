#include "ingest/insitu/standard_error.h"

#include <sstream>

#include "fields/base/error.h"
#include "fields/base/numbers/statistics.h"
#include "ingest/insitu/series_values.h"

namespace slackwater::ingest {
namespace {

bool is_error_of(const netcdf::Variable& candidate, const netcdf::Variable& variable) {
  std::istringstream words(candidate.text("standard_name").value_or(""));
  std::string name;
  std::string modifier;
  words >> name >> modifier;
  return modifier == "standard_error" &&
         name == variable.text("standard_name").value_or(variable.name);
}

}  // namespace

std::optional<double> standard_error_of(const netcdf::File& file, const netcdf::Variable& variable,
                                        const StationAxes& axes, std::size_t station,
                                        const std::string& unit,
                                        std::vector<std::string>& warnings) {
  std::istringstream names(variable.text("ancillary_variables").value_or(""));
  for (std::string name; names >> name;) {
    const netcdf::Variable* error = file.find(name);
    if (error == nullptr || !is_error_of(*error, variable)) continue;
    try {
      const SeriesValues series = read_series(
          file, *error, dimensions_of(*error, axes.time_dimension, axes.station_dimension), station,
          unit, warnings);
      std::vector<double> stated;
      for (const float value : series.values)
        if (value > 0) stated.push_back(static_cast<double>(value));
      if (!stated.empty()) return median(std::move(stated));
    } catch (const Error& problem) {
      warnings.push_back("the standard error '" + name + "' is passed over: " + problem.what());
    }
  }
  return std::nullopt;
}

}  // namespace slackwater::ingest
