#include "calibration/day/earned.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <limits>
#include <memory>

namespace slackwater::calibration {
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
}  // namespace slackwater::calibration
