#include "api/door/cli/sea/morning_of_forecast.h"

#include <cstdio>

#include "api/ask/morning/operator_config.h"
#include "api/door/cli/progress.h"
#include "api/door/cli/windows_options.h"
#include "api/door/morning/hook.h"
#include "api/door/morning/make_morning.h"
#include "api/issued/in_force.h"
#include "api/show/morning/morning_json.h"
#include "api/show/morning/morning_text.h"
#include "api/show/morning/page_pdf.h"
#include "api/show/morning/verified_text.h"
#include "fields/base/attempt.h"
#include "fields/base/log.h"
#include "fields/base/text.h"
#include "ingest/cf/forecast/forecast_file.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

std::optional<FlyWindows> flights_of(const MorningAsked& asked) {
  WindowsArguments arguments;
  arguments.fly = asked.fly;
  return flights_wanted(arguments);
}

/// A later issue of the day has a page of its own, beside what people decided by in the morning.
std::string page_mark(const Snapshot& forecast) {
  const std::string stamp = format_utc(forecast.issued);
  return "_" + stamp.substr(11, 2) + stamp.substr(14, 2);
}

/// @param is_the_mornings  the forecast is the one of its day that counts as issued
MadeMorning make(const Site& site, const Issue& issue, bool is_the_mornings,
                 const MorningAsked& asked, const Context& context) {
  MakeMorning how;
  if (!is_the_mornings) how.page_mark = page_mark(issue.job.forecast.snapshot);
  how.question.windows = plain_question(site, asked.site);
  how.question.windows.day = issue.job.forecast.snapshot.day;
  how.question.windows.water =
      water_of(std::make_shared<const Snapshot>(ingest::as_filed(issue.job.forecast.snapshot)),
               issue.filed.content_sha256);
  how.question.plan = plan_of_site(site.id, context.store_folder);
  how.question.is_unattended = true;
  how.fly = flights_of(asked);
  how.generated = made_by(context);
  how.known = KnownForecast{calibration::making_of(issue.job.forecast), issue.past};
  ProgressBar progress("flying " + site.name, context.json);
  how.on_first_page = [&](const MadeMorning& first) {
    if (!context.json) std::fprintf(stderr, "first page: %s\n", first.html.c_str());
  };
  how.on_progress = [&](double share) { progress.update(share); };
  return make_morning(how, site, context.store_folder);
}

/// What the hook hears where there is no report.
json no_morning_json(const Site& site, const std::string& why) {
  return {{"schema", "morning/1"}, {"site", site.id}, {"verdict", nullptr}, {"why", why}};
}

/// What became of the hook; empty: there is none, or it was told before.
std::string told(const Site& site, std::int64_t forecast, const Context& context,
                 const json& verdict) {
  std::string text;
  const auto failure = attempt([&] {
    const OperatorConfig config = operator_config();
    if (config.hook)
      text = tell_hook(*config.hook, reports_folder(context.store_folder, site.id), forecast,
                       verdict.dump(2, ' ', false, json::error_handler_t::replace));
  });
  return failure ? "the hook was not run: " + failure->why : text;
}

}  // namespace

void expect_readable(const MorningAsked& asked) { static_cast<void>(flights_of(asked)); }

MorningDone morning_of_forecast(store::Store& store, const Site& site, const Issue& issue,
                                const MorningAsked& asked, const Context& context) {
  MorningDone done;
  if (site.tasks.empty() || issue.origin != ForecastOrigin::forecast) return done;
  const UtcDay day = issue.job.forecast.snapshot.day;
  const auto note = [&](const std::string& text) {
    if (!text.empty()) done.notes += text + "\n";
  };
  const auto in_force_of = [&](std::optional<UtcDay> of_day) {
    const InForce found = forecast_in_force(store, {site.id, of_day, {}});
    for (const std::string& damage : found.passed_over)
      log_event(LogLevel::warning, "forecast passed over", {{"problem", damage}});
    return found.row.id;
  };
  const std::int64_t in_force = in_force_of(day);
  const bool is_the_mornings = in_force == issue.filed.id;
  if (!is_the_mornings && in_force_of(std::nullopt) != issue.filed.id) {
    note(
        formatted("no morning report: forecast {} of the same day is in force; for its report run "
                  "`slackwater report --site {} --day {}`",
                  in_force, asked.site, format_day(day)));
    return done;
  }
  const auto failure = attempt([&] {
    const MadeMorning made = make(site, issue, is_the_mornings, asked, context);
    done.json = morning_json(made.morning, made.known.past.entries, verified_text(made.known.past));
    done.json["page"] = made.html.string();
    done.text = morning_text(made.morning) + "The page: " + made.html.string() + "\n";
    for (const std::string& told : made.morning.windows.notes) note(told);
    if (!asked.is_pdf) return;
    std::filesystem::path pdf = made.html;
    pdf.replace_extension(".pdf");
    if (const auto unprinted = attempt([&] { print_page(made.html, pdf); })) note(unprinted->why);
  });
  if (failure) note("no morning report: " + failure->why);
  note(told(site, issue.filed.id, context,
            failure ? no_morning_json(site, failure->why) : done.json));
  return done;
}

}  // namespace slackwater::api
