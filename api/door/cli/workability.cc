#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/ask/history/campaign_file.h"
#include "api/ask/history/history.h"
#include "api/ask/history/sea_limit.h"
#include "api/door/cli/command.h"
#include "api/program/paths.h"
#include "api/show/history/campaign_answer.h"
#include "api/show/history/workability_answer.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

struct WorkabilityArguments {
  std::vector<std::filesystem::path> files;
  std::string site;
  std::vector<std::string> limits;
  std::string duration;
  std::string contingency;
  std::string start_hours;
  std::filesystem::path campaign;
  std::vector<std::string> columns;
  std::string time_column;
  bool assume_utc = false;
  std::optional<double> depth_m;
  std::vector<double> missing;
  std::string daylight;
  std::optional<double> latitude;
  std::optional<double> longitude;
  std::string time_zone;
  std::string from;
  std::string to;
};

[[noreturn]] void refuse(const std::string& why) { throw Error(ErrorKind::usage, why); }

HistorySource source_of(const WorkabilityArguments& arguments, const Context& context) {
  HistorySource source;
  source.files = arguments.files;
  source.site = arguments.site;
  source.store_folder = context.store_folder;
  if (source.files.empty() == source.site.empty())
    refuse(source.files.empty() ? "found no series; expected files, or --site S for those stored"
                                : "found files and --site; expected one of them");
  for (const std::string& text : arguments.columns)
    source.options.columns.push_back(ingest::parse_named_column(text));
  source.options.time_column = arguments.time_column;
  source.options.assume_utc = arguments.assume_utc;
  source.options.depth_m = arguments.depth_m;
  source.options.missing = arguments.missing;
  if (!source.options.missing.empty() && !source.site.empty())
    refuse("found --missing beside --site; what is stored has its missing values already");
  if (arguments.latitude.has_value() != arguments.longitude.has_value())
    refuse("found one of --lat and --lon, expected both or neither");
  if (arguments.latitude)
    source.place = option_value("--lat, --lon", std::string(), [&](const std::string&) {
      return GeoPoint::from_degrees(*arguments.latitude, *arguments.longitude);
    });
  if (!arguments.from.empty()) source.from = option_value("--from", arguments.from, parse_day);
  if (!arguments.to.empty()) source.to = option_value("--to", arguments.to, parse_day);
  if (source.from && source.to && *source.to < *source.from)
    refuse("found --from " + arguments.from + " after --to " + arguments.to);
  return source;
}

WorkabilityQuestion question_of(const WorkabilityArguments& arguments) {
  WorkabilityQuestion question;
  if (arguments.limits.empty())
    refuse(
        "found no --limit; expected one or more, e.g. --limit "
        "'sea_surface_wave_significant_height<=1.5', or --campaign FILE.yaml");
  for (const std::string& text : arguments.limits)
    question.limits.push_back(is_limit_file(text)
                                  ? read_series_limit(text, std::filesystem::current_path())
                                  : option_value("--limit", text, parse_series_limit));
  if (arguments.duration.empty()) refuse("found no --duration; expected e.g. --duration 12h");
  question.duration = option_value("--duration", arguments.duration, parse_duration);
  if (question.duration <= Duration(0))
    refuse("found --duration " + arguments.duration + ", expected more than 0");
  if (!arguments.contingency.empty())
    question.contingency = option_value("--contingency", arguments.contingency, parse_duration);
  if (!arguments.start_hours.empty())
    question.start_hours =
        option_value("--start-hours", arguments.start_hours, twin::parse_day_hours);
  if (!arguments.daylight.empty())
    question.daylight = option_value("--daylight", arguments.daylight, twin::parse_light);
  if (!arguments.time_zone.empty())
    question.zone = option_value("--timezone", arguments.time_zone,
                                 [](const std::string& name) { return TimeZone::named(name); });
  return question;
}

void print(const json& document, const std::string& text, const Context& context) {
  if (context.json) {
    std::printf("%s\n", document.dump(2, ' ', false, json::error_handler_t::replace).c_str());
    return;
  }
  std::fputs(text.c_str(), stdout);
  for (const json& note : document.at("notes"))
    std::fprintf(stderr, "slackwater: %s\n", note.get<std::string>().c_str());
}

