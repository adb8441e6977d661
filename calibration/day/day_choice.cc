#include "calibration/day/day_choice.h"

#include <algorithm>

#include "calibration/day/whole_day.h"
#include "fields/base/averaging.h"

namespace slackwater::calibration {

using std::chrono::days;

DayChoice choose_day(const SiteData& data, const ForecastOptions& options,
                     std::vector<PartFailure>& failures) {
  DayChoice choice;
  attempt_part(Part::day, failures, [&] {
    std::optional<UtcDay> usable = options.day;
    if (!usable || !holds_day(data, *usable, options.issued))
      usable = options.parts.day(data, options.issued, options.day);
    if (usable) {
      DayCurrents found = currents_of_day(data, *usable, options.issued);
      choice.dataset = std::move(found.dataset);
      choice.averaging = averaging_of(found.currents.time);
    }
    choice.usable = usable;
  });
  // Providers deliver a day late; more than that is late, and the forecast still has to reach as
  // far.
  const UtcDay newest_possible = day_of(options.issued) - days(1);
  choice.wanted = options.day.value_or(
      std::max(choice.usable.value_or(newest_possible), newest_possible - days(1)));
  return choice;
}

}  // namespace slackwater::calibration
