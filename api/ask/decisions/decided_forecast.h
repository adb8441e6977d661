#pragma once
#include <vector>

#include "data/store/rows.h"

namespace slackwater::api {

/// The forecast that a decision about a start rests on: of those issued by the time of its record,
/// and by the start, that cover the start the latest (of two of one instant the one filed last).
/// Hindcasts are none: nobody had them.
/// @param of_site  all stored forecasts of the site, at least one
/// @param before_names  of a word, in errors: "--" of "--at"
/// @throws Error(not_found) where there is none, saying what there is
[[nodiscard]] store::ForecastRow decided_forecast(const std::vector<store::ForecastRow>& of_site,
                                                  UtcTime start, UtcTime recorded_at,
                                                  const std::string& before_names = {});

}  // namespace slackwater::api
