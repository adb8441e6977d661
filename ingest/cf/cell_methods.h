#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/copernicus/vocabulary.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// One entry of `cell_methods`: "time: mean within days" says of axis "time" the method "mean".
struct CellMethod {
  std::vector<std::string> axes;  ///< as written, lower case
  std::string method;             ///< first word, lower case; "average" and the like are "mean"
  bool is_climatology = false;    ///< "within days", "over years": of many intervals
};

/// The entries of a text, comments in brackets left out; whatever the blanks and the letter case.
/// Source: CF conventions 1.11, section 7.3 and appendix E.
[[nodiscard]] std::vector<CellMethod> cell_methods_of(std::string_view text);

/// Whether an axis, by any of these names, has this method.
[[nodiscard]] bool has_method(const std::vector<CellMethod>& methods,
                              const std::vector<std::string>& axes, std::string_view method);

/// Whether a variable is the mean over the members of an ensemble.
[[nodiscard]] bool is_mean_of_members(const netcdf::Variable& variable);

/// Why a variable is a statistic, not the quantity that its standard name or short name says:
/// "maximum over time (cell_methods 'time: maximum')"; nothing where it is the quantity or a mean
/// of it. Heard are cell_methods, modifiers of the standard name, what GRIB converters write
/// (GRIB_dataType, GRIB_stepType), and names that say so: "uo_std", "ensemble spread of ...". What
/// is a maximum by its nature (gusts, the highest wave) may be one over time.
[[nodiscard]] std::optional<std::string> statistic_in(const netcdf::Variable& variable,
                                                      const Quantity& quantity);

}  // namespace slackwater::ingest
