#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>

#include "api/door/cli/command.h"
#include "api/door/cli/dds_options.h"
#include "api/door/cli/serve/serve_health.h"
#include "api/door/cli/stop_signals.h"
#include "api/door/cli/traffic_options.h"
#include "api/door/desk/desk_routes.h"
#include "api/door/desk/interface_document.h"
#include "api/door/desk/page_routes.h"
#include "api/door/edr/service.h"
#include "api/door/http/monitoring.h"
#include "api/door/http/server.h"
#include "api/door/live/forecast_service.h"
#include "api/door/sessions/host_routes.h"
#include "api/door/sessions/interface_document.h"
#include "api/issued/issued_fields.h"
#include "api/program/paths.h"
#include "api/program/secret_file.h"
#include "api/program/version.h"
#include "fields/base/log.h"
#include "fields/base/spare_memory.h"

namespace slackwater::api {
namespace {

struct ServeArguments {
  std::string address = "127.0.0.1";
  int port = 8080;
  int threads = 2;
  std::string token_file;
  std::string monitoring = "everyone";
  std::string base_url;
  std::string stale_after, at;
  std::string sessions;
  std::vector<std::string> ais;
  AlarmWords alarm;
  DdsChoice dds;
};

/// The forecasts on DDS, where that was asked for.
std::unique_ptr<live::ForecastService> on_dds(const ServeArguments& arguments,
                                              const std::shared_ptr<IssuedFields>& forecasts,
                                              const Context& context) {
  auto settings = arguments.dds.settings();
  if (!settings) return nullptr;
  settings->on_trouble = [](const std::string& text) {
    log_event(LogLevel::warning, "dds", {{"problem", text}});
  };
  return std::make_unique<live::ForecastService>(*settings, forecasts,
                                                 [&context] { return context.now(); });
}

std::optional<std::string> token_of(const std::string& file) {
  if (file.empty()) return std::nullopt;
  expect_secret(file);
  std::ifstream stream(file);
  std::string token;
  std::getline(stream, token);
  if (!stream || token.size() < 16) {
    throw Error(ErrorKind::usage, "--token-file: found no token in " + file +
                                      "; expected one line of at least 16 characters");
  }
  return token;
}

/// A clock that shows this time now and goes on from there; the machine's where none is said.
std::function<UtcTime()> clock_from(const std::string& at, const Context& context) {
  if (at.empty()) return machine_time;
  const Duration behind = machine_time() - context.time_of("--at", at);
  return [behind] { return machine_time() - behind; };
}

Freshness freshness_from(const std::string& text, const std::function<UtcTime()>& now) {
  Freshness freshness;
  freshness.now = now;
  if (text.empty()) return freshness;
  freshness.stale_after = option_value("--stale-after", text, parse_duration);
  if (freshness.stale_after <= Duration(0)) {
    throw Error(ErrorKind::usage,
                "found --stale-after " + text + ", expected a time longer than 0, e.g. 36h or 2d");
  }
  return freshness;
}

/// As links begin with it: a scheme and no slash at its end.
std::string checked_base(std::string url) {
  while (url.ends_with('/')) url.pop_back();
  const bool is_plain = std::none_of(url.begin(), url.end(), [](char c) {
    return c <= ' ' || c > '~' || c == '"' || c == '<' || c == '>' || c == '?' || c == '#';
  });
  const bool has_scheme = url.starts_with("http://") || url.starts_with("https://");
  if (url.empty() || (is_plain && has_scheme)) return url;
  throw Error(ErrorKind::usage, "--base-url: found '" + url +
                                    "'; expected http:// or https:// and an address without '?' "
                                    "and '#', e.g. https://forecasts.example.org/edr");
}

/// The sessions of people, where a file says which may be begun.
std::shared_ptr<sessions::SessionHost> session_host(const ServeArguments& arguments,
                                                    const Context& context) {
  if (arguments.sessions.empty()) return nullptr;
  auto file = sessions::read_operator_file(arguments.sessions, context.store_folder);
  (void)context.open(store::OpenMode::create_or_write);  // runs in made-up water need no forecast
  return std::make_shared<sessions::SessionHost>(std::move(file), context.store_folder,
                                                 [&context] { return context.now(); });
}

/// The logs of AIS, where any were given.
desk::Listening listening(const ServeArguments& arguments) {
  desk::Listening to;
  to.rule = traffic_rule(arguments.alarm);
  if (!arguments.ais.empty())
    to.logs = std::make_shared<desk::FollowedLogs>(
        std::vector<std::filesystem::path>(arguments.ais.begin(), arguments.ais.end()));
  return to;
}

/// Others read along where there is no TLS, and anybody may read what is served.
void warn_of_others(const http::Server& server, const ServeArguments& arguments) {
  if (!server.lets_others_in()) return;
  const bool has_tokens = !arguments.token_file.empty() || !arguments.sessions.empty();
  log_event(LogLevel::warning, "open to other machines",
            {{"address", arguments.address},
             {"problem", has_tokens ? "without TLS: others on the network read along, tokens too"
                                    : "without TLS and without a password: whoever reaches this "
                                      "machine reads all that is served"},
             {"advice", "listen on 127.0.0.1, behind a proxy (behind_a_proxy.md)"}});
  if (http::monitoring_named(arguments.monitoring) == http::Monitoring::everyone)
    log_event(LogLevel::warning, "monitoring is open to other machines",
              {{"paths", "/health /metrics"},
               {"advice", "--monitoring health, local or nobody (http.md)"}});
}

http::MonitoringHandlers monitoring_handlers(const std::shared_ptr<IssuedFields>& forecasts,
                                             const Freshness& freshness,
                                             const std::shared_ptr<const http::Metrics>& metrics) {
  const auto health = [forecasts, freshness] { return health_of(*forecasts, freshness); };
  const auto gauges = [forecasts, freshness] {
    return forecast_gauges(*forecasts->catalogue(), freshness);
  };
  return {http::health_handler(code_version(), metrics, health),
          http::health_handler(code_version(), metrics, health, http::Asker::monitor),
          http::metrics_handler(metrics, gauges)};
}

/// As many stations at each session as a server of one session takes.
http::Limits limits_for(std::size_t sessions_at_once) {
  http::Limits limits;
  limits.websockets *= sessions_at_once;
  limits.connections += limits.websockets;
  return limits;
}

void run_serve(const ServeArguments& arguments, const Context& context) {
  hold_little_spare_memory();
  const std::string base_url = checked_base(arguments.base_url);
  const http::Monitoring monitoring = http::monitoring_named(arguments.monitoring);
  const Freshness freshness =
      freshness_from(arguments.stale_after, clock_from(arguments.at, context));
  const StopSignals stop;
  http::ServerOptions options;
  options.address = arguments.address;
  options.port = static_cast<std::uint16_t>(arguments.port);
  options.threads = static_cast<std::size_t>(arguments.threads);
  options.token = token_of(arguments.token_file);
  options.read_only = true;  // but for the paths that take POST
  options.exposed_fields = edr::own_header_fields();
  options.on_failure = [](const http::Request& request, const std::string& what) {
    log_event(LogLevel::error, "request failed", {{"path", request.path}, {"problem", what}});
  };
  const auto people = session_host(arguments, context);
  const auto forecasts = std::make_shared<IssuedFields>(context.store_folder);
  http::Router router;
  edr::Beside beside{desk::interface_document(), desk::front_page};
  desk::add_page_routes(router);
  desk::add_routes(router, {forecasts, freshness, context.store_folder, data_folder(),
                            static_cast<std::size_t>(arguments.threads), arguments.at.empty(),
                            listening(arguments)});
  if (people) {
    beside.interface.merge_patch(sessions::interface_document());
    sessions::add_routes(router, people);
    options.guards_itself = sessions::is_for_supervisors;
    options.limits = limits_for(people->most_at_once());
  }
  beside.interface.merge_patch(http::monitoring_document(monitoring));
  edr::add_routes(router, forecasts, base_url, freshness, beside);
  std::vector<std::string> labels = router.labels();
  labels.insert(labels.end(), {"/health", "/health/fresh", "/metrics"});
  options.metrics = std::make_shared<http::Metrics>(labels);
  http::add_monitoring_routes(router, monitoring,
                              monitoring_handlers(forecasts, freshness, options.metrics));
  options.methods_at = [router](const std::string& path) { return router.methods_at(path); };
  const auto dds_service = on_dds(arguments, forecasts, context);
  http::Server server(options, router);
  warn_of_others(server, arguments);
  server.start();
  if (people) people->begin_at_start();
  const std::string url =
      "http://" +
      (arguments.address.find(':') == std::string::npos ? arguments.address
                                                        : "[" + arguments.address + "]") +
      ":" + std::to_string(server.port());
  if (context.json) {
    std::printf("{\"url\":\"%s\",\"port\":%d}\n", url.c_str(), server.port());
  } else {
    std::printf("Slackwater at %s/ (%zu forecasts); Ctrl-C ends it\n", url.c_str(),
                forecasts->catalogue()->instances.size());
    if (people) std::printf("people: %s/session\n", url.c_str());
  }
  std::fflush(stdout);
  log_event(LogLevel::info, "serving", {{"url", url}, {"store", context.store_folder.string()}});
  stop.wait();
  if (people) people->stop();  // while there is a server to say farewell with
  server.stop();
  log_event(LogLevel::info, "stopped");
}

}  // namespace

void add_serve(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand(
      "serve", "Issued forecasts over HTTP: OGC API-EDR 1.1, health and metrics");
  auto arguments = std::make_shared<ServeArguments>();
  command->add_option("--address", arguments->address,
                      "numeric address to listen on (default 127.0.0.1: this machine alone)");
  command->add_option("--port", arguments->port, "port; 0 takes any that is free (default 8080)")
      ->check(CLI::Range(0, 65535));
  command
      ->add_option("--threads", arguments->threads,
                   "that answer requests, and as many more for long answers (default 2)")
      ->check(CLI::Range(1, 64));
  command->add_option("--token-file", arguments->token_file,
                      "file with the token that whoever writes from afar must show");
  command->add_option(
      "--monitoring", arguments->monitoring,
      "who may ask /health and /metrics: everyone; health: everyone /health, and /metrics as with "
      "local; local: clients on this machine, not through a proxy, and who shows the token; nobody "
      "(default everyone)");
  command->add_option(
      "--base-url", arguments->base_url,
      "address as clients see it, e.g. behind a proxy (default: the Host header, where "
      "that is a number or localhost; else links have no host)");
  command->add_option("--stale-after", arguments->stale_after,
                      "a forecast older than this is called stale by /, /health and /metrics "
                      "(default 36h)");
  command->add_option("--at", arguments->at,
                      "show this time and go on from there, UTC, for training and tests (default: "
                      "the machine's clock)");
  command
      ->add_option("--ais", arguments->ais,
                   "log of AIS that a receiver writes, as `ais` reads it: its vessels stand on "
                   "the desk's map; again for more")
      ->allow_extra_args(false);
  add_alarm_options(*command, arguments->alarm);
  command->add_option("--sessions", arguments->sessions,
                      "live sessions that people may begin and take part in (page /session), and "
                      "their tokens, as FILE.yaml");
  add_dds_options(*command, arguments->dds,
                  "also on DDS: the water of each site as forecast for now, ROS 2 names; domain 0 "
                  "to 232");
  command->callback([arguments, &context] { run_serve(*arguments, context); });
}

}  // namespace slackwater::api
