#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "api/ask/rehearse/fly_mission.h"
#include "api/ask/rehearse/risks.h"
#include "api/ask/rehearse/unchecked.h"
#include "api/door/cli/command.h"
#include "api/door/cli/output_file.h"
#include "api/door/cli/progress.h"
#include "api/show/rehearse/adapt_mission.h"
#include "api/show/rehearse/advice_report.h"
#include "api/show/rehearse/cleaning_report.h"
#include "api/show/rehearse/inspection_report.h"
#include "api/show/rehearse/rehearsal_file.h"
#include "api/show/rehearse/rehearsal_json.h"
#include "api/show/rehearse/rehearsal_page.h"
#include "api/show/rehearse/risk_report.h"
#include "fields/base/check.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"
#include "ingest/cf/trajectory_file.h"
#include "twin/chance/rank_rule.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

/// Futures in which a mission is flown otherwise, for advice.
constexpr std::size_t most_advised = 24;
/// Exit code of `--adapted` where there is none, that of a no-go in `windows`.
constexpr int exit_do_not_fly = 12;

struct RehearseArguments {
  std::filesystem::path mission;
  std::size_t members = 0;
  std::vector<std::string> starts;
  std::string every;
  std::size_t count = 1;
  double narrow_enough = 0;
  std::vector<std::string> assume;
  std::string waves;
  int threads = 0;
  std::filesystem::path out, html, scenario, log;
  std::string log_start;
  bool advice = false;
  bool adapt_intensity = false;
  std::filesystem::path adapted;
  std::size_t log_member = 0;
};

/// `--start` as often as given, or `--every` and `--starts` from the first one on.
std::vector<UtcTime> starts_of(const RehearseArguments& arguments, const LoadedMission& mission,
                               const Context& context) {
  std::vector<UtcTime> starts;
  for (const std::string& text : arguments.starts)
    starts.push_back(context.time_of("--start", text));
  if (starts.empty())
    starts.push_back(mission.scenario.start.value_or(mission.water.surround.field->range().from));
  if (arguments.count > 1) {
    if (starts.size() > 1)
      throw Error(ErrorKind::usage, "--starts: give one --start to count from, or list them all");
    const Duration every =
        option_value("--every", arguments.every.empty() ? "1h" : arguments.every,
                     [](const std::string& text) { return parse_duration(text); });
    for (std::size_t i = 1; i < arguments.count; ++i)
      starts.push_back(starts.front() + static_cast<Duration::rep>(i) * every);
  }
  return starts;
}

/// The flight that is to be logged. @throws Error(usage) where it is not among those flown
std::optional<twin::FlightCase> logged_of(const RehearseArguments& arguments,
                                          const RehearsalPlan& plan, const Context& context) {
  if (arguments.log.empty()) return std::nullopt;
  const UtcTime start = arguments.log_start.empty()
                            ? plan.starts.front()
                            : context.time_of("--log-start", arguments.log_start);
  if (std::find(plan.starts.begin(), plan.starts.end(), start) == plan.starts.end())
    throw Error(ErrorKind::usage, "--log-start: found " + format_utc(start) +
                                      ", expected one of the starts that are flown");
  if (arguments.log_member >= plan.members)
    throw Error(ErrorKind::usage, formatted("--log-member: found {}, expected 0 to {}, those that "
                                            "are flown",
                                            arguments.log_member, plan.members - 1));
  return twin::FlightCase{start, arguments.log_member};
}

/// A mission's files count from its folder, and those of a mission made from it too.
void expect_beside(const RehearseArguments& arguments) {
  const auto folder_of = [](const std::filesystem::path& file) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file).parent_path());
  };
  if (arguments.adapted.empty() || folder_of(arguments.adapted) == folder_of(arguments.mission))
    return;
  throw Error(ErrorKind::usage, "--adapted: found " + arguments.adapted.string() +
                                    ", expected a file beside " + arguments.mission.string() +
                                    ", because file names in a mission are relative to its folder; "
                                    "copy the mission to the other folder first");
}

