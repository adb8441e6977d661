#include "api/ask/decisions/decide.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/door/cli/windows_options.h"
#include "api/program/paths.h"
#include "api/show/decisions/decision_words.h"
#include "api/show/decisions/decisions_json.h"

namespace slackwater::api {
namespace {

struct DecideArguments {
  std::string site, task, turbine, start, by, note, hand_over;
  bool is_go = false, is_no_go = false;
};

void run_decide(const DecideArguments& arguments, const Context& context) {
  if (arguments.is_go == arguments.is_no_go)
    throw Error(ErrorKind::usage, std::string("found ") +
                                      (arguments.is_go ? "both --go and --no-go" : "no decision") +
                                      ", expected one of --go and --no-go");
  const Site site = find_site(arguments.site, site_folders(context.store_folder));
  DecideQuestion question;
  question.windows = plain_question(site, arguments.site);
  question.task = arguments.task;
  question.turbine = arguments.turbine;
  question.start = option_value("--start", arguments.start, parse_utc);
  question.decided = arguments.is_go ? store::Decided::go : store::Decided::no_go;
  question.by = arguments.by;
  question.note = arguments.note;
  question.hand_over = arguments.hand_over;
  question.recorded_at = std::chrono::floor<std::chrono::seconds>(context.now());
  question.by_clock = context.at.empty();
  question.before_names = "--";
  DecisionMade made = decision_made(question, context.store_folder);
  file_decision(made, context.store_folder);
  if (context.json)
    std::printf(
        "%s\n",
        recorded_json(made).dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  else
    std::fputs(recorded_text(made).c_str(), stdout);
}

}  // namespace

void add_decide(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<DecideArguments>();
  CLI::App* command = app.add_subcommand(
      "decide", "Record who decided what about a start, and on which forecast; for good");
  command->add_option("--site", arguments->site, "id, or path of a site file")->required();
  command->add_option("--task", arguments->task, "id of data/tasks or a file")->required();
  command->add_option("--turbine", arguments->turbine,
                      "where (default: the first that the task can be done at)");
  command->add_option("--start", arguments->start, "of the work, UTC time, e.g. 2025-03-10T07:30Z")
      ->required();
  command->add_flag("--go", arguments->is_go, "it is begun then");
  command->add_flag("--no-go", arguments->is_no_go, "it is not");
  command->add_option("--by", arguments->by, "name of who decided, up to 200 characters")
      ->required();
  command->add_option("--note", arguments->note, "why, up to 2000 characters");
  command->add_option("--hand-over", arguments->hand_over,
                      "what the next shift is to know, up to 2000 characters");
  command->add_option("--at", context.at,
                      "when it was decided, UTC time; the record says that this was stated "
                      "(default: the clock)");
  command->callback([arguments, &context] { run_decide(*arguments, context); });
}

}  // namespace slackwater::api
