#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <thread>

#include "api/ask/run/scenario_at_hand.h"
#include "api/door/cli/command.h"
#include "api/door/cli/dds_options.h"
#include "api/door/cli/output_file.h"
#include "api/door/cli/run/recorded_run.h"
#include "api/door/cli/run/recordings.h"
#include "api/door/cli/run/run_print.h"
#include "api/door/cli/see/sight_options.h"
#include "api/door/foxglove/broadcast.h"
#include "api/door/http/router.h"
#include "api/door/http/server.h"
#include "api/door/live/bag_traffic.h"
#include "api/door/live/live_run.h"
#include "api/door/live/topics/viewer_outlet.h"
#include "api/door/people/kept_session.h"
#include "api/door/people/session_routes.h"
#include "api/show/rehearse/run_page.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

struct LiveArguments {
  std::filesystem::path scenario;
  DdsChoice dds;
  double factor = 1;
  std::string when_host_fails = "take-back";
  std::vector<std::string> sensors;
  std::string by;  ///< a detector; empty: none
  SightChoice sight;
  std::vector<std::filesystem::path> recordings;
  std::vector<std::filesystem::path> played_commands;
  std::filesystem::path played_traffic;
  std::filesystem::path out;
  std::filesystem::path html;
  std::optional<int> viewer_port;
  std::optional<int> people_port;
  std::filesystem::path people_file;
  std::size_t threads = 1;
};

/// Set by SIGINT and SIGTERM.
std::atomic<bool> end_asked = false;
static_assert(std::atomic<bool>::is_always_lock_free);
void ask_to_end(int) { end_asked = true; }

/// Stops a run when it is asked to, paused or not.
class Stopper {
 public:
  explicit Stopper(twin::RunControl& control) {
    end_asked = false;
    std::signal(SIGINT, ask_to_end);
    std::signal(SIGTERM, ask_to_end);
    watch_ = std::jthread([&control](const std::stop_token& over) {
      while (!over.stop_requested() && !end_asked)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      if (end_asked) control.stop();
    });
  }

 private:
  std::jthread watch_;
};

void print_name(const twin::Agent& vehicle, const std::string& name) {
  std::fprintf(stderr, "  vehicle %-20s /%s/...\n", vehicle.name.c_str(), name.c_str());
}

/// The names under which the vehicles are found, where a client must know them.
void print_names(std::span<const twin::Agent> agents, const std::vector<std::string>& names,
                 const std::string& site, const LiveArguments& arguments) {
  if (arguments.dds.domain)
    std::fprintf(stderr, "DDS domain %d, ROS 2 names:\n", *arguments.dds.domain);
  for (std::size_t i = 0; i < names.size(); ++i) print_name(agents[i], names[i]);
  std::fprintf(stderr, "  site    %-20s /%s/...\n", site.c_str(), site.c_str());
  std::fflush(stderr);
}

live::LiveSettings settings_of(const LiveArguments& arguments, const twin::Scenario& scenario,
                               const ScenarioWater& water) {
  live::LiveSettings settings;
  settings.domain = arguments.dds.settings();
  if (arguments.when_host_fails == "halt") settings.when_host_fails = live::HostRule::halt;
  settings.on_trouble = tell_trouble;
  settings.on_newcomer = print_name;
  settings.played_commands = arguments.played_commands;
  settings.real_time_factor = arguments.factor;
  settings.site = site_of(scenario, water);
  return settings;
}

/// What people's viewers connect to; goes with the command.
struct Viewers {
  std::shared_ptr<foxglove::Broadcast> broadcast;
  std::unique_ptr<http::Server> server;
};

Viewers open_viewers(int port, const std::string& name) {
  Viewers viewers;
  viewers.broadcast = std::make_shared<foxglove::Broadcast>(name);
  http::Router router;
  router.add("GET", "/live", viewers.broadcast->route());
  http::ServerOptions options;
  options.port = static_cast<std::uint16_t>(port);
  options.read_only = true;
  viewers.server = std::make_unique<http::Server>(options, router);
  viewers.server->start();
  std::fprintf(stderr, "viewers: ws://127.0.0.1:%d/live\n", viewers.server->port());
  return viewers;
}

/// The session of people who take part, and its door; goes with the command.
struct People {
  std::unique_ptr<people::KeptSession> session;
  std::unique_ptr<http::Server> server;
};

/// The tokens are for whoever began it, and for nobody's log.
void print_tokens(const people::TokenBook& book) {
  for (const people::Grant& grant : book.grants())
    std::fprintf(stderr, "  %-10s %s  (%d at once, until %s)\n",
                 std::string(name_of(grant.role)).c_str(), grant.token.c_str(), grant.seats,
                 format_utc(grant.until).c_str());
}

