#include "api/ask/decisions/decide.h"

#include <algorithm>

#include "api/ask/decisions/decided_forecast.h"
#include "api/ask/decisions/line_of_text.h"
#include "api/issued/in_force.h"
#include "api/program/paths.h"
#include "data/store/store.h"
#include "fields/base/advice.h"
#include "fields/base/attempt.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/site/site.h"

namespace slackwater::api {
namespace {

void expect_turbine(const Site& site, const DecideQuestion& question) {
  const std::string& turbine = question.turbine;
  if (turbine.empty()) return;
  std::vector<std::string> known;
  for (const TurbinePlace& place : site.turbines) known.push_back(place.id);
  if (std::find(known.begin(), known.end(), turbine) != known.end()) return;
  throw Error(
      ErrorKind::not_found,
      question.before_names + "turbine: found " + turbine + ", which site " + site.id + " has not" +
          did_you_mean(turbine, known) + "; " +
          (known.empty() ? "it has no turbines: leave " + question.before_names + "turbine out"
                         : "expected one of " + joined(known, ", ")));
}

/// The question that the morning report asks of the day of a start, its half hours moved so that
/// they meet the start.
WindowsQuestion question_about(const DecideQuestion& decided, const Field& field) {
  using std::chrono::days;
  WindowsQuestion question = decided.windows;
  question.tasks = {decided.task};
  if (!decided.turbine.empty()) question.turbines = {decided.turbine};
  const UtcTime midnight(day_of(decided.start));
  const Snapshot& forecast = field.snapshot();
  UtcTime first = std::max(midnight, field.range().from);
  if (day_of(forecast.issued) == day_of(decided.start)) first = std::max(first, forecast.issued);
  const Duration ahead = decided.start - first;
  question.from = decided.start - question.every * (ahead / question.every);
  question.to = std::min(midnight + days(1), field.range().to);
  return question;
}

/// What the program says of the start: into the row.
void add_what_is_said(const DecideQuestion& decided, const store::Store& store,
                      const store::ForecastRow& forecast, const std::filesystem::path& store_folder,
                      store::DecisionRow& row) {
  const auto failure = attempt([&] {
    const std::shared_ptr<const Field> field = read_field(store, forecast, ingest::Members::all);
    WindowsQuestion question = question_about(decided, *field);
    question.water =
        water_of(std::make_shared<const Snapshot>(field->snapshot()), forecast.content_sha256);
    const WindowsAnswer answer = windows_of(question, store_folder);
    const TaskWindows& task = answer.tasks.front();
    if (!task.turbines.empty()) row.turbine = task.turbines.front();
    row.work = std::chrono::round<Duration>(
        std::chrono::duration<double>(task.planned_s + task.contingency_s));
    const auto start =
        std::find_if(task.starts.begin(), task.starts.end(),
                     [&](const TaskStart& one) { return one.start == decided.start; });
    if (start == task.starts.end() && !task.starts.empty() &&
        decided.start < task.starts.front().start) {
      row.unsaid = "the vessel's way out begins before the forecast (" +
                   format_utc(field->range().from) + ")";
      return;
    }
    if (start == task.starts.end()) {
      row.unsaid = formatted(
          "the work takes {:.1f} h with its contingency and ends after the "
          "forecast ({})",
          hours_of(*row.work), format_utc(field->range().to));
      return;
    }
    row.probability = start->probability;
    row.verdict = twin::name_of(twin::verdict_of(start->worth, question.rule));
  });
  if (failure) row.unsaid = failure->why;
}

std::optional<store::DecisionRow> counted_until_now(store::Store& store,
                                                    const store::DecisionRow& row) {
  store::DecisionQuery same;
  same.site_id = row.site_id;
  same.task = row.task;
  same.from = row.start;
  same.to = row.start + Duration(1);
  std::optional<store::DecisionRow> last;
  for (store::DecisionRow& one : store.find_decisions(same))
    if (one.turbine == row.turbine && (!last || one.id > last->id)) last = std::move(one);
  return last;
}

}  // namespace

std::string lasting_name(const std::string& task) {
  const std::vector<std::string> known = known_tasks();
  if (std::find(known.begin(), known.end(), task) != known.end()) return task;
  return std::filesystem::absolute(task).lexically_normal().string();
}

DecisionMade decision_made(const DecideQuestion& question,
                           const std::filesystem::path& store_folder) {
  DecisionMade made;
  store::DecisionRow& row = made.row;
  const std::string& names = question.before_names;
  row.by = line_of_text(names + "by", question.by, store::longest_name);
  if (row.by.empty())
    throw Error(
        ErrorKind::usage,
        names + "by: found no name, expected that of who decides; a record without one is none");
  row.note = line_of_text(names + "note", question.note, store::longest_note);
  const std::string hand_over = names.empty() ? "hand_over" : names + "hand-over";
  row.hand_over = line_of_text(hand_over, question.hand_over, store::longest_note);
  if (question.start != std::chrono::floor<std::chrono::minutes>(question.start))
    throw Error(ErrorKind::usage, names + "start: found " + format_utc(question.start) +
                                      ", expected a whole minute; write 2025-03-10T07:30Z");
  const Site site = find_site(question.windows.site, site_folders(store_folder));
  (void)load_task(question.task, std::filesystem::current_path());
  expect_turbine(site, question);
  store::Store store = store::Store::open(store_folder, store::OpenMode::read_only);
  store::ForecastQuery of_site;
  of_site.site_id = site.id;
  const std::vector<store::ForecastRow> forecasts = store.find_forecasts(of_site);
  if (forecasts.empty())
    throw Error(ErrorKind::not_found, "found no issued forecast for site " + site.id +
                                          ", and a decision rests on one; run `slackwater "
                                          "forecast` first, or ask the store that "
                                          "has one");
  const store::ForecastRow forecast =
      decided_forecast(forecasts, question.start, question.recorded_at, names);
  row.site_id = site.id;
  row.task = lasting_name(question.task);
  row.turbine = question.turbine;
  row.start = question.start;
  row.decided = question.decided;
  row.recorded_at = question.recorded_at;
  row.by_clock = question.by_clock;
  row.forecast = forecast.id;
  row.forecast_sha256 = forecast.content_sha256;
  row.forecast_issued = forecast.issued;
  add_what_is_said(question, store, forecast, store_folder, row);
  made.is_late = row.recorded_at > row.start;
  made.before = counted_until_now(store, row);
  return made;
}

void file_decision(DecisionMade& made, const std::filesystem::path& store_folder) {
  store::Store store = store::Store::open(store_folder, store::OpenMode::create_or_write);
  made.row.id = store.record_decision(made.row);
}

}  // namespace slackwater::api
