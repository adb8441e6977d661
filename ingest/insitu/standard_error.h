#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ingest/insitu/station.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// The standard error that a file states of a variable, in `unit`: the median of the one among its
/// `ancillary_variables` whose standard name is that of the variable with the modifier
/// `standard_error` (CF conventions, section 3.4 and appendix C). Nothing where the file states
/// none, or none above zero; one that cannot be read is a warning.
[[nodiscard]] std::optional<double> standard_error_of(const netcdf::File& file,
                                                      const netcdf::Variable& variable,
                                                      const StationAxes& axes, std::size_t station,
                                                      const std::string& unit,
                                                      std::vector<std::string>& warnings);

}  // namespace slackwater::ingest