/// @param recorded  where what people do is left for recordings
People open_session(const LiveArguments& arguments, const std::string& name, const Context& context,
                    std::shared_ptr<live::ActionPost> recorded) {
  People people;
  const bool is_drawn = arguments.people_file.empty();
  people::TokenBook book = is_drawn
                               ? people::TokenBook::drawn(context.now() + std::chrono::hours(24))
                               : people::TokenBook::read(arguments.people_file);
  if (is_drawn) {
    std::fprintf(stderr, "tokens:\n");
    print_tokens(book);
  }
  people::SessionSettings settings;
  settings.name = name;
  settings.now = [&context] { return context.now(); };
  settings.keep = [recorded = std::move(recorded)](const people::Action& row) {
    recorded->put(row);
  };
  people.session = std::make_unique<people::KeptSession>(std::move(settings), std::move(book),
                                                         context.store_folder, name, tell_trouble);
  http::Router router;
  people::add_routes(router, people.session->session());
  http::ServerOptions options;
  options.port = static_cast<std::uint16_t>(*arguments.people_port);
  options.read_only = true;  // what people do comes by the socket alone
  people.server = std::make_unique<http::Server>(options, router);
  people.server->start();
  std::fprintf(stderr, "people: http://127.0.0.1:%d/session\n", people.server->port());
  std::fflush(stderr);
  return people;
}

json played_json(const std::vector<live::PlayedBag>& played) {
  json all = json::array();
  for (const live::PlayedBag& bag : played) {
    all.push_back({{"path", bag.path.string()},
                   {"handed_in", bag.handed_in},
                   {"taken", bag.taken},
                   {"left_from_s", bag.left_from_s ? json(*bag.left_from_s) : json(nullptr)}});
  }
  return all;
}

json sensors_json(const std::vector<live::SensorTold>& told) {
  json all = json::array();
  for (const auto& [asked, made] : told)
    all.push_back({{"vehicle", asked.vehicle},
                   {"sensor", asked.sensor},
                   {"rate_hz", asked.rate_hz},
                   {"moments", made.moments},
                   {"seen", made.looks},
                   {"dropped", made.dropped},
                   {"unseen", made.unseen},
                   {"mean_ms", 1000 * made.mean_s()},
                   {"worst_ms", 1000 * made.worst_s}});
  return all;
}

/// @throws Error(usage) also where nobody could see anything of them
live::SensorsAsked sensors_of(const LiveArguments& arguments) {
  live::SensorsAsked asked{{}, arguments.sight, arguments.by};
  for (const std::string& text : arguments.sensors)
    asked.sensors.push_back(live::sensor_asked(text));
  const bool is_heard = arguments.dds.domain || arguments.viewer_port || arguments.people_port ||
                        !arguments.recordings.empty();
  if (!asked.sensors.empty() && !is_heard)
    throw Error(ErrorKind::usage,
                "--see: nobody would see it; say where it goes: --dds-domain, --record, "
                "--viewer-port or --people");
  if (asked.sensors.empty() && !asked.by.empty())
    throw Error(ErrorKind::usage,
                "--by: looks at what a camera sees; put one on a vehicle by --see");
  return asked;
}