void run_question(const WorkabilityArguments& arguments, const Context& context,
                  const ingest::Vocabulary& vocabulary) {
  const HistorySource source = source_of(arguments, context);
  const WorkabilityQuestion question = question_of(arguments);
  const std::vector<std::string> idle = expect_possible(question.limits, vocabulary);
  History history = load_history(source, question.limits, vocabulary);
  history.notes.insert(history.notes.end(), idle.begin(), idle.end());
  const WorkabilityAnswer answer = answer_of(history, question, vocabulary);
  print(workability_json(history, question, answer, vocabulary),
        workability_text(history, question, answer), context);
}

void run_campaign(const WorkabilityArguments& arguments, const Context& context,
                  const ingest::Vocabulary& vocabulary) {
  if (!arguments.limits.empty() || !arguments.duration.empty() || !arguments.contingency.empty() ||
      !arguments.start_hours.empty() || !arguments.time_zone.empty() || !arguments.daylight.empty())
    refuse(
        "found --campaign beside --limit, --duration, --contingency, --start-hours, --daylight or "
        "--timezone; a campaign's file says these itself");
  const HistorySource source = source_of(arguments, context);
  const CampaignFile campaign = load_campaign(arguments.campaign);
  std::vector<std::string> idle;
  for (const CampaignTaskText& task : campaign.tasks) {
    for (const std::string& note : expect_possible(task.limits, vocabulary)) {
      if (std::find(idle.begin(), idle.end(), note) == idle.end()) idle.push_back(note);
    }
  }
  History history = load_history(source, campaign.limits(), vocabulary);
  history.notes.insert(history.notes.end(), idle.begin(), idle.end());
  const CampaignAnswer answer = answer_of(history, campaign, vocabulary);
  print(campaign_json(history, campaign, answer), campaign_text(history, campaign, answer),
        context);
}

void run_workability(const WorkabilityArguments& arguments, const Context& context) {
  const ingest::Vocabulary vocabulary =
      ingest::Vocabulary::load(data_folder() / "products" / "variables.yaml");
  if (arguments.campaign.empty())
    run_question(arguments, context, vocabulary);
  else
    run_campaign(arguments, context, vocabulary);
}

}  // namespace

void add_workability(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<WorkabilityArguments>();
  CLI::App* command = app.add_subcommand(
      "workability",
      "Window statistics of a history: how often a task can start, and how long one waits");
  command->add_option("series", arguments->files,
                      "CSV tables or CF NetCDF files, each of one place; several are joined");
  command->add_option("--site", arguments->site,
                      "instead of files: what the store holds at a site, analysed and observed");
  command
      ->add_option(
          "--limit", arguments->limits,
          "'NAME<=VALUE UNIT', as often as wanted; NAME a CF standard name or a column; or "
          "FILE.yaml, bounds on wave heights by period and heading")
      ->allow_extra_args(false);
  command->add_option("--duration", arguments->duration, "that the task takes, e.g. 12h or 90min");
  command->add_option("--contingency", arguments->contingency,
                      "more that a window has to last (default 0h)");
  command->add_option("--start-hours", arguments->start_hours,
                      "6-18: a task begins from 06:00 on and before 18:00");
  command->add_option("--daylight", arguments->daylight,
                      "sun_up, civil or nautical: the task is done in that light; needs a place");
  command->add_option("--lat", arguments->latitude, "of the place, degrees north");
  command->add_option("--lon", arguments->longitude, "of the place, degrees east");
  command->add_option("--timezone", arguments->time_zone,
                      "of the hours, months and years, e.g. Europe/Berlin (default UTC)");
  command->add_option("--campaign", arguments->campaign,
                      "FILE.yaml of tasks done one after the other, instead of --limit");
  command
      ->add_option("--column", arguments->columns,
                   "NAME=STANDARD_NAME:UNIT, what a column is; as often as wanted")
      ->allow_extra_args(false);
  command->add_option("--time-column", arguments->time_column, "the column of times");
  command->add_flag("--assume-utc", arguments->assume_utc, "times without a zone are UTC");
  command->add_option("--depth", arguments->depth_m, "metres below the surface, of currents")
      ->check(CLI::Range(0.0, 12000.0));
  command
      ->add_option("--missing", arguments->missing,
                   "a number that stands for 'not measured', e.g. 99; as often as wanted")
      ->allow_extra_args(false);
  command->add_option("--from", arguments->from, "first day, e.g. 2002-01-01");
  command->add_option("--to", arguments->to, "last day");
  command->callback([arguments, &context] { run_workability(*arguments, context); });
}

}  // namespace slackwater::api
