#include "calibration/day/day_choice.h"

#include <algorithm>

#include "calibration/day/leading_day.h"
#include "fields/base/averaging.h"

namespace slackwater::calibration {

using std::chrono::days;

DayChoice choose_day(const SiteData& data, const ForecastOptions& options,
                     std::vector<PartFailure>& failures) {
  DayChoice choice;
  attempt_part(Part::day, failures, [&] {
    const DaysKnown known{options.issued, options.seen_by, options.day};
    const std::optional<LeadingDay> leading = options.parts.day(data, known);
    if (!leading) return;
    choice.averaging =
        averaging_of(currents_of_day(data, leading->dataset, leading->day, known).time);
    choice.dataset = leading->dataset;
    choice.stands_in_for = leading->stands_in_for;
    choice.usable = leading->day;
  });
  // Providers deliver a day late; more than that is late, and the forecast still has to reach as
  // far.
  const UtcDay newest_possible = day_of(options.issued) - days(1);
  choice.wanted = options.day.value_or(
      std::max(choice.usable.value_or(newest_possible), newest_possible - days(1)));
  return choice;
}

}  // namespace slackwater::calibration
