// A day of eight tasks and four teams on a grid of a quarter of an hour, planned and proven; and a
// day that is too large to prove, with what is known of it at the time limit.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "api/ask/plan/greedy_plan.h"
#include "api/ask/plan/make_plan.h"
#include "tests/api/ask/plan/plan_days.h"
#include "tests/bench/bench_report.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;

double seconds_of(const api::PlanProblem& day, double time_limit_s, api::Plan& plan) {
  const auto from = std::chrono::steady_clock::now();
  plan = api::make_plan(day, time_limit_s);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

void check(BenchReport& report, const std::string& name, const api::PlanProblem& day,
           const api::Plan& plan) {
  const std::string wrong = tests::what_is_wrong(day, plan.assignments, plan.charges);
  char text[160];
  std::snprintf(text, sizeof text, "worth %.2f, at most %.2f%s, %zu of %zu jobs%s%s", plan.value,
                plan.bound, plan.is_proven ? " (proven)" : "", plan.assignments.size(),
                day.jobs.size(), wrong.empty() ? "" : "; ", wrong.c_str());
  const double greedy = api::value_of(day, api::greedy_draft(day).assignments);
  report.answer(
      name, wrong.empty() && plan.value >= greedy - 1e-9 && plan.bound >= plan.value - 1e-9, text);
}

/// Days small enough to try all plans, so that what is timed afterwards is known to be the best.
void check_small_days(BenchReport& report) {
  Rng random(8, "bench/plan small");
  int right = 0;
  for (int i = 0; i < 20; ++i) {
    const api::PlanProblem day = tests::small_random_day(random);
    const api::Plan plan = api::make_plan(day, 60);
    right += std::abs(plan.value - tests::best_value_by_trying(day)) < 1e-9 ? 1 : 0;
  }
  report.answer("small days are planned as by trying all plans", right == 20,
                std::to_string(right) + " of 20");
}

void run(BenchReport& report) {
  const bool check_only = report.options().check_only;
  check_small_days(report);
  std::vector<double> seconds;
  double slowest_s = 0;
  bool all_proven = true;
  const int days = check_only ? 1 : 9;
  for (int i = 0; i < days; ++i) {
    Rng random(static_cast<std::uint64_t>(i), "farm");
    const api::PlanProblem day = tests::farm_day(8, 4, random);
    api::Plan plan;
    seconds.push_back(seconds_of(day, 60, plan));
    slowest_s = std::max(slowest_s, seconds.back());
    all_proven = all_proven && plan.is_proven;
    check(report, "8 tasks, 4 teams, day " + std::to_string(i), day, plan);
  }
  report.answer("all of them are proven", all_proven, check_only ? "1 day" : "9 days");
  Rng random(1, "farm");
  const api::PlanProblem large = tests::farm_day(24, 4, random);
  api::Plan plan;
  seconds_of(large, check_only ? 1 : 30, plan);
  check(report, "24 tasks, 4 teams, at the time limit", large, plan);
  if (check_only) return;
  char text[80];
  std::snprintf(text, sizeof text, "slowest of 9 days %.1f s", slowest_s);
  report.figure({"8 tasks, 4 teams, 15 min, optimal and proven", "s", seconds, 10, text});
  report.figure(
      {"24 tasks, 4 teams, 30 s: bound over plan", "x", {plan.bound / plan.value}, {}, ""});
}

}  // namespace

int main(int argc, char** argv) { return run_bench(argc, argv, "plan", run); }
