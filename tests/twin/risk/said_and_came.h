#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "fields/base/numbers/random.h"

// What was said of starts beside what came of them, day by day: the starts of a day share its
// weather, so that days are drawn anew, not starts.

namespace slackwater::tests {

/// A start of a day: what was said, and what came.
struct Case {
  double probability = 0;
  bool by_threshold = false;
  bool by_alpha = false;
  bool held = false;
};
using Day = std::vector<Case>;

inline double brier(double said, bool held) {
  return (said - (held ? 1 : 0)) * (said - (held ? 1 : 0));
}

/// The p-quantile of some numbers in order.
inline double quantile(std::vector<double>& values, double p) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(p * static_cast<double>(values.size() - 1))];
}

/// An interval by drawing the days anew.
template <typename Statistic>
std::pair<double, double> by_day(const std::vector<Day>& days, double level,
                                 const Statistic& statistic) {
  Rng random(11, "window_probabilities/bootstrap");
  std::vector<double> drawn;
  std::vector<const Day*> sample(days.size());
  for (int round = 0; round < 600; ++round) {
    for (const Day*& day : sample) day = &days[random.bits() % days.size()];
    if (const double value = statistic(sample); !std::isnan(value)) drawn.push_back(value);
  }
  return {quantile(drawn, 0.5 * (1 - level)), quantile(drawn, 0.5 * (1 + level))};
}

inline std::size_t decile_of(double probability) {
  return std::min<std::size_t>(9, static_cast<std::size_t>(probability * 10));
}

/// What came less what was said, of the cases of a decile.
inline double off_in(const std::vector<const Day*>& days, std::size_t decile) {
  double sum = 0, count = 0;
  for (const Day* day : days)
    for (const Case& one : *day)
      if (decile_of(one.probability) == decile) {
        sum += (one.held ? 1 : 0) - one.probability;
        ++count;
      }
  return count > 0 ? sum / count : std::nan("");
}

template <typename Rule>
double brier_beyond(const std::vector<const Day*>& days, const Rule& rule) {
  double sum = 0, count = 0;
  for (const Day* day : days)
    for (const Case& one : *day) {
      sum += brier(one.probability, one.held) - brier(rule(one) ? 1 : 0, one.held);
      ++count;
    }
  return sum / count;
}

/// What a decision maker saves by a rule, as a share of what perfect knowledge saves, beyond always
/// going or always staying: staying costs `ratio`, going into a broken limit 1.
template <typename Stays>
double value_of(const std::vector<Day>& days, double ratio, const Stays& stays) {
  double rule = 0, broken = 0, count = 0;
  for (const Day& day : days)
    for (const Case& one : day) {
      rule += stays(one) ? ratio : one.held ? 0 : 1;
      broken += one.held ? 0 : 1;
      ++count;
    }
  const double always = std::min(ratio * count, broken);
  const double perfect = ratio * broken;
  return (always - rule) / (always - perfect);
}

template <typename Goes>
std::pair<double, double> false_go_and_no_go(const std::vector<Day>& days, const Goes& goes) {
  double go = 0, false_go = 0, stay = 0, false_stay = 0;
  for (const Day& day : days)
    for (const Case& one : day) {
      (goes(one) ? go : stay) += 1;
      if (goes(one) && !one.held) ++false_go;
      if (!goes(one) && one.held) ++false_stay;
    }
  return {go > 0 ? false_go / go : 0, stay > 0 ? false_stay / stay : 0};
}

/// Each decile of what was said, of which there are a hundred cases and more, came true as often
/// as it said: prints the table. @return how many such deciles there are
inline std::size_t expect_true_as_said(const std::vector<Day>& days) {
  std::size_t deciles = 0;
  std::printf("%zu task-days; P said, came true, cases, 99 %% interval of the difference\n",
              days.size());
  for (std::size_t decile = 0; decile < 10; ++decile) {
    std::size_t count = 0;
    double said = 0, came = 0;
    for (const Day& day : days)
      for (const Case& one : day)
        if (decile_of(one.probability) == decile) {
          ++count;
          said += one.probability;
          came += one.held ? 1 : 0;
        }
    if (count < 100) continue;
    ++deciles;
    const auto [low, high] =
        by_day(days, 0.99, [&](const auto& sample) { return off_in(sample, decile); });
    const auto n = static_cast<double>(count);
    std::printf("  %.3f  %.3f  %5zu  %+.3f to %+.3f\n", said / n, came / n, count, low, high);
    EXPECT_LE(low, 0) << "decile " << decile;
    EXPECT_GE(high, 0) << "decile " << decile;
  }
  return deciles;
}

inline std::size_t cases_in(const std::vector<Day>& days) {
  std::size_t cases = 0;
  for (const Day& day : days) cases += day.size();
  return cases;
}

/// The Brier score of what was said is below that of a rule: 95 % of the difference is below 0.
template <typename Rule>
void expect_better_than(const char* name, const std::vector<Day>& days, const Rule& rule) {
  const auto [low, high] = by_day(days, 0.95, [&](const auto& s) { return brier_beyond(s, rule); });
  std::printf("Brier score less that of the %s rule: %.4f to %.4f\n", name, low, high);
  EXPECT_LT(high, 0) << name;
}

}  // namespace slackwater::tests
