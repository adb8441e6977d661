#pragma once
#include "fields/record/history_series.h"
#include "ingest/copernicus/vocabulary.h"

namespace slackwater::ingest {

/// Makes values of a known quantity that are beyond belief (`Quantity::gross`) missing: -999 is no
/// calm sea. Nothing is done to a quantity that we do not know.
/// @return how many, in words; empty: none
/// @throws Error(invalid_input) where they are more than a tenth of the values, or where the unit
///         of the series is not one of the quantity
[[nodiscard]] std::string reject_beyond_belief(HistorySeries& series, const Vocabulary& vocabulary);

}  // namespace slackwater::ingest
