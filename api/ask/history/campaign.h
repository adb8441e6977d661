#pragma once
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "api/ask/history/history.h"
#include "twin/risk/workability/campaign.h"
#include "twin/risk/workability/daylight.h"

namespace slackwater::api {

/// A task of a campaign as its YAML has it.
struct CampaignTaskText {
  std::string name;
  std::size_t times = 1;
  std::vector<SeriesLimit> limits;  ///< the campaign's, then its own
  Duration duration{};
  Duration contingency{0};
  std::optional<twin::DayHours> start_hours;    ///< it begins within them
  std::optional<twin::DayHours> working_hours;  ///< it is at work within them alone
  std::optional<twin::Light> daylight;          ///< it is at work in this light alone
  struct Split {
    Duration shortest_visit{};
    Duration lost{0};  ///< of each visit, to getting there and back
  };
  std::optional<Split> split;
};

/// Tasks that are done one after the other, by one team or several beside each other, as
/// `--campaign FILE.yaml` has them:
///
///     name: Anodes of ten foundations
///     timezone: Europe/Berlin                  # of dates and hours; absent: UTC
///     begin: [04-01, 07-01]                    # absent: the first of each month
///     teams: [1, 2]                            # that work beside each other; absent: 1
///     limits: [sea_surface_wave_significant_height<=1.5, wind_speed<=12 m/s]
///     tasks:
///       - {name: anodes, times: 10, duration: 4h, contingency: 1h, start_hours: 6-18}
///       - name: cleaning
///         limits: [sea_surface_wave_significant_height<=1.25]   # beside those above
///         duration: 30h
///         working_hours: 6-18
///         daylight: civil                  # sun_up, civil, nautical; needs --lat and --lon
///         split: {shortest_visit: 3h, lost: 1h}
struct CampaignFile {
  std::string name;
  std::optional<TimeZone> zone;
  std::vector<std::chrono::month_day> begin;
  std::vector<std::size_t> teams;  ///< fleets to compare, each by how many teams it has
  std::vector<CampaignTaskText> tasks;

  /// Of all tasks.
  [[nodiscard]] std::vector<SeriesLimit> limits() const;
};
/// What came of a campaign over a history.
struct CampaignAnswer {
  std::vector<twin::CampaignSeason> seasons;  ///< date by date, of each fleet
  Duration work{};                            ///< that all tasks take together
  std::vector<std::string> notes;
  twin::StepRanges missing;  ///< steps without a value that some task asks for
};
/// @throws Error(invalid_input) for a task longer than the history
[[nodiscard]] CampaignAnswer answer_of(const History& history, const CampaignFile& campaign,
                                       const ingest::Vocabulary& vocabulary);

}  // namespace slackwater::api