/// The best start of those that may be flown.
UtcTime best_allowed(const Rehearsal& rehearsal) {
  const StartOutcome* best = nullptr;
  for (const StartOutcome& start : rehearsal.starts)
    if (start.forbidden.empty() &&
        (best == nullptr || start.success.share() > best->success.share()))
      best = &start;
  expects(best != nullptr, "best_allowed: some start was flown");
  return best->start;
}

/// How closely the best start can look, flown in all futures.
AdaptedStart adapted_start(const RehearseArguments& arguments, const Context& context,
                           const std::vector<twin::Assumption>& assumed,
                           std::optional<bool> height_errors, const LoadedMission& mission,
                           const RehearsalPlan& plan, UtcTime start) {
  const Config read = Config::load(arguments.mission);
  const auto folder = std::filesystem::absolute(arguments.mission).parent_path();
  twin::IntensityQuestion question;
  question.start = start;
  for (std::size_t member = 0; member < plan.members; ++member) question.members.push_back(member);
  question.threads = plan.threads;
  question.flights = plan.flights;
  AdaptedStart out{start, question.keep_share, {}};
  out.choice = with_context("--adapt-intensity", [&] {
    return twin::adapt_intensity(
        [&](const twin::Intensity& thinned_by) {
          return lay_out_mission(read, folder, context.store_folder, assumed, height_errors,
                                 thinned_by)
              .scenario;
        },
        mission.water.surround, question);
  });
  if (!arguments.adapted.empty() && out.choice.chosen)
    write_text(arguments.adapted, adapted_mission_yaml(read, mission.expanded.workers, out));
  return out;
}

std::string share_cell(const FlightCount& count) {
  return formatted("{}/{}", count.flights, count.of);
}
std::string bounds_cell(const FlightCount& count) {
  return formatted("{:.2f} to {:.2f}", count.low, count.high);
}

/// What keeps most flights from being done, and from having seen.
std::string why_not(const StartOutcome& start) {
  if (!start.forbidden.empty()) return start.forbidden;
  const auto first = [](const char* how, const std::vector<StoppedBy>& causes) {
    return how + causes.front().cause + formatted(" ({})", causes.front().flights);
  };
  std::string text = start.stopped_by.empty() ? "" : first("", start.stopped_by);
  if (!start.unseen_by.empty())
    text += (text.empty() ? "" : "; ") + first("not seen: ", start.unseen_by);
  return text.empty() ? "-" : text;
}

void print_rehearsal(const LoadedMission& mission, const Rehearsal& rehearsal,
                     const std::vector<Advice>& advice,
                     const std::optional<AdaptedStart>& adapted) {
  std::printf("%s\n", verdict_of(rehearsal).c_str());
  std::printf("%s at %s, %s\n\n", joined(mission.expanded.tasks, ", ").c_str(),
              joined(mission.expanded.turbines, ", ").c_str(), mission.water.forecast_name.c_str());
  std::printf("%-18s %8s %13s %8s %13s %10s  %s\n", "start", "done", "P(done)", "seen", "P(seen)",
              "limits", "why not");
  for (const StartOutcome& start : rehearsal.starts) {
    std::printf("%-18s %8s %13s %8s %13s %10s  %s\n", format_utc(start.start).substr(0, 16).c_str(),
                share_cell(start.done).c_str(), bounds_cell(start.done).c_str(),
                start.seen ? share_cell(*start.seen).c_str() : "-",
                start.seen ? bounds_cell(*start.seen).c_str() : "-",
                start.by_the_limits.allows ? "allow" : "forbid", why_not(start).c_str());
    if (const std::string why = disagreement_of(start); !why.empty())
      std::printf("  %s\n", why.c_str());
    for (const std::string& cleaned : cleaning_texts(start)) std::printf("  %s\n", cleaned.c_str());
    for (const std::string& seen : inspection_texts(start)) std::printf("  %s\n", seen.c_str());
    for (const std::string& risk : risk_texts(risks_of(start, mission.consequences)))
      std::printf("  risk: %s\n", risk.c_str());
  }
  if (!advice.empty()) std::printf("\nDone otherwise:\n");
  for (const Advice& one : advice) std::printf("  %s\n", text_of(one).c_str());
  if (adapted) std::printf("\n");
  for (const std::string& line : adapted ? intensity_texts(*adapted) : std::vector<std::string>())
    std::printf("%s\n", line.c_str());
  const Unchecked unchecked = unchecked_of(mission.scenario);
  for (const std::string& limit : unchecked.not_checked)
    std::printf("not checked: %s\n", limit.c_str());
  for (const std::string& value : unchecked.assumed) std::printf("assumed: %s\n", value.c_str());
  std::printf("%.1f s, the first answer after %.1f s\n", rehearsal.wall_s,
              rehearsal.first_answer_s);
}

