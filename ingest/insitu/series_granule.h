#pragma once
#include <string>
#include <vector>

#include "fields/grid/granule.h"
#include "ingest/insitu/series_levels.h"
#include "ingest/insitu/series_times.h"
#include "ingest/insitu/series_values.h"

namespace slackwater::ingest {

/// A series with its levels.
struct PlacedSeries {
  SeriesValues series;
  SeriesLevels levels;
};

/// What becomes one granule: series on the same levels with records at about the same stamps.
struct SeriesGroup {
  SeriesLevels levels;
  std::vector<TimeCell> times;
  std::vector<SeriesValues> series;  ///< cut to `times`
};

/// Sorts series into groups. Two share one if their levels agree and at least half of the rarer
/// one's stamps with records are stamps of the other. A stamp without a record of any series of the
/// group is left out.
[[nodiscard]] std::vector<SeriesGroup> group_series(const std::vector<PlacedSeries>& placed,
                                                    const SeriesTimes& times);

/// Orders levels (depth or height ascending) and leaves out those out of the water, those within
/// reach of side lobes that no provider has passed, and those without any accepted value. Says
/// which.
void keep_useful_levels(SeriesGroup& group, const std::optional<double>& water_depth_m,
                        std::vector<std::string>& warnings);
/// Marks unchecked values of bins within reach of side lobes as suspect.
void reject_side_lobes(SeriesGroup& group, std::vector<std::string>& warnings);

}  // namespace slackwater::ingest
