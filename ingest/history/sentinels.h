#pragma once
#include <span>
#include <string>
#include <vector>

#include "fields/record/history_series.h"

namespace slackwater::ingest {

/// Makes every value that is exactly one of `missing` missing.
/// @param who  whose word it is: "--missing", "NDBC"
/// @return for each number that was found, how many of the values it was; empty: none
[[nodiscard]] std::vector<std::string> take_as_missing(HistorySeries& series,
                                                       std::span<const double> missing,
                                                       const std::string& who);

/// The same for numbers that look like it (ingest/quality/sentinel.h).
[[nodiscard]] std::vector<std::string> reject_sentinels(HistorySeries& series);

}  // namespace slackwater::ingest