void run_live(const LiveArguments& arguments, const Context& context) {
  const live::SensorsAsked see = sensors_of(arguments);
  expect_output("--out", arguments.out, {".nc"});
  expect_output("--html", arguments.html, {".html"});
  Recordings recordings(arguments.recordings);
  ScenarioAtHand at_hand = scenario_at_hand(arguments.scenario, context.store_folder);
  const twin::Scenario& scenario = at_hand.scenario;
  ScenarioWater& water = at_hand.water;
  if (!arguments.played_traffic.empty())
    live::add_bag_traffic(arguments.played_traffic, scenario, water);
  live::LiveSettings settings = settings_of(arguments, scenario, water);
  settings.see = see;
  Viewers viewers;
  if (arguments.viewer_port) {
    viewers = open_viewers(*arguments.viewer_port, scenario.name);
    settings.outlets.push_back(std::make_shared<live::ViewerOutlet>(viewers.broadcast));
  }
  People people;
  if (arguments.people_port) {
    settings.actions = std::make_shared<live::ActionPost>();
    people = open_session(arguments, scenario.name, context, settings.actions);
    settings.on_picture = [session = people.session->session()](const auto& picture) {
      session->take_picture(picture);
    };
  }
  std::unique_ptr<live::LiveRun> joined;
  std::unique_ptr<Stopper> stopper;
  RunChoice choice{arguments.threads, true, arguments.factor};
  choice.on_ready = [&](const RunInHand& hand) {
    for (auto& outlet : recordings.open(hand.run)) settings.outlets.push_back(std::move(outlet));
    joined = std::make_unique<live::LiveRun>(hand, settings);
    if (people.session) people.session->begin(hand);
    print_names(hand.run.agents(), joined->names(), settings.site, arguments);
    // Now, and not with the warnings at the end: clients may come with raw thrusters.
    print_notes(notes_of(hand.run.agents()));
    stopper = std::make_unique<Stopper>(hand.control);
  };
  if (people.session) choice.actions = [&people] { return people.session->actions(); };
  std::optional<live::Punctuality> punctuality;
  std::vector<live::PlayedBag> played;
  std::vector<live::SensorTold> seen;
  choice.on_over = [&] {
    stopper.reset();
    if (people.session) people.session->end();
    if (joined) seen = joined->end_sensors();
    if (joined) punctuality = joined->punctuality();
    if (joined) played = joined->played();
    joined.reset();
  };
  const ScenarioResult result = with_context(arguments.scenario.string(),
                                             [&] { return run_scenario(scenario, water, choice); });
  recordings.close();
  if (!arguments.out.empty()) {
    write_beside(arguments.out, [&](const std::filesystem::path& partial) {
      ingest::write_trajectories(result.file, partial);
    });
  }
  if (!arguments.html.empty()) {
    write_beside(arguments.html, [&](const std::filesystem::path& partial) {
      write_run_page(result.file, partial);
    });
  }
  for (const std::string& warning : result.warnings)
    std::fprintf(stderr, "slackwater: %s\n", warning.c_str());
  if (!context.json) {
    print_run(result, arguments.out);
    if (people.session && !arguments.out.empty())
      std::printf("to watch it again: slackwater watch %s\n", arguments.out.c_str());
    for (const live::PlayedBag& bag : played) std::printf("%s\n", bag.text().c_str());
    std::printf("%s\n", punctuality->text().c_str());
    for (const live::SensorTold& sensor : seen) std::printf("%s\n", sensor.text().c_str());
    recordings.expect_complete();
    return;
  }
  json out = run_json(result, scenario.name, water, arguments.out);
  out["punctuality"] = {{"steps", punctuality->steps()},
                        {"late_steps", punctuality->late_steps()},
                        {"worst_ms", 1000 * punctuality->worst_s()}};
  out["recordings"] = recordings.json();
  out["played"] = played_json(played);
  out["sensors"] = sensors_json(seen);
  std::printf("%s\n", out.dump(2, ' ', false, json::error_handler_t::replace).c_str());
  context.answered = true;
  recordings.expect_complete();
}

}  // namespace

void add_live(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<LiveArguments>();
  CLI::App* command = app.add_subcommand(
      "live", "Run a scenario at real time for robots and people: ROS 2 over DDS, bags, viewers");
  command->add_option("scenario", arguments->scenario, "YAML file")->required();
  add_dds_options(*command, arguments->dds,
                  "DDS domain, 0 to 232 (ROS_DOMAIN_ID); without it nothing is on DDS");
  command
      ->add_option("--real-time-factor", arguments->factor,
                   "times as fast as the clock, 0.1 and more; 0: as fast as it goes (default 1)")
      ->check([](const std::string& text) -> std::string {
        const double factor = std::strtod(text.c_str(), nullptr);
        return text == "0" || (factor >= 0.1 && factor <= 1e6)
                   ? ""
                   : "found " + text + ", expected 0 or a number from 0.1 to 1000000";
      });
  command
      ->add_option("--when-host-fails", arguments->when_host_fails,
                   "what happens to a vehicle whose agent or physics in another process is gone, "
                   "late or wrong (default take-back)")
      ->check(CLI::IsMember({"take-back", "halt"}));
  command->add_option("--see", arguments->sensors,
                      "a sensor on a vehicle: VEHICLE/SENSOR@RATE, of data/sensors, in Hz of the "
                      "run's time, as in rov/rov_camera@2; repeatable");
  command->add_option("--by", arguments->by,
                      "with --see: a detector of data/detectors looks at the pictures of cameras");
  add_sight_options(*command, arguments->sight);
  command->add_option("--record", arguments->recordings,
                      "bag of all messages: FILE.mcap, or a folder for rosbag2; repeatable");
  command->add_option("--play-commands", arguments->played_commands,
                      "bag whose commands are sent again at their times; repeatable");
  command->add_option("--play-traffic", arguments->played_traffic,
                      "bag whose vehicles pass by as vessels, on their recorded tracks");
  command->add_option("--out", arguments->out, "log as FILE.nc, for replay and score");
  command->add_option("--html", arguments->html, "page of plots as FILE.html");
  command
      ->add_option("--viewer-port", arguments->viewer_port,
                   "serve viewers (Foxglove WebSocket) on this port of 127.0.0.1; 0: any free one")
      ->check(CLI::Range(0, 65535));
  command
      ->add_option(
          "--people", arguments->people_port,
          "let people take part (page /session) on this port of 127.0.0.1; 0: any free one")
      ->check(CLI::Range(0, 65535));
  command->add_option("--people-file", arguments->people_file,
                      "their roles and tokens as FILE.yaml (default: fresh tokens, printed)");
  command->add_option("--threads", arguments->threads, "1 to 64 (default 1)")
      ->check(CLI::Range(1, 64));
  command->callback([arguments, &context] { run_live(*arguments, context); });
}

}  // namespace slackwater::api
