#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/door/cli/stop_signals.h"
#include "api/door/http/server.h"
#include "api/door/people/playback/playback_routes.h"
#include "api/program/paths.h"

namespace slackwater::api {
namespace {

struct WatchArguments {
  std::filesystem::path log, forecast;
  int port = 8091;
};

void run_watch(const WatchArguments& arguments, const Context& context) {
  const StopSignals stop;
  people::LoggedRun run = people::read_logged_run(arguments.log, data_folder());
  std::optional<std::filesystem::path> forecast;
  if (!arguments.forecast.empty()) forecast = arguments.forecast;
  people::FoundSurround found =
      people::find_surround(arguments.log, context.store_folder, forecast);
  if (!found.missing.empty())
    run.warnings.push_back("its waves, wind, current, turbines and traffic are not shown: " +
                           found.missing);
  for (const std::string& warning : run.warnings)
    std::fprintf(stderr, "slackwater: %s\n", warning.c_str());
  const std::size_t actions = run.actions.size();
  const double lasts_s = run.to_s() - run.from_s();
  const auto playback = std::make_shared<people::Playback>(std::move(run), std::move(found));
  http::Router router;
  people::add_routes(router, playback);
  http::ServerOptions options;
  options.port = static_cast<std::uint16_t>(arguments.port);
  options.read_only = true;
  http::Server server(options, router);
  server.start();
  const std::string url = "http://127.0.0.1:" + std::to_string(server.port()) + "/session";
  if (context.json) {
    std::printf("%s\n", nlohmann::json{{"url", url}, {"port", server.port()}}.dump().c_str());
    context.answered = true;
  } else {
    std::printf("watch: %s (%.0f s, %zu actions); Ctrl-C ends it\n", url.c_str(), lasts_s, actions);
  }
  std::fflush(stdout);
  stop.wait();
  playback->end();
  playback->wait_for_farewells(std::chrono::seconds(1));
  server.stop();
}

}  // namespace

void add_watch(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<WatchArguments>();
  CLI::App* command = app.add_subcommand(
      "watch", "Watch the log of a run again in the page /session, with a scrubber");
  command->add_option("log", arguments->log, "FILE.nc of live or simulate --out")->required();
  command->add_option("--forecast", arguments->forecast,
                      "file of the forecast it ran in (default: found in the store)");
  command
      ->add_option("--port", arguments->port,
                   "port of 127.0.0.1; 0 takes any that is free (default 8091)")
      ->check(CLI::Range(0, 65535));
  command->callback([arguments, &context] { run_watch(*arguments, context); });
}

}  // namespace slackwater::api
