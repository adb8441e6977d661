#pragma once
#include <string>
#include <vector>

#include "fields/base/time.h"

namespace slackwater {

/// One quantity at one place over the past, as a file or a store gave it.
struct HistorySeries {
  std::string name;           ///< what its source calls it: a column, a variable
  std::string standard_name;  ///< CF
  std::string unit;           ///< of the values, as UDUNITS reads it
  std::string source;         ///< the file, or the product, for messages
  std::vector<UtcTime> time;  ///< strictly ascending; a value holds from its time on
  std::vector<double> value;  ///< one a time, NaN where it is missing
  /// The source keeps single precision: a bound that a value is held against is to be rounded
  /// likewise, or 1.2 m would exceed a limit of 1.2 m.
  bool is_single_precision = false;
};

}  // namespace slackwater
