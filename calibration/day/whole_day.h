#pragma once
#include <optional>
#include <string>

#include "fields/record/site_data.h"

namespace slackwater::calibration {

/// Whether a day's currents are there: no gap at its ends or within it wider than two and a half
/// usual steps (of two and a half hours for series finer than hourly).
[[nodiscard]] bool holds_throughout(const VectorColumn& currents, UtcDay day);

/// The currents of a day and the dataset that leads in it; both empty where there is none.
struct DayCurrents {
  VectorColumn currents;
  std::string dataset;
};

/// The currents of a day as known at the issue time, at the column that speaks for the site: the
/// first with currents.
[[nodiscard]] DayCurrents currents_of_day(const SiteData& data, UtcDay day, UtcTime issued);

/// Whether the currents of this day are held throughout, as known at the issue time.
[[nodiscard]] bool holds_day(const SiteData& data, UtcDay day, UtcTime issued);

/// The newest day up to the issue time for which the currents of the site are held throughout;
/// nothing where there is none. @param latest  no later day than this
[[nodiscard]] std::optional<UtcDay> newest_whole_day(const SiteData& data, UtcTime issued,
                                                     std::optional<UtcDay> latest = {});

}  // namespace slackwater::calibration
