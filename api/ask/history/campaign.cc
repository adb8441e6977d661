#include "api/ask/history/campaign.h"

#include <algorithm>

#include "api/ask/history/workability.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/risk/workability/workable_starts.h"

namespace slackwater::api {
namespace {

twin::TaskHistory history_of(const CampaignTaskText& task, const LimitedHistory& limited,
                             const StepClock& clock, const std::optional<TimeZone>& zone) {
  const std::size_t work = twin::steps_needed(task.duration, clock.step);
  twin::StepRanges usable = limited.access.windows;
  if (task.working_hours)
    usable = twin::common_to(usable, twin::steps_at(clock, *task.working_hours, zone));
  if (task.split) {
    twin::TaskHistory::Visits visits;
    visits.shortest = twin::steps_needed(task.split->shortest_visit, clock.step);
    if (task.split->lost > Duration(0))
      visits.lost = twin::steps_needed(task.split->lost, clock.step);
    visits.shortest = std::max(visits.shortest, visits.lost + 1);
    return twin::TaskHistory::split(std::move(usable), work, visits);
  }
  const std::size_t needed = twin::steps_needed(task.duration + task.contingency, clock.step);
  twin::StepRanges starts = twin::workable_starts(usable, needed);
  if (task.start_hours)
    starts = twin::common_to(starts, twin::steps_at(clock, *task.start_hours, zone));
  return twin::TaskHistory::whole(std::move(starts), work);
}

}  // namespace

std::vector<SeriesLimit> CampaignFile::limits() const {
  std::vector<SeriesLimit> all;
  for (const CampaignTaskText& task : tasks) {
    for (const SeriesLimit& limit : task.limits) {
      if (std::find(all.begin(), all.end(), limit) == all.end()) all.push_back(limit);
    }
  }
  return all;
}

CampaignAnswer answer_of(const History& history, const CampaignFile& campaign,
                         const ingest::Vocabulary& vocabulary) {
  const StepClock& clock = history.regular.clock;
  CampaignAnswer answer;
  std::vector<twin::CampaignTask> tasks;
  twin::StepRanges known{{0, clock.steps}};
  for (const CampaignTaskText& task : campaign.tasks) {
    if (!task.split && task.duration + task.contingency > clock.end() - clock.first)
      throw Error(ErrorKind::invalid_input,
                  formatted("task '{}': found {:g} h, longer than the series: it has {:g} h",
                            task.name, hours_of(task.duration + task.contingency),
                            hours_of(clock.end() - clock.first)));
    LimitedHistory limited = api::limited(history, task.limits, vocabulary, campaign.zone);
    known = twin::common_to(known, twin::outside(limited.access.missing, clock.steps));
    if (task.daylight) {
      std::vector<std::string> notes;
      limited.access.windows =
          twin::common_to(limited.access.windows, light_at(history, *task.daylight, notes));
      for (std::string& note : notes) {
        if (std::find(answer.notes.begin(), answer.notes.end(), note) == answer.notes.end())
          answer.notes.push_back(std::move(note));
      }
    }
    tasks.push_back({history_of(task, limited, clock, campaign.zone), task.times});
    answer.work += task.duration * static_cast<Duration::rep>(task.times);
  }
  answer.missing = twin::outside(known, clock.steps);
  for (const std::chrono::month_day& date : campaign.begin)
    for (const std::size_t teams : campaign.teams)
      answer.seasons.push_back(twin::season_of(tasks, clock, date, campaign.zone, teams));
  return answer;
}

}  // namespace slackwater::api
