#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/ask/history/campaign_file.h"
#include "api/ask/history/sea_limit.h"
#include "api/door/cli/sea/history_options.h"
#include "api/program/paths.h"
#include "api/show/history/campaign_answer.h"
#include "api/show/history/workability_answer.h"

namespace slackwater::api {
namespace {

struct WorkabilityArguments {
  HistoryArguments history;
  std::vector<std::string> limits;
  std::string duration;
  std::string contingency;
  std::string start_hours;
  std::filesystem::path campaign;
  std::string daylight;
  std::string time_zone;
};

[[noreturn]] void refuse(const std::string& why) { throw Error(ErrorKind::usage, why); }

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

void run_question(const WorkabilityArguments& arguments, const Context& context,
                  const ingest::Vocabulary& vocabulary) {
  const HistorySource source = source_of(arguments.history, context);
  const WorkabilityQuestion question = question_of(arguments);
  const std::vector<std::string> idle = expect_possible(question.limits, vocabulary);
  History history = load_history(source, question.limits, vocabulary);
  history.notes.insert(history.notes.end(), idle.begin(), idle.end());
  const WorkabilityAnswer answer = answer_of(history, question, vocabulary);
  print_history_answer(workability_json(history, question, answer, vocabulary),
                       workability_text(history, question, answer), context);
}

void run_campaign(const WorkabilityArguments& arguments, const Context& context,
                  const ingest::Vocabulary& vocabulary) {
  if (!arguments.limits.empty() || !arguments.duration.empty() || !arguments.contingency.empty() ||
      !arguments.start_hours.empty() || !arguments.time_zone.empty() || !arguments.daylight.empty())
    refuse(
        "found --campaign beside --limit, --duration, --contingency, --start-hours, --daylight or "
        "--timezone; a campaign's file says these itself");
  const HistorySource source = source_of(arguments.history, context);
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
  print_history_answer(campaign_json(history, campaign, answer),
                       campaign_text(history, campaign, answer), context);
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
  add_history_series(*command, arguments->history);
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
  add_history_place(*command, arguments->history);
  command->add_option("--timezone", arguments->time_zone,
                      "of the hours, months and years, e.g. Europe/Berlin (default UTC)");
  command->add_option("--campaign", arguments->campaign,
                      "FILE.yaml of tasks done one after the other, instead of --limit");
  add_history_options(*command, arguments->history);
  command->callback([arguments, &context] { run_workability(*arguments, context); });
}

}  // namespace slackwater::api