/// The flight of one start and member, logged as `simulate` logs.
void write_flight(const RehearseArguments& arguments, const LoadedMission& mission,
                  const twin::FlightCase& logged) {
  const ScenarioResult result =
      run_scenario(scenario_of_flight(mission.scenario, logged), mission.water, {});
  write_beside(arguments.log, [&](const std::filesystem::path& partial) {
    ingest::write_trajectories(result.file, partial);
  });
}

void run_rehearse(const RehearseArguments& arguments, const Context& context) {
  expect_output("--out", arguments.out, {".nc"});
  expect_output("--html", arguments.html, {".html"});
  expect_output("--scenario", arguments.scenario, {".yaml"});
  expect_output("--log", arguments.log, {".nc"});
  expect_output("--adapted", arguments.adapted, {".yaml"});
  expect_beside(arguments);
  std::vector<twin::Assumption> assumed;
  for (const std::string& text : arguments.assume) assumed.push_back(twin::parse_assumption(text));
  std::optional<bool> height_errors;
  if (!arguments.waves.empty()) height_errors = arguments.waves == "error";
  LoadedMission mission =
      load_mission(arguments.mission, context.store_folder, assumed, height_errors);
  const int threads = arguments.threads > 0
                          ? arguments.threads
                          : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  RehearsalPlan plan = rehearsal_plan(mission, starts_of(arguments, mission, context),
                                      arguments.members, threads, context.store_folder);
  const std::optional<twin::FlightCase> logged = logged_of(arguments, plan, context);
  const bool adapts = arguments.adapt_intensity || !arguments.adapted.empty();
  if (const std::size_t least = twin::members_needed(twin::IntensityQuestion{}.keep_share);
      adapts && plan.members < least)
    throw Error(ErrorKind::usage,
                formatted("--adapt-intensity: found {} futures, expected {} at the least to show "
                          "that the reserve is kept in nine of ten; give --members {}",
                          plan.members, least, least));
  plan.narrow_enough = arguments.narrow_enough;
  ProgressBar progress("rehearse " + mission.name, context.json);
  bool is_first = true;
  const Rehearsal rehearsal = with_context(arguments.mission.string(), [&] {
    return fly_mission(mission, plan, [&](double share, const Rehearsal& so_far) {
      if (is_first && share < 1 && !context.json)
        std::fprintf(stderr, "first answer: %s\n", verdict_of(so_far).c_str());
      is_first = false;
      progress.update(share);
    });
  });
  std::vector<Advice> advice;
  if (arguments.advice)
    advice =
        advice_for(mission, plan, flown_start(rehearsal.starts[rehearsal.best()], most_advised));
  std::optional<AdaptedStart> adapted;
  if (adapts)
    adapted = adapted_start(arguments, context, assumed, height_errors, mission, plan,
                            best_allowed(rehearsal));
  if (!arguments.scenario.empty()) write_text(arguments.scenario, mission.scenario.yaml);
  if (!arguments.out.empty()) {
    write_beside(arguments.out, [&](const std::filesystem::path& partial) {
      ingest::write_trajectories(rehearsal_file(mission, plan, rehearsal), partial);
    });
  }
  if (!arguments.html.empty()) {
    write_beside(arguments.html, [&](const std::filesystem::path& partial) {
      write_rehearsal_page(mission, plan, rehearsal, advice, partial);
    });
  }
  if (logged) write_flight(arguments, mission, *logged);
  for (const std::string& warning : mission.water.warnings)
    std::fprintf(stderr, "slackwater: %s\n", warning.c_str());
  // A file that was asked for and is not there is not to pass for one.
  if (!arguments.adapted.empty() && !adapted->choice.chosen) {
    std::fprintf(stderr, "slackwater: %s: not written, %s\n", arguments.adapted.c_str(),
                 adapted->choice.reason.c_str());
    context.exit_code = exit_do_not_fly;
  }
  if (context.json) {
    json out = rehearsal_json(mission, plan, rehearsal, advice);
    out["intensity"] = adapted ? intensity_json(*adapted) : json(nullptr);
    std::printf("%s\n", out.dump(2, ' ', false, json::error_handler_t::replace).c_str());
  } else {
    print_rehearsal(mission, rehearsal, advice, adapted);
  }
}

}  // namespace

