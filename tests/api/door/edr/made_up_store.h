#pragma once
#include <filesystem>

#include "fields/service/snapshot.h"

namespace slackwater::tests {

/// The made-up forecast of site `lone`, some days later than the first.
[[nodiscard]] Snapshot lone_forecast(int days_later, std::uint64_t seed);

/// Commits a forecast to a store, which is made where there is none.
void commit_made_up_forecast(const std::filesystem::path& store, const Snapshot& made);

/// Forecasts of twelve hours with three members, at three sites:
///
///   lone      one column at 2.55 W 48.85 N, issued on two days
///   farm      a grid of 4 x 3 columns, 2.40..2.46 E, 57.20..57.24 N, 0.02 degrees apart; every
///             second column is 44 m deep instead of 50, so that its last level (45 m) lies below
///             the bed
///   dateline  two columns, 179.99 E and 179.99 W, 17 S
void fill_with_made_up_forecasts(const std::filesystem::path& store);

}  // namespace slackwater::tests
