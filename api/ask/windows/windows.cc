#include "api/ask/windows/windows.h"

#include <algorithm>
#include <optional>

#include "api/ask/windows/past_outlook.h"
#include "api/ask/windows/vessel_access.h"
#include "api/program/paths.h"
#include "fields/base/attempt.h"
#include "fields/base/error.h"
#include "fields/base/parallel.h"
#include "fields/base/text.h"
#include "fields/site/site.h"

namespace slackwater::api {
namespace {

using std::chrono::days;

/// The forecast in force, a day's, or that of a file.
ScenarioWater forecast_water(const WindowsQuestion& question,
                             const std::filesystem::path& store_folder) {
  twin::Scenario scenario;
  twin::ForecastWater wanted;
  if (question.forecast.empty())
    wanted.site = question.site;
  else
    wanted.file = std::filesystem::absolute(question.forecast).string();
  wanted.day = question.day;
  scenario.water = wanted;
  return water_of(scenario, store_folder, std::filesystem::current_path());
}

/// With the members that are asked for.
ScenarioWater water_of_question(const WindowsQuestion& question, const Site& site,
                                const std::filesystem::path& store_folder) {
  ScenarioWater water = question.water ? *question.water : forecast_water(question, store_folder);
  water.surround.site = site.point;
  if (question.members > 0) hold_members(water, question.members, store_folder, question.threads);
  return water;
}

/// The first full UTC day after the issue, or the hours that were asked for.
/// @return whether it is that day
bool choose_span(const WindowsQuestion& question, const Field& field, SharedOutlook& shared) {
  const ValidRange& range = field.range();
  const UtcTime midnight = std::chrono::ceil<days>(field.snapshot().issued);
  shared.from = question.from.value_or(midnight);
  shared.to = question.to.value_or(question.from ? UtcTime(day_of(*question.from) + days(1))
                                                 : shared.from + days(1));
  const std::string holds =
      "the forecast holds from " + format_utc(range.from) + " to " + format_utc(range.to);
  if (shared.to <= shared.from)
    throw Error(ErrorKind::invalid_input, "found starts from " + format_utc(shared.from) + " to " +
                                              format_utc(shared.to) +
                                              ", expected an end after the beginning");
  if (shared.from < range.from || shared.to > range.to || shared.from >= range.to)
    throw Error(
        ErrorKind::invalid_input,
        (question.from || question.to ? std::string("found starts from ")
                                      : "the first full day after the issue is from ") +
            format_utc(shared.from) + " to " + format_utc(shared.to) + ", and " + holds +
            (question.from || question.to
                 ? "; ask for hours within it"
                 : "; ask for hours within it with --from and --to, or make a newer forecast"));
  return !question.from && !question.to;
}

/// Each task by itself; one that cannot be worked out is left out where the question lets it.
void work_out(const WindowsQuestion& question, const SharedOutlook& shared,
              const std::vector<std::string>& tasks, WindowsAnswer& answer) {
  answer.tasks.resize(tasks.size());
  if (!question.may_leave_out) {
    for_all(tasks.size(), question.threads,
            [&](std::size_t i) { answer.tasks[i] = task_windows(question, shared, tasks[i]); });
    return;
  }
  std::vector<std::optional<Failure>> failures(tasks.size());
  for_all(tasks.size(), question.threads, [&](std::size_t i) {
    failures[i] = attempt([&] { answer.tasks[i] = task_windows(question, shared, tasks[i]); });
  });
  std::vector<TaskWindows> made;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (failures[i])
      answer.left_out.push_back({tasks[i], failures[i]->why});
    else
      made.push_back(std::move(answer.tasks[i]));
  }
  if (made.empty() && !question.may_leave_all_out)
    throw Error(failures.front()->kind, failures.front()->why);
  answer.tasks = std::move(made);
}

void expect_once(const char* what, std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end())
    throw Error(ErrorKind::usage,
                std::string("found ") + what + " " + *twice + " twice; name it once");
}

}  // namespace

WindowsAnswer windows_of(const WindowsQuestion& question,
                         const std::filesystem::path& store_folder) {
  const Site site = find_site(question.site, site_folders(store_folder));
  const std::vector<std::string>& tasks = question.tasks.empty() ? site.tasks : question.tasks;
  if (tasks.empty())
    throw Error(ErrorKind::usage, "found no --task, and site " + site.id +
                                      " lists none; expected one or more of " +
                                      joined(known_tasks(), ", ") + ", or the path of a file");
  expect_once("task", tasks);
  expect_once("turbine", question.turbines);
  // What is misspelt is said before anything is read; of a site's own list it is left out.
  if (!question.may_leave_out || !question.tasks.empty())
    for (const std::string& task : tasks) (void)load_task(task, std::filesystem::current_path());
  WindowsAnswer answer;
  answer.site_id = site.id;
  answer.site_name = site.name;
  answer.water = water_of_question(question, site, store_folder);
  const Field& field = *answer.water.surround.field;
  SharedOutlook shared;
  shared.site = &site;
  shared.water = &answer.water;
  shared.store_folder = store_folder;
  shared.members = question.members > 0 ? question.members : field.snapshot().members;
  shared.is_one_day = choose_span(question, field, shared);
  answer.from = shared.from;
  answer.to = shared.to;
  std::optional<twin::WaveFutures> waves;
  if (!question.waves_as_forecast && has_waves(field.snapshot()))
    shared.waves = &waves.emplace(field.snapshot(), twin::WaveFutures::many);
  if (auto vessel = vessel_access(site, std::filesystem::current_path()))
    answer.vessel = std::make_shared<const VesselAccess>(std::move(*vessel));
  shared.vessel = answer.vessel.get();
  answer.past = past_outlooks(question, site, field.snapshot(), store_folder);
  shared.past = answer.past.get();
  if (shared.members == 1)
    answer.notes.emplace_back(
        "the forecast has one future of wind and current: limits on these are held against it "
        "alone");
  if (field.snapshot().hindsight)
    answer.notes.emplace_back(
        "the forecast was made in hindsight: it was not available at its issue time");
  if (field.snapshot().degraded)
    answer.notes.push_back("the forecast is degraded: " + field.snapshot().headline);
  work_out(question, shared, tasks, answer);
  answer.verdict = answer.left_out.empty() ? twin::Verdict::go : twin::Verdict::no_go;
  for (const TaskWindows& task : answer.tasks)
    answer.verdict = std::max(answer.verdict, task.verdict);
  answer.notes.insert(answer.notes.end(), answer.water.warnings.begin(),
                      answer.water.warnings.end());
  return answer;
}

}  // namespace slackwater::api
