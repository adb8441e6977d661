#include "api/door/cli/windows_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

#include "api/program/paths.h"

namespace slackwater::api {
namespace {

int cores() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

Duration positive(std::string_view option, const std::string& text) {
  const Duration found = option_value(option, text, parse_duration);
  if (found < std::chrono::minutes(1) || found > std::chrono::days(1))
    throw Error(ErrorKind::usage,
                std::string(option) + ": found " + text + ", expected 1min to 1d");
  return found;
}

AlphaPractice practice_of(const std::vector<std::string>& named, const Site& site,
                          const Context& context, int threads) {
  std::vector<std::filesystem::path> files;
  for (const std::string& name : named)
    if (name != "errors") files.emplace_back(name);
  if (files.size() == named.size()) return AlphaPractice::of_tables(files);
  if (files.size() + 1 < named.size())
    throw Error(ErrorKind::usage, "--alpha: found errors twice; name it once");
  return AlphaPractice::of_errors(
      twin::with_verified(published_height_errors(),
                          verified_heights(site, context.store_folder, threads)),
      files);
}

}  // namespace

void add_windows_options(CLI::App& command, WindowsArguments& arguments) {
  command.add_option("--site", arguments.site, "id, or path of a site file")->required();
  command.add_option("--day", arguments.day,
                     "day D of the forecast (default: the one in force); starts are those of the "
                     "first full UTC day after its issue");
  command.add_option("--forecast", arguments.forecast, "a forecast's file instead of the store's");
  command.add_option("--task", arguments.tasks,
                     "id of data/tasks or a file, as often as wanted (default: the site's)");
  command.add_option("--turbine", arguments.turbines,
                     "where (default: the first that the task can be done at)");
  command.add_option("--from", arguments.from, "first start, UTC time");
  command.add_option("--to", arguments.to, "starts before this, UTC time");
  command.add_option("--every", arguments.every, "from one start to the next (default 30min)");
  command.add_option("--contingency", arguments.contingency,
                     "beyond the planned time, e.g. 1h (default: the task sheet's)");
  command.add_option("--members", arguments.members, "futures (default: all that were issued)")
      ->check(CLI::Range(1, 100000));
  command
      .add_option("--waves", arguments.waves,
                  "error: each future's waves err as forecasts do (default); forecast: all have "
                  "the forecast's")
      ->check(CLI::IsMember({"error", "forecast"}));
  command.add_option("--assume", arguments.assume,
                     "what no forecast serves, e.g. visibility_m=5000");
  command.add_option("--light", arguments.light,
                     "sun_up, civil or nautical: the task is done in that light");
  command.add_option(
      "--shift", arguments.shift,
      "06:00-18:00: the task is done in these hours (default: the site's, else all; 0-24 is all)");
  command.add_option(
      "--timezone,--zone", arguments.zone,
      "of the shift and the table, e.g. Europe/Paris (default: the site's, else UTC)");
  command.add_option("--alpha", arguments.alpha,
                     "FILE.yaml of factors for one variable, as often as wanted; errors: those of "
                     "wave heights, worked out from the site's wave forecasts (default of wave "
                     "heights: DNV-OS-H101 table 4-1)");
  command
      .add_option("--alpha-from", arguments.period_from,
                  "issue or start: from when the planned period of alpha counts (default issue)")
      ->check(CLI::IsMember({"issue", "start"}));
  command.add_option("--fly", arguments.fly,
                     "fly the starts that the limits leave open too, for so long at most, e.g. "
                     "15min: the twin's probability of success with its reserve");
  command.add_option("--fly-every", arguments.fly_every,
                     "time between the starts that are flown (default 1h)");
  command.add_option("--go", arguments.go, "P of a start that is a go (default 0.9)")
      ->check(CLI::Range(0.0, 1.0));
  command.add_option("--marginal", arguments.marginal, "P of a marginal one (default 0.5)")
      ->check(CLI::Range(0.0, 1.0));
  command.add_flag("--verdict-exit", arguments.verdict_exit,
                   "exit with 10 for go, 11 for marginal, 12 for no-go");
  command.add_option("--threads", arguments.threads, "1 to 64 (default: one a core)")
      ->check(CLI::Range(1, 64));
}

namespace {

/// The hours in which a site works, where nobody says others.
std::optional<twin::DayHours> shift_of(const Site& site) {
  if (site.shift.empty()) return std::nullopt;
  return with_context("site " + site.id + ", shift",
                      [&] { return twin::parse_day_hours(site.shift); });
}

}  // namespace

WindowsQuestion windows_question(const WindowsArguments& arguments, const Context& context) {
  WindowsQuestion question;
  question.site = arguments.site;
  question.forecast = arguments.forecast;
  if (!arguments.day.empty()) question.day = option_value("--day", arguments.day, parse_day);
  question.tasks = arguments.tasks;
  question.turbines = arguments.turbines;
  if (!arguments.from.empty()) question.from = context.time_of("--from", arguments.from);
  if (!arguments.to.empty()) question.to = context.time_of("--to", arguments.to);
  question.every = positive("--every", arguments.every);
  if (!arguments.contingency.empty())
    question.contingency = option_value("--contingency", arguments.contingency, parse_duration);
  question.members = arguments.members;
  question.waves_as_forecast = arguments.waves == "forecast";
  for (const std::string& text : arguments.assume)
    question.assumed.push_back(twin::parse_assumption(text));
  if (!arguments.light.empty())
    question.light = option_value("--light", arguments.light, twin::parse_light);
  if (!arguments.shift.empty())
    question.shift = option_value("--shift", arguments.shift, twin::parse_day_hours);
  if (!arguments.zone.empty())
    question.zone = option_value("--timezone", arguments.zone,
                                 [](const std::string& name) { return TimeZone::named(name); });
  const Site site = find_site(arguments.site, site_folders(context.store_folder));
  if (arguments.zone.empty()) question.zone = site.time_zone;
  if (arguments.shift.empty()) question.shift = shift_of(site);
  question.period_from_start = arguments.period_from == "start";
  if (arguments.marginal > arguments.go)
    throw Error(ErrorKind::usage, "found --marginal above --go, expected at most as much");
  question.rule = {arguments.go, arguments.marginal};
  question.threads = arguments.threads > 0 ? arguments.threads : cores();
  question.practice = practice_of(arguments.alpha, site, context, question.threads);
  return question;
}

std::optional<FlyWindows> flights_wanted(const WindowsArguments& arguments) {
  if (arguments.fly.empty()) return std::nullopt;
  FlyWindows settings;
  settings.most_wall_s = std::chrono::duration<double>(positive("--fly", arguments.fly)).count();
  settings.every = positive("--fly-every", arguments.fly_every);
  return settings;
}

WindowsQuestion plain_question(const Site& site, const std::string& named) {
  WindowsQuestion question;
  question.site = named;
  question.zone = site.time_zone;
  question.shift = shift_of(site);
  question.practice = AlphaPractice::of_tables({});
  question.threads = cores();
  return question;
}

int exit_code_of(twin::Verdict verdict) noexcept { return 10 + static_cast<int>(verdict); }

}  // namespace slackwater::api
