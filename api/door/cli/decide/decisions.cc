#include "api/ask/decisions/decisions.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/door/cli/output_file.h"
#include "api/door/cli/windows_options.h"
#include "api/program/paths.h"
#include "api/show/decisions/decision_words.h"
#include "api/show/decisions/decisions_csv.h"
#include "api/show/decisions/decisions_json.h"
#include "fields/base/whole_file.h"

namespace slackwater::api {
namespace {

struct DecisionsArguments {
  std::string site, task, from, csv;
};

void run_decisions(const DecisionsArguments& arguments, const Context& context) {
  expect_output("--csv", arguments.csv, {".csv"});
  const Site site = find_site(arguments.site, site_folders(context.store_folder));
  DecisionsQuestion question;
  question.windows = plain_question(site, arguments.site);
  question.task = arguments.task;
  if (!arguments.from.empty())
    question.from = UtcTime(option_value("--from", arguments.from, parse_day));
  question.known_by = context.now();
  const DecisionsAnswer answer = decisions_of(question, context.store_folder);
  if (!arguments.csv.empty()) write_text(arguments.csv, decisions_csv(answer));
  if (context.json)
    std::printf("%s\n", decisions_json(answer)
                            .dump(2, ' ', false, nlohmann::json::error_handler_t::replace)
                            .c_str());
  else
    std::fputs(decisions_text(answer).c_str(), stdout);
}

}  // namespace

void add_decisions(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<DecisionsArguments>();
  CLI::App* command = app.add_subcommand(
      "decisions", "What was decided by whom on which forecast, and what came of it");
  command->add_option("--site", arguments->site, "id, or path of a site file")->required();
  command->add_option("--task", arguments->task, "only of this one: id of data/tasks or a file");
  command->add_option("--from", arguments->from, "only starts from this day on");
  command->add_option("--csv", arguments->csv, "also as FILE.csv, a row each");
  command->add_option("--at", context.at,
                      "what came is what was known by then, UTC time (default: the clock)");
  command->callback([arguments, &context] { run_decisions(*arguments, context); });
}

}  // namespace slackwater::api
