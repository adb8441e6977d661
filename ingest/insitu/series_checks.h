#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "ingest/insitu/series_values.h"

namespace slackwater::ingest {

/// Runs the tests of ingest/quality on the series of one granule, in the order range, spike,
/// ensemble, and says in words how much each rejected. The eastward and northward components of a
/// vector are tested together.
void check_series(const std::vector<UtcTime>& times, std::vector<SeriesValues*>& series,
                  std::vector<std::string>& warnings);

}  // namespace slackwater::ingest
