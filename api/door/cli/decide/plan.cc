#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <thread>

#include "api/ask/morning/plan_windows.h"
#include "api/ask/plan/make_plan.h"
#include "api/ask/plan/plan_setup.h"
#include "api/door/cli/command.h"
#include "api/door/cli/decide/earlier_plan_file.h"
#include "api/door/cli/decide/windows_file.h"
#include "api/show/plan/plan_json.h"
#include "api/show/plan/plan_text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

struct PlanArguments {
  std::filesystem::path plan;
  std::filesystem::path windows;
  std::filesystem::path since;
  std::vector<std::string> assume;
  double chance = twin::VerdictRule{}.marginal;
  std::string time_limit = "60";
};

/// "60", seconds; or "2min".
double time_limit_s_of(const std::string& text) {
  double plain_s = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), plain_s);
  const bool is_plain = problem == std::errc() && end == text.data() + text.size();
  const double limit_s =
      is_plain ? plain_s
               : std::chrono::duration<double>(option_value("--time-limit", text, parse_duration))
                     .count();
  if (!(limit_s >= 0.01 && limit_s <= 86400))
    throw Error(ErrorKind::usage,
                "found --time-limit " + text + ", expected 0.01 (seconds) to 24h");
  return limit_s;
}

/// What the forecast in force says.
DayChances windows_in_force(const PlanFile& plan, const PlanArguments& arguments,
                            const Context& context) {
  WindowsQuestion question;
  for (const std::string& text : arguments.assume)
    question.assumed.push_back(twin::parse_assumption(text));
  question.practice = AlphaPractice::of_tables({});
  question.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return windows_for_plan(plan, std::move(question), context.store_folder);
}

void run_plan(const PlanArguments& arguments, const Context& context) {
  PlanAnswer answer;
  answer.time_limit_s = time_limit_s_of(arguments.time_limit);
  const PlanFile file = load_plan_file(arguments.plan, context.store_folder);
  const DayChances windows =
      arguments.windows.empty()
          ? with_context("no --windows were given",
                         [&] { return windows_in_force(file, arguments, context); })
          : load_windows(arguments.windows);
  std::optional<EarlierPlan> earlier;
  if (!arguments.since.empty()) earlier = load_earlier_plan(arguments.since);
  const PlanProblem problem = problem_of(file, windows, arguments.chance);
  answer.name = file.name;
  answer.site = file.site.id;
  // What cannot be compared is said before the search.
  if (earlier) static_cast<void>(changes_since(*earlier, problem, {}, answer.site));
  answer.plan = make_plan(problem, answer.time_limit_s);
  if (earlier) {
    answer.is_compared = true;
    answer.changes = changes_since(*earlier, problem, answer.plan, answer.site);
  }
  if (context.json)
    std::printf(
        "%s\n",
        plan_json(problem, answer).dump(2, ' ', false, json::error_handler_t::replace).c_str());
  else
    std::fputs(plan_text(problem, answer).c_str(), stdout);
}

}  // namespace

void add_plan(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<PlanArguments>();
  CLI::App* command = app.add_subcommand(
      "plan", "What to do when on one day: tasks, vessels, crews, vehicles and batteries");
  command->add_option("plan", arguments->plan, "PLAN.yaml: the tasks and what there is for them")
      ->required();
  command->add_option("--windows", arguments->windows,
                      "the chances of each start, as `slackwater windows --json` has them; - for "
                      "standard input (default: of the forecast in force)");
  command->add_option("--assume", arguments->assume,
                      "what no forecast serves, e.g. visibility_m=5000; without --windows");
  command
      ->add_option(
          "--chance", arguments->chance,
          "take no start of a smaller probability (default 0.5: at least marginal; 0: any, weighed "
          "by it)")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--time-limit", arguments->time_limit,
                      "of the search, seconds or e.g. 2min (default 60)");
  command->add_option("--since", arguments->since,
                      "an earlier plan's --json: say what changed, and why");
  command->callback([arguments, &context] { run_plan(*arguments, context); });
}

}  // namespace slackwater::api
