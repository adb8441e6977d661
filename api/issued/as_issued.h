#pragma once
#include <vector>

#include "data/store/rows.h"

// Of several forecasts of one day D, the one that people had: what "yesterday's forecast" means.

namespace slackwater::api {

/// How long after its first issue a day's forecast may be issued again and still be that morning's:
/// a file came late, the job ran once more before the boats left. Later than that the day is run
/// again for another reason.
inline constexpr Duration same_morning = std::chrono::hours(6);

/// Orders forecasts of one site, day D and, where those are told apart, wind policy: the one as
/// issued first, then what may stand in where its file is damaged.
///
/// As issued is, of those of origin `forecast`, the last one issued within `same_morning` of the
/// first that was filed; of those issued at once the first filed. Then the others of that morning,
/// then later runs, the earliest first, and hindcasts at the end, the newest first. A run whose
/// issue time goes back behind that of a forecast of the site filed before it (`--at` in the past)
/// is a replay: it stands before hindcasts, behind everything else.
///
/// @param of_site  all forecasts of the site of that day D and later ones, which tell replays
[[nodiscard]] std::vector<store::ForecastRow> as_issued_first(
    std::vector<store::ForecastRow> rows, const std::vector<store::ForecastRow>& of_site);

/// How a run of day D at an issue time is to be filed. A forecast is what the daily job makes of
/// the newest day. Asked for a past day by name it is a hindcast: where this day's forecast was
/// issued before that morning, or a later day's forecast was issued already. So is what was made in
/// hindsight.
///
/// @param day_was_named  the day was asked for, not found as the newest
/// @param of_site        the site's stored forecasts, at least those of that day D and later ones
[[nodiscard]] ForecastOrigin origin_of_run(UtcDay day, UtcTime issued, bool day_was_named,
                                           bool hindsight,
                                           const std::vector<store::ForecastRow>& of_site);

}  // namespace slackwater::api
