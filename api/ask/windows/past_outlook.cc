#include "api/ask/windows/past_outlook.h"

#include <map>

#include "api/ask/windows/limits_of_task.h"
#include "api/pipeline/past_mornings.h"
#include "fields/base/attempt.h"
#include "twin/chance/success_interval.h"
#include "twin/risk/start_chances.h"

namespace slackwater::api {
namespace {

/// Chances that are to be calibrated need no more: beyond it they move by 0.03 with the seed.
constexpr std::size_t past_waves = 1 + 12 * twin::WaveFutures::set_size;

/// What is asked of every past morning: today's work, planned once.
struct PastQuestion {
  const WindowsQuestion& question;
  const SharedOutlook& shared;
  const TaskSheet& sheet;
  const TaskWindows& today;
  UtcTime start;    ///< of today's run
  Outlook outlook;  ///< its run is moved from water to water
};

struct Held {
  std::size_t held = 0;
  std::size_t futures = 1;
};

/// Whether light and shift allow a start: what they shut says nothing of a forecast.
bool is_open(const Outlook& outlook, const TaskWindows& task, std::size_t start) {
  const std::size_t first = outlook.starts.step_of(start);
  for (const twin::WatchedLimit& watched : outlook.question.watched) {
    if (task.limits[watched.limit].limit) continue;
    for (const twin::StepRange& range : watched.when)
      for (std::size_t i = first + range.begin; i < first + range.end; ++i)
        if (!watched.bound.holds(watched.members.front()[i])) return false;
  }
  return true;
}

/// What held of each start in one water of a morning, by when it begins.
std::map<UtcTime, Held> chances_in(PastQuestion& past, const PastOutlook& morning,
                                   const ScenarioWater& water, const twin::WaveFutures* waves) {
  SharedOutlook shared = past.shared;
  shared.past = nullptr;
  shared.water = &water;
  shared.members = water.surround.field->snapshot().members;
  shared.waves = waves;
  shared.from -= morning.before;
  shared.to -= morning.before;
  Outlook& outlook = past.outlook;
  auto environment = *outlook.ready.environment;
  environment.field = water.surround.field;
  environment.epoch = outlook.ready.start = past.start - morning.before;
  outlook.ready.environment = std::make_shared<const twin::Environment>(std::move(environment));
  outlook.question = {};
  outlook.ahead.clear();
  outlook.gates.clear();
  TaskWindows out;
  out.workers = past.today.workers;
  out.turbines = past.today.turbines;
  out.planned_s = past.today.planned_s;
  out.contingency_s = past.today.contingency_s;
  out.is_split = past.today.is_split;
  out.least_visit_s = past.today.least_visit_s;
  lay_grid(past.question, shared, past.sheet, outlook, out);
  watch(past.question, shared, past.sheet, outlook, out);
  std::map<UtcTime, Held> chances;
  const std::vector<twin::StartChance> found = twin::start_chances(outlook.question);
  for (std::size_t s = 0; s < found.size(); ++s)
    if (is_open(outlook, out, s))
      chances[outlook.clock.time_of(outlook.starts.step_of(s))] = {found[s].held, out.futures};
  return chances;
}

/// The starts of one morning; none where it cannot be asked.
twin::PastStarts starts_of(PastQuestion& past, const PastOutlook& morning) {
  twin::PastStarts starts;
  const auto failure = attempt([&] {
    const Snapshot& forecast = morning.said.surround.field->snapshot();
    if (past.today.is_split &&
        morning.came.surround.field->range().to < past.shared.to - morning.before)
      return;  // visits that nobody knows of yet are not visits that failed
    const auto said =
        chances_in(past, morning, morning.said, morning.waves ? &*morning.waves : nullptr);
    for (const auto& [start, came] : chances_in(past, morning, morning.came, nullptr)) {
      // A forecast that was made when the day was over is no forecast of it.
      const auto found = said.find(start);
      if (found != said.end() && start >= forecast.issued)
        starts.push_back(
            {twin::next_success(found->second.held, found->second.futures), came.held > 0});
    }
  });
  if (failure) starts.clear();
  return starts;
}

}  // namespace

std::shared_ptr<const PastOutlooks> past_outlooks(const WindowsQuestion& question, const Site& site,
                                                  const Snapshot& forecast,
                                                  const std::filesystem::path& store_folder) {
  if (question.past) return question.past;
  auto outlooks = std::make_shared<PastOutlooks>();
  if (question.chances_as_futures_say) return outlooks;
  for (const PastMorning& morning : past_mornings(store_folder, site, forecast, question.threads)) {
    PastOutlook& past = outlooks->mornings.emplace_back();
    past.said = water_of(morning.forecast, {});
    past.came = water_of(morning.came, {});
    past.said.surround.site = past.came.surround.site = site.point;
    past.before = forecast.day - morning.forecast->day;
    if (!question.waves_as_forecast && has_waves(*morning.forecast))
      past.waves.emplace(*morning.forecast, past_waves);
  }
  return outlooks;
}

void look_back(const WindowsQuestion& question, const SharedOutlook& shared, const TaskSheet& sheet,
               const Outlook& outlook, TaskWindows& today) {
  if (shared.past == nullptr || shared.past->mornings.empty()) return;
  PastQuestion past{question, shared, sheet, today, outlook.ready.start, {}};
  past.outlook.ready = outlook.ready;
  std::vector<twin::PastStarts> mornings;
  mornings.reserve(shared.past->mornings.size());
  for (const PastOutlook& morning : shared.past->mornings)
    mornings.push_back(starts_of(past, morning));
  today.calibration = twin::chance_calibration(mornings);
  today.past = twin::past_verdicts(mornings, question.rule);
}

}  // namespace slackwater::api
