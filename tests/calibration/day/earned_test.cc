#include "calibration/day/earned.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <memory>

#include "fields/base/numbers/random.h"

namespace slackwater::calibration::earned_test {
namespace {

constexpr std::size_t values = 40;

std::size_t place_of(Method method) {
  const std::vector<Method> methods = candidate_methods();
  return static_cast<std::size_t>(std::find(methods.begin(), methods.end(), method) -
                                  methods.begin());
}

/// A day of lead on which our own forecast and `tide-phase` erred by so much, in directions that
/// have nothing to do with each other.
RehearsedLead lead_with(double own_m_s, double tide_m_s, int day) {
  RehearsedLead lead;
  lead.errors.resize(candidate_methods().size());
  for (std::size_t i = 0; i < values; ++i) {
    const double turn = 0.7 * static_cast<double>(i) + day;
    lead.errors[place_of(Method::forecast)].push_back(std::polar(own_m_s, turn));
    lead.errors[place_of(Method::tide_phase)].push_back(std::polar(tide_m_s, -1.3 * turn));
  }
  lead.sigma_m_s.assign(values, 0.1);
  lead.merged_sigma_m_s.assign(values, std::numeric_limits<double>::quiet_NaN());
  lead.noise_m_s.assign(values, 0.0);
  return lead;
}

struct Errors {
  double own_m_s = 0;
  double tide_m_s = 0;
  int pairs = 0;
};

/// What ten days have earned that met `first` on their first day of lead, and `second` on as many
/// of their second days as that says.
Earned earned_by(const Errors& first, const Errors& second) {
  std::vector<std::vector<PastLead>> past(2);
  for (int d = 0; d < first.pairs; ++d) {
    RehearsedDay day;
    day.lead = {lead_with(first.own_m_s, first.tide_m_s, d),
                lead_with(second.own_m_s, second.tide_m_s, d + 100)};
    const auto kept = std::make_shared<const RehearsedDay>(std::move(day));
    past[0].push_back({kept, 0, static_cast<double>(d)});
    if (d < second.pairs) past[1].push_back({kept, 1, static_cast<double>(d)});
  }
  std::vector<Candidate> candidates = standard_candidates();
  for (Candidate& c : candidates)
    c.available = c.method == Method::forecast || c.method == Method::tide_phase;
  return earned_from(past, candidates);
}

double weight_of(const Blend& blend, Method method) { return blend.share[place_of(method)].weight; }

TEST(Earned, ALaterDayOfLeadWithFewPairsBelievesTheDayBefore) {
  for (const int pairs : {0, 1, 4}) {
    const Earned earned = earned_by({.own_m_s = 0.2, .tide_m_s = 0.2, .pairs = 10},
                                    {.own_m_s = 0.2, .tide_m_s = 0.1, .pairs = pairs});
    ASSERT_NEAR(weight_of(earned.blend, Method::tide_phase), 0.5, 0.1);
    EXPECT_NEAR(weight_of(earned.later.front(), Method::tide_phase),
                weight_of(earned.blend, Method::tide_phase), 0.011)
        << pairs;
  }
}

TEST(Earned, ALaterDayOfLeadWithManyPairsHasWeightsOfItsOwn) {
  const Earned towards_tide = earned_by({.own_m_s = 0.1, .tide_m_s = 0.4, .pairs = 10},
                                        {.own_m_s = 0.4, .tide_m_s = 0.1, .pairs = 9});
  EXPECT_GT(weight_of(towards_tide.blend, Method::forecast), 0.75);
  EXPECT_GT(weight_of(towards_tide.later.front(), Method::tide_phase), 0.75);
  const Earned towards_own = earned_by({.own_m_s = 0.4, .tide_m_s = 0.1, .pairs = 10},
                                       {.own_m_s = 0.1, .tide_m_s = 0.4, .pairs = 9});
  EXPECT_GT(weight_of(towards_own.later.front(), Method::forecast), 0.75);
}

TEST(Earned, WhatDoesNotReachALaterDayLeavesItToTheOthers) {
  // All weight of the first day goes to a method that has no value on the second.
  std::vector<std::vector<PastLead>> past(2);
  for (int d = 0; d < 10; ++d) {
    RehearsedDay day;
    day.lead = {lead_with(0.4, 0.01, d), lead_with(0.2, 0.2, d + 100)};
    day.lead[1].errors[place_of(Method::tide_phase)].clear();
    const auto kept = std::make_shared<const RehearsedDay>(std::move(day));
    past[0].push_back({kept, 0, static_cast<double>(d)});
    past[1].push_back({kept, 1, static_cast<double>(d)});
  }
  std::vector<Candidate> candidates = standard_candidates();
  for (Candidate& c : candidates)
    c.available = c.method == Method::forecast || c.method == Method::tide_phase;
  const Earned earned = earned_from(past, candidates);
  EXPECT_GT(weight_of(earned.blend, Method::tide_phase), 0.9);
  EXPECT_EQ(earned.later.front().pairs, 10U);
  EXPECT_EQ(weight_of(earned.later.front(), Method::forecast), 1.0);
  EXPECT_EQ(earned.spread.later.front().pairs, 10U);
}

/// Two days of lead of eight days, every candidate off by a vector of its own each day.
std::vector<std::vector<PastLead>> erring_days() {
  Rng random(1, "tests/earned");
  const auto lead = [&] {
    RehearsedLead made = lead_with(0, 0, 0);
    for (std::vector<Horizontal>& errors : made.errors)
      errors.assign(values, 0.15 * Horizontal(random.normal(), random.normal()));
    return made;
  };
  std::vector<std::vector<PastLead>> past(2);
  for (int d = 0; d < 8; ++d) {
    RehearsedDay day;
    day.lead = {lead(), lead()};
    const auto kept = std::make_shared<const RehearsedDay>(std::move(day));
    if (d != 5) past[0].push_back({kept, 0, d + 1.0});
    if (d != 3) past[1].push_back({kept, 1, d + 0.0});
  }
  return past;
}

/// Share of the components within 1.2816 sigma of 0.1 m/s, pairs weighed by their age as the spread
/// weighs them.
double held_with(const std::vector<PastLead>& past,
                 const std::function<std::vector<double>(std::size_t)>& weights_for) {
  double inside = 0;
  double all = 0;
  for (std::size_t i = 0; i < past.size(); ++i) {
    const std::vector<double> weights = weights_for(i);
    Horizontal error{};
    for (std::size_t c = 0; c < weights.size(); ++c)
      error += weights[c] * past[i].day->lead[past[i].lead].errors[c].front();
    const double say = std::exp(-(past[i].age_days + double(past[i].lead)) / 30.0);
    for (const double component : {error.real(), error.imag()})
      inside += std::abs(component) < 0.12816 ? say / 2 : 0;
    all += say;
  }
  return inside / all;
}

std::vector<double> weights_of(const Blend& blend) {
  std::vector<double> weights;
  for (const CandidateShare& share : blend.share) weights.push_back(share.weight);
  return weights;
}

TEST(Earned, TheSpreadIsHeldAgainstWeightsThatTheOtherDaysEarned) {
  const std::vector<std::vector<PastLead>> past = erring_days();
  const std::vector<Candidate> candidates = standard_candidates();
  const Earned earned = earned_from(past, candidates);
  const auto by_the_others = [&](std::size_t i) {
    std::vector<PastPair> pairs;
    for (std::size_t j = 0; j < past[0].size(); ++j) {
      if (j != i)
        pairs.push_back(pair_of_errors(past[0][j].day->lead[0].errors, past[0][j].age_days));
    }
    return weights_of(blend_of(candidates, pairs));
  };
  const double out_of_sample = held_with(past[0], by_the_others);
  const double in_sample =
      held_with(past[0], [&](std::size_t) { return weights_of(earned.blend); });
  ASSERT_GT(in_sample, out_of_sample + 0.05) << "the same for both: nothing is tested";
  EXPECT_NEAR(earned.spread.past_coverage_80, out_of_sample, 1e-6);
  // A day without a truth of its first day of lead counts for the second, and the other way round.
  EXPECT_EQ(earned.spread.pairs, 7U);
  ASSERT_EQ(earned.spread.later.size(), 1U);
  EXPECT_EQ(earned.spread.later[0].pairs, 7U);
  const double of_second =
      held_with(past[1], [&](std::size_t i) { return earned.later[0].without_pair[i]; });
  EXPECT_NEAR(earned.spread.later[0].past_coverage_80, of_second, 1e-6);
}

TEST(Earned, WeightsPassFromTheMiddleOfADayOfLeadToTheNext) {
  const Earned earned = earned_by({.own_m_s = 0.1, .tide_m_s = 0.4, .pairs = 10},
                                  {.own_m_s = 0.4, .tide_m_s = 0.1, .pairs = 9});
  const std::size_t own = place_of(Method::forecast);
  const double first = weight_of(earned.blend, Method::forecast);
  const double second = weight_of(earned.later.front(), Method::forecast);
  EXPECT_DOUBLE_EQ(weights_at(earned, 0)[own], first);
  EXPECT_DOUBLE_EQ(weights_at(earned, 12)[own], first);
  EXPECT_DOUBLE_EQ(weights_at(earned, 24)[own], 0.5 * (first + second));
  EXPECT_DOUBLE_EQ(weights_at(earned, 36)[own], second);
  EXPECT_DOUBLE_EQ(weights_at(earned, 72)[own], second);
}

}  // namespace
}  // namespace slackwater::calibration::earned_test
