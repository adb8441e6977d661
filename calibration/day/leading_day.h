#pragma once
#include <optional>
#include <string>

#include "fields/record/choose.h"
#include "fields/record/site_data.h"

namespace slackwater::calibration {

/// What is known of the days of a site at an issue time.
struct DaysKnown {
  UtcTime issued{};
  UtcTime seen_by = UtcTime::max();  ///< Knowledge::seen_by
  std::optional<UtcDay> latest{};    ///< no later day than this
};

/// The day that a forecast rests on, and whose currents it takes.
struct LeadingDay {
  UtcDay day{};
  std::string dataset;
  /// The dataset that leads at the site and has no whole day near enough, for which this one stands
  /// in; empty: none.
  std::string stands_in_for;
  Duration averaging{0};  ///< of the day's currents
};

/// The newest day whose currents the site's leading product holds throughout.
///
/// The product leads that the site names, else the first by precedence (fields/record) that has
/// held a day within a week. Where it is silent, its last good day counts for two days; then, until
/// it is forgotten, another product stands in. In-situ series count where they lead on a day by
/// themselves. Nothing where no day is held at all. Looks at the first column with currents.
[[nodiscard]] std::optional<LeadingDay> leading_day(const SiteData& data, const DaysKnown& known);

/// Whether a dataset holds this day throughout at that column, as known.
[[nodiscard]] bool holds_day(const SiteData& data, const std::string& dataset, UtcDay day,
                             const DaysKnown& known);

}  // namespace slackwater::calibration