void add_rehearse(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<RehearseArguments>();
  CLI::App* command = app.add_subcommand(
      "rehearse",
      "Fly a mission in every future of the forecast: done or not, and what stopped it");
  command->add_option("mission", arguments->mission, "YAML file")->required();
  command
      ->add_option("--members", arguments->members,
                   "futures (default: all that were issued; 1 in made-up water)")
      ->check(CLI::Range(1, 100000));
  command->add_option("--start", arguments->starts,
                      "UTC time, as often as wanted (default: the mission's)");
  command->add_option("--every", arguments->every, "from one start to the next (default 1h)");
  command->add_option("--starts", arguments->count, "how many starts")->check(CLI::Range(1, 1000));
  command
      ->add_option("--until-within", arguments->narrow_enough,
                   "stop flying a start when its 95 % interval of P(done, and seen) is narrower "
                   "than this")
      ->check(CLI::Range(0.001, 1.0));
  command->add_option("--assume", arguments->assume,
                      "what no forecast serves, e.g. visibility_m=5000");
  command
      ->add_option("--waves", arguments->waves,
                   "error: each future's waves err as forecasts do (default, as `windows` has "
                   "them); forecast: all have those of the forecast")
      ->check(CLI::IsMember({"error", "forecast"}));
  command->add_flag("--advice", arguments->advice,
                    "fly the best start with changes too: an hour earlier or later, other side of "
                    "the tide, half speed, more battery, other vehicles");
  command->add_flag("--adapt-intensity", arguments->adapt_intensity,
                    "the densest passes with which the reserve is kept in nine of ten futures, at "
                    "the best start; 9 futures at the least");
  command->add_option("--adapted", arguments->adapted,
                      "that mission as FILE.yaml, beside the mission; exit code 12: no density "
                      "keeps the reserve");
  command->add_option("--threads", arguments->threads, "1 to 64 (default: one a core)")
      ->check(CLI::Range(1, 64));
  command->add_option("--out", arguments->out, "all flights, minute by minute, as FILE.nc");
  command->add_option("--html", arguments->html, "page as FILE.html");
  command->add_option("--scenario", arguments->scenario,
                      "the mission laid out, as FILE.yaml for `slackwater simulate`");
  command->add_option("--log", arguments->log, "one flight, logged as `simulate` does, as FILE.nc");
  command->add_option("--log-member", arguments->log_member, "its member (default 0)");
  command->add_option("--log-start", arguments->log_start, "its start (default: the first)");
  command->callback([arguments, &context] { run_rehearse(*arguments, context); });
}

}  // namespace slackwater::api
