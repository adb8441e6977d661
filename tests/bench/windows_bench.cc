// Access windows of ten tasks over a year of hours in fifty futures by thresholds: every start's
// rule of the threshold, of practice, its members and what binds it.
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include "fields/base/numbers/random.h"
#include "tests/bench/bench_report.h"
#include "twin/risk/start_chances.h"
#include "twin/risk/workability/phase_plan.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;

constexpr std::size_t members = 50;

/// A sea, a wind and a tidal current in every future, hourly.
struct MadeUpFutures {
  std::size_t steps = 0;
  std::vector<std::vector<double>> height_m, wind_m_s, current_m_s;
};

MadeUpFutures made_up(std::size_t days) {
  MadeUpFutures made;
  made.steps = 24 * days + 48;
  Rng random(365, "bench/windows");
  double slow = 0;
  std::vector<double> weather;
  for (std::size_t i = 0; i < made.steps; ++i)
    weather.push_back(slow = 0.985 * slow + 0.17 * random.normal());
  for (std::size_t m = 0; m < members; ++m) {
    std::vector<double>&height = made.height_m.emplace_back(), &wind = made.wind_m_s.emplace_back(),
    &current = made.current_m_s.emplace_back();
    double off = 0;
    for (std::size_t i = 0; i < made.steps; ++i) {
      off = m == 0 ? 0 : 0.92 * off + 0.39 * random.normal();
      height.push_back(std::exp(0.2 + 0.5 * weather[i] + 0.15 * off));
      wind.push_back(std::abs(7 + 3 * weather[i] + 1.2 * off));
      current.push_back(std::abs(0.55 * std::sin(0.506 * static_cast<double>(i)) + 0.05 * off));
    }
  }
  return made;
}

/// The tasks of data/tasks, by length and limits.
struct Task {
  double work_h = 1;
  double height_m = 1.5;
  double wind_m_s = 12;
  double current_m_s = 0;  ///< 0: no such limit
};
constexpr Task tasks[] = {{1.5, 2.5, 8, 0},    {1, 2.5, 8, 0},    {1.5, 1.5, 12, 0.5},
                          {1, 1.5, 14, 0.5},   {3, 1.5, 12, 0.5}, {4, 1.5, 12, 0.5},
                          {8, 1.25, 14, 0.55}, {1, 1.5, 12, 1.5}, {1.5, 1, 10, 1.0},
                          {0.5, 2, 15, 0}};

twin::StartQuestion question_of(const Task& task, const MadeUpFutures& made) {
  const twin::PhasePlan plan{{{twin::Phase::transit, 1800},
                              {twin::Phase::launch, 600},
                              {twin::Phase::work, 3600 * task.work_h},
                              {twin::Phase::recovery, 600},
                              {twin::Phase::return_home, 1800}}};
  twin::StartQuestion question;
  question.steps = made.steps;
  question.members = members;
  question.starts = {0, 1, made.steps - 24};
  const auto watch = [&](double bound, const auto& values, twin::PhaseSet phases, double alpha) {
    twin::WatchedLimit watched;
    watched.limit = question.limits++;
    watched.bound = {twin::BoundSide::at_most, bound};
    watched.when = twin::steps_of(plan, phases, 3600, 3600);
    for (const std::vector<double>& one : values) watched.members.emplace_back(one);
    if (alpha > 0) watched.alpha.assign(question.starts.count, alpha);
    question.watched.push_back(std::move(watched));
  };
  watch(task.height_m, made.height_m, {}, 0.7);
  watch(task.wind_m_s, made.wind_m_s, {}, 0);
  twin::PhaseSet at_work;
  at_work.bits = 0;
  at_work.add(twin::Phase::work);
  if (task.current_m_s > 0) watch(task.current_m_s, made.current_m_s, at_work, 0);
  return question;
}

/// A step at a time, for each start and member.
std::size_t different(const twin::StartQuestion& q, const std::vector<twin::StartChance>& found) {
  std::size_t wrong = 0;
  for (std::size_t s = 0; s < q.starts.count; ++s) {
    std::size_t held = 0;
    bool central = false, practice = true;
    for (std::size_t m = 0; m < q.members; ++m) {
      bool holds = true;
      for (const twin::WatchedLimit& watched : q.watched)
        for (const twin::StepRange& when : watched.when)
          for (std::size_t i = s + when.begin; i < s + when.end; ++i) {
            holds &= watched.bound.holds(watched.members[m][i]);
            if (m == 0) {
              const double alpha = watched.alpha.empty() ? 1 : watched.alpha[s];
              practice &= watched.members[0][i] <= alpha * watched.bound.value;
            }
          }
      held += holds ? 1 : 0;
      if (m == 0) central = holds;
    }
    wrong +=
        found[s].held == held && found[s].by_threshold == central && found[s].by_alpha == practice
            ? 0
            : 1;
  }
  return wrong;
}

void run(BenchReport& report) {
  const bool check_only = report.options().check_only;
  const MadeUpFutures made = made_up(check_only ? 20 : 365);
  std::vector<twin::StartQuestion> questions;
  for (const Task& task : tasks) questions.push_back(question_of(task, made));
  std::size_t starts = 0, wrong = 0, held = 0;
  for (const twin::StartQuestion& question : questions) {
    const auto found = twin::start_chances(question);
    starts += found.size();
    wrong += different(question, found);
    for (const twin::StartChance& chance : found) held += chance.held;
  }
  const double share = static_cast<double>(held) / static_cast<double>(starts * members);
  char text[160];
  std::snprintf(text, sizeof text, "%zu starts of 10 tasks, %zu different, %.3f of all held",
                starts, wrong, share);
  report.answer("starts beside a count step by step", wrong == 0 && share > 0.1 && share < 0.9,
                text);
  if (check_only) return;
  std::vector<double> seconds;
  std::size_t checksum = 0;
  for (int i = 0; i < 7; ++i) {
    const std::clock_t from = std::clock();
    for (const Task& task : tasks)
      for (const twin::StartChance& chance : twin::start_chances(question_of(task, made)))
        checksum += chance.held;
    seconds.push_back(static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC);
  }
  report.figure({"10 tasks x 365 days of hours x 50 members by threshold, one core", "s", seconds,
                 1, "checksum " + std::to_string(checksum)});
}

}  // namespace

int main(int argc, char** argv) { return run_bench(argc, argv, "windows", run); }
