#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/door/cli/progress.h"
#include "api/door/cli/windows_options.h"
#include "api/show/windows/windows_answer.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

/// Flies the starts that are left open, for as long as was asked for.
void fly_within(const FlyWindows& settings, const WindowsQuestion& question, const Context& context,
                WindowsAnswer& answer) {
  if (!context.json) std::fputs(windows_text(question, answer).c_str(), stderr);
  ProgressBar progress("flying " + answer.site_name, context.json);
  fly_windows(question, settings, context.store_folder, answer,
              [&](double share) { progress.update(share); });
}

void run_windows(const WindowsArguments& arguments, const Context& context) {
  const WindowsQuestion question = windows_question(arguments, context);
  const auto flights = flights_wanted(arguments);
  WindowsAnswer answer = windows_of(question, context.store_folder);
  if (flights) fly_within(*flights, question, context, answer);
  if (context.json)
    std::printf(
        "%s\n",
        windows_json(question, answer).dump(2, ' ', false, json::error_handler_t::replace).c_str());
  else
    std::fputs(windows_text(question, answer).c_str(), stdout);
  for (const std::string& note : answer.notes)
    std::fprintf(stderr, "slackwater: %s\n", note.c_str());
  if (arguments.verdict_exit) context.exit_code = exit_code_of(answer.verdict);
}

}  // namespace

void add_windows(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<WindowsArguments>();
  CLI::App* command = app.add_subcommand(
      "windows", "When a task can be begun: access windows with probabilities and what binds");
  add_windows_options(*command, *arguments);
  command->callback([arguments, &context] { run_windows(*arguments, context); });
}

}  // namespace slackwater::api
