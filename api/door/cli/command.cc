#include "api/door/cli/command.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "api/program/version.h"
#include "fields/base/advice.h"

namespace slackwater::api {
namespace {

int report(const Context& context, ErrorKind kind, const std::string& message) {
  if (context.json && !context.answered) {
    const nlohmann::json problem = {
        {"error", {{"kind", std::string(name_of(kind))}, {"message", message}}}};
    std::printf("%s\n",
                problem.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  }
  std::fprintf(stderr, "slackwater: %s\n", message.c_str());
  return exit_code(kind);
}

/// The command that the words led to, as far as they are known.
const CLI::App& deepest(const CLI::App& app) {
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  return parsed.empty() ? app : deepest(*parsed.front());
}

/// The options of a command and of those above it.
void add_options(const CLI::App* app, std::vector<std::string>& known) {
  for (; app != nullptr; app = app->get_parent()) {
    for (const CLI::Option* option : app->get_options())
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  }
}

/// The words that could have stood where an unknown one does.
std::vector<std::string> known_words(const CLI::App& app, const std::string& unknown) {
  std::vector<std::string> known;
  const CLI::App& command = deepest(app);
  if (unknown.starts_with('-')) {
    add_options(&command, known);
  } else {
    for (const CLI::App* below : command.get_subcommands({})) known.push_back(below->get_name());
  }
  return known;
}

/// An unknown word hides behind what it leaves missing.
std::string unknown_text(const CLI::App& app) {
  const std::vector<std::string> unknown = app.remaining(true);
  if (unknown.empty()) return {};
  const std::string word = unknown.front().substr(0, unknown.front().find('='));
  return "found '" + unknown.front() + "', which is not known here" +
         did_you_mean(word, known_words(app, word)) + "; ";
}

/// "; use a decimal point: write 48.85" where a number came with a comma.
std::string comma_text(const std::string& problem) {
  std::istringstream words(problem);
  for (std::string word; words >> word;)
    if (const auto meant = with_decimal_point(word))
      return "; use a decimal point: write " + *meant;
  return {};
}

}  // namespace

UtcTime Context::time_of(std::string_view option, const std::string& text) const {
  if (text != "now") return option_value(option, text, parse_utc);
  return std::chrono::time_point_cast<Duration>(
      std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()));
}

UtcTime Context::now() const {
  if (!at.empty()) return time_of("--at", at);
  return std::chrono::time_point_cast<Duration>(std::chrono::system_clock::now());
}

store::Store Context::open(store::OpenMode mode) const {
  return store::Store::open(store_folder, mode);
}

Duration history_from(const std::string& text) {
  const Duration history = option_value("--history", text, parse_duration);
  if (history < std::chrono::days(3) || history > std::chrono::days(730))
    throw Error(ErrorKind::usage, "found --history " + text + ", expected 3d to 730d");
  return history;
}

Duration horizon_from(const std::string& text) {
  const Duration horizon = option_value("--horizon", text, parse_duration);
  if (horizon < std::chrono::hours(1) || horizon > std::chrono::days(15)) {
    throw Error(ErrorKind::usage, "found --horizon " + text + ", expected 1h to 15d");
  }
  return horizon;
}

std::string made_by(const Context& context) {
  return format_utc(context.now()) + " by slackwater " + code_version();
}

int exit_code(ErrorKind kind) noexcept {
  switch (kind) {
    case ErrorKind::internal:
      return 1;
    case ErrorKind::usage:
      return 2;
    case ErrorKind::invalid_input:
      return 3;
    case ErrorKind::not_found:
      return 4;
    case ErrorKind::unavailable:
      return 5;
    case ErrorKind::not_converged:
      return 6;
  }
  return 1;
}

int run_command_line(int argc, const char* const* argv) {
  Context context;
  const char* folder = std::getenv("SLACKWATER_STORE");
  context.store_folder = folder != nullptr ? folder : "slackwater-store";
  CLI::App app{
      "Slackwater: tomorrow's current, wind and waves at an offshore site, and how good these "
      "forecasts have been."};
  app.name("slackwater");
  app.set_version_flag("--version", code_version());
  app.require_subcommand(1);
  app.fallthrough();
  app.add_option("--store", context.store_folder,
                 "folder of the store (default ./slackwater-store, or $SLACKWATER_STORE)");
  app.add_flag("--json", context.json,
               "print one JSON document instead of text (schemas: api/docs)");
  app.footer(
      "Every command takes --store DIR and --json.\n"
      "Exit codes: 0 ok, 1 internal, 2 usage, 3 invalid input, 4 not found, 5 unavailable, 6 not "
      "converged.\n"
      "A day at a site:  slackwater ingest FILES…  then  slackwater forecast --site S  then\n"
      "                  slackwater profile --site S --time 2025-03-10T06:00:00Z");
  add_ingest(app, context);
  add_fetch(app, context);
  add_forecast(app, context);
  add_hindcast(app, context);
  add_profile(app, context);
  add_sample(app, context);
  add_verify(app, context);
  add_store(app, context);
  add_site(app, context);
  add_simulate(app, context);
  add_live(app, context);
  add_replay(app, context);
  add_rehearse(app, context);
  add_score(app, context);
  add_render(app, context);
  add_vehicle(app, context);
  add_stage(app, context);
  add_windows(app, context);
  add_workability(app, context);
  add_climate(app, context);
  add_plan(app, context);
  add_report(app, context);
  add_decide(app, context);
  add_decisions(app, context);
  add_sessions(app, context);
  add_watch(app, context);
  add_ais(app, context);
  add_detect(app, context);
  add_serve(app, context);
  add_demo(app, context);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {  // --help, --version
    return app.exit(done);
  } catch (const CLI::ParseError& problem) {
    return report(context, ErrorKind::usage,
                  unknown_text(app) + problem.what() + comma_text(problem.what()) +
                      "; `slackwater --help` shows the commands");
  } catch (const Error& problem) {
    return report(context, problem.kind(), problem.message());
  } catch (const std::bad_alloc&) {
    return report(context, ErrorKind::unavailable,
                  "out of memory; give a smaller --bbox or fewer columns");
  } catch (const std::exception& problem) {
    return report(context, ErrorKind::internal,
                  std::string("internal error: ") + problem.what() +
                      "; please report it with the command you ran");
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    return report(context, ErrorKind::unavailable,
                  "writing the answer failed; a writable standard output was expected; check the "
                  "space where it goes");
  return context.exit_code;
}

}  // namespace slackwater::api
