// The probability that all limits hold, as the members give it, beside what came: on made-up
// task-days whose truth is known and exchangeable with the members.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "fields/base/numbers/random.h"
#include "tests/support/asked_number.h"
#include "tests/twin/risk/said_and_came.h"
#include "twin/chance/success_interval.h"
#include "twin/risk/start_chances.h"
#include "twin/risk/workability/phase_plan.h"

namespace slackwater::tests::window_probabilities_test {
namespace {

constexpr std::size_t members = 25;  // the central one among them
constexpr std::size_t steps = 72;    // of half an hour, a day and a half
constexpr std::size_t starts = 48;
constexpr std::size_t cases_a_day = 4;
constexpr double step_s = 1800;

struct Variable {
  double limit = 1;
  double sigma = 0;  ///< of a forecast's error after a day, in the unit of the limit
  double memory_h = 12;
  double swing = 0;  ///< of the day about its mean
  double period_h = 24;
};

/// Waves, a tidal current, wind.
constexpr std::array<Variable, 3> variables{Variable{1.5, 0.3, 12, 0.35, 30},
                                            Variable{0.5, 0.05, 8, 0.15, 6.2},
                                            Variable{12, 1.8, 10, 2.5, 22}};

using Paths = std::vector<std::vector<double>>;

/// The central forecast near its limit, truth and members about it, all drawn alike: futures 1, 2,
/// ... are members, the last one is what comes.
Paths paths_of(const Variable& variable, Rng& random) {
  Paths paths(members + 1);
  const double mean = variable.limit * random.uniform(0.2, 0.9);
  const double phase = random.uniform(0, 6.283185307179586);
  for (std::size_t i = 0; i < steps; ++i)
    paths[0].push_back(std::max(
        0.0,
        mean + variable.swing * std::sin(phase + 6.283185307179586 * 0.5 * static_cast<double>(i) /
                                                     variable.period_h)));
  const double kept = std::exp(-0.5 / variable.memory_h);
  const double fresh = std::sqrt(1 - kept * kept);
  for (std::size_t f = 1; f <= members; ++f) {
    double z = random.normal();
    for (std::size_t i = 0; i < steps; ++i) {
      // It grows with the lead, by half from the first hour to the end of the day.
      const double sigma = variable.sigma * (0.8 + 0.4 * static_cast<double>(i) / steps);
      paths[f].push_back(std::max(0.0, paths[0][i] + sigma * z));
      z = kept * z + fresh * random.normal();
    }
  }
  return paths;
}

/// A task of four hours: waves count at launch and recovery, current at work, wind throughout.
twin::StartQuestion task_of(const std::vector<Paths>& futures, bool is_truth) {
  const twin::PhasePlan plan{
      {{twin::Phase::launch, 1200}, {twin::Phase::work, 3 * 3600}, {twin::Phase::recovery, 1800}}};
  twin::StartQuestion question;
  question.steps = steps;
  question.members = is_truth ? 1 : members;
  question.limits = variables.size();
  question.starts = {0, 1, starts};
  for (std::size_t v = 0; v < variables.size(); ++v) {
    twin::PhaseSet phases;
    phases.bits = 0;
    if (v != 1) phases.add(twin::Phase::launch);
    if (v != 0) phases.add(twin::Phase::work);
    if (v != 1) phases.add(twin::Phase::recovery);
    twin::WatchedLimit watched;
    watched.limit = v;
    watched.bound = {twin::BoundSide::at_most, variables[v].limit};
    watched.when = twin::steps_of(plan, phases, 1800, step_s);
    if (is_truth)
      watched.members = {futures[v].back()};
    else
      for (std::size_t m = 0; m < members; ++m) watched.members.emplace_back(futures[v][m]);
    if (v == 0) watched.alpha.assign(starts, 0.705);  // DNV-OS-H101 table 4-1, 12 h
    question.watched.push_back(watched);
  }
  return question;
}

/// Starts that come near a limit oversampled: far from it every rule is right.
Day day_of(Rng& random) {
  std::vector<Paths> futures;
  for (const Variable& variable : variables) futures.push_back(paths_of(variable, random));
  const auto said = twin::start_chances(task_of(futures, false));
  const auto came = twin::start_chances(task_of(futures, true));
  std::vector<std::size_t> near;
  for (std::size_t s = 0; s < starts; ++s)
    if (const double share = said[s].binding->share; share > 0.7 && share < 1.5) near.push_back(s);
  Day day;
  for (std::size_t i = 0; i < cases_a_day && !near.empty(); ++i) {
    const std::size_t s = i == 0 ? random.bits() % starts : near[random.bits() % near.size()];
    day.push_back({twin::next_success(said[s].held, members), said[s].by_threshold,
                   said[s].by_alpha.value_or(false), came[s].by_threshold});
  }
  return day;
}

std::size_t wanted_days() {
  return static_cast<std::size_t>(asked_number("SLACKWATER_TASK_DAYS", 2000));
}

class WindowProbabilities : public testing::Test {
 protected:
  static const std::vector<Day>& days() {
    static const std::vector<Day> made = [] {
      std::vector<Day> all;
      Rng random(2025, "window_probabilities");
      for (std::size_t i = 0; i < wanted_days(); ++i) all.push_back(day_of(random));
      return all;
    }();
    return made;
  }
};

TEST_F(WindowProbabilities, ComeTrueAsOftenAsTheySay) {
  EXPECT_GE(expect_true_as_said(days()), 6U);
  EXPECT_GT(cases_in(days()), 3 * days().size());
}

TEST_F(WindowProbabilities, BeatTheThresholdAndTheAlphaRule) {
  const auto threshold = [](const Case& one) { return one.by_threshold; };
  const auto alpha = [](const Case& one) { return one.by_alpha; };
  expect_better_than("threshold", days(), threshold);
  expect_better_than("alpha", days(), alpha);
  const auto ours =
      false_go_and_no_go(days(), [](const Case& one) { return one.probability >= 0.9; });
  const auto by_threshold = false_go_and_no_go(days(), threshold);
  const auto by_alpha = false_go_and_no_go(days(), alpha);
  std::printf(
      "of those who go, into a broken limit; of those who stay, for nothing:\n"
      "  P >= 0.9   %.3f  %.3f\n  threshold  %.3f  %.3f\n  alpha      %.3f  %.3f\n",
      ours.first, ours.second, by_threshold.first, by_threshold.second, by_alpha.first,
      by_alpha.second);
  EXPECT_LT(ours.first, by_threshold.first);
  EXPECT_LT(ours.first, by_alpha.first);
}

TEST_F(WindowProbabilities, AreWorthMoreThanARuleAtAnyRatioOfCostToLoss) {
  std::printf("cost/loss   value by P, by threshold, by alpha\n");
  for (const double ratio : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}) {
    const double ours =
        value_of(days(), ratio, [&](const Case& one) { return 1 - one.probability > ratio; });
    const double threshold =
        value_of(days(), ratio, [](const Case& one) { return !one.by_threshold; });
    const double alpha = value_of(days(), ratio, [](const Case& one) { return !one.by_alpha; });
    std::printf("  %.2f      %.3f  %6.3f  %6.3f\n", ratio, ours, threshold, alpha);
    EXPECT_GT(ours, 0) << ratio;
    EXPECT_GT(ours, threshold - 0.02) << ratio;
    EXPECT_GT(ours, alpha - 0.02) << ratio;
  }
}

}  // namespace
}  // namespace slackwater::tests::window_probabilities_test
