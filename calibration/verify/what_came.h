#pragma once
#include <memory>
#include <string>

#include "fields/record/site_data.h"
#include "fields/service/snapshot.h"

namespace slackwater::calibration {

/// What came, as a forecast that erred nowhere would have said it: one future, with wind and waves
/// as `surface_truth` has them and currents as the dataset of the forecast was analysed later; bed
/// and sea level, and of waves whose period or direction nobody tells these, are the forecast's.
/// Between values at most three hours apart it is linear.
///
/// It ends where something is unknown that the forecast has a value of; values that end after
/// `known_by` are unknown.
///
/// @param dataset  of the forecast's currents; empty where it has none
/// @return null where not even the first hour is known, or a column is not in the data
[[nodiscard]] std::shared_ptr<const Snapshot> what_came(const SiteData& data,
                                                        const Snapshot& forecast,
                                                        const std::string& dataset,
                                                        UtcTime known_by);

}  // namespace slackwater::calibration
