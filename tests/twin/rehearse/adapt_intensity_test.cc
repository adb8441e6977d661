#include "twin/rehearse/adapt_intensity.h"

#include <gtest/gtest.h>

#include "tests/support/error_of.h"
#include "tests/twin/rehearse/pile_survey.h"

namespace slackwater::tests::adapt_intensity_test {
namespace {

using twin::ReserveFate;

const UtcTime start = parse_utc("2025-06-02T00:00:00Z");

/// Nine members that run from slow to fast by as much.
HourlySpeeds fan_of(double slowest_m_s, double fastest_m_s) {
  HourlySpeeds speeds;
  speeds.emplace_back(3, 0.5 * (slowest_m_s + fastest_m_s));
  for (int member = 0; member < 9; ++member)
    speeds.emplace_back(3, slowest_m_s + (fastest_m_s - slowest_m_s) * member / 8);
  return speeds;
}

twin::IntensityQuestion question() {
  twin::IntensityQuestion question;
  question.start = start;
  for (std::size_t member = 1; member <= 9; ++member) question.members.push_back(member);
  question.densities = {1, 0.65, 0.5, 0.33};
  question.flights.workers = {"eye"};
  return question;
}

twin::IntensityChoice chosen_in(double slowest_m_s, double fastest_m_s, double charge,
                                const twin::IntensityQuestion& asked) {
  const twin::MissionThinned mission = pile_survey(3, charge);
  return twin::adapt_intensity(
      in_a_forecast(mission),
      water_of_members(mission({}), fan_of(slowest_m_s, fastest_m_s), start), asked);
}

/// Enough for half of the passes in the fastest water, a tenth more than they take.
double charge_for_half_of_it() {
  return 0.21 + 1.1 * charge_taken({0.5, twin::PassOrder::coarse_to_fine}, 0.4);
}

TEST(AdaptIntensity, LeavesTheFixedPlanAloneWhereItsEnergySuffices) {
  const twin::IntensityChoice choice = chosen_in(0, 0.2, 0.9, question());
  ASSERT_TRUE(choice.is_fixed_plan()) << choice.reason;
  ASSERT_EQ(choice.tried.size(), 1U);
  EXPECT_EQ(choice.tried[0].kept(), 9U);
  for (const double covered : choice.tried[0].coverage) EXPECT_GT(covered, 0.99);
  EXPECT_EQ(choice.reason, "all passes: the reserve is kept in 9 of 9 futures, 9 needed");
}

TEST(AdaptIntensity, DoesNotChooseWhereTheSparsestFailsToo) {
  const twin::IntensityChoice choice = chosen_in(0.3, 0.8, 0.21, question());
  EXPECT_FALSE(choice.chosen) << choice.reason;
  EXPECT_EQ(choice.tried.size(), 2U) << "between two that fail nothing is looked for";
  EXPECT_NE(choice.reason.find("no density keeps the reserve: do not fly"), std::string::npos)
      << choice.reason;
}

TEST(AdaptIntensity, TakesTheDensestThatAsManyMembersAsNeededBear) {
  const double charge = charge_for_half_of_it();
  const twin::IntensityChoice choice = chosen_in(0.1, 0.4, charge, question());
  ASSERT_TRUE(choice.chosen) << choice.reason;
  const double taken = choice.tried[*choice.chosen].thinned_by.density;
  EXPECT_LT(taken, 1) << choice.reason;
  EXPECT_EQ(choice.tried[*choice.chosen].thinned_by.order, twin::PassOrder::coarse_to_fine);
  // Each of the ladder by itself.
  const twin::MissionThinned mission = in_a_forecast(pile_survey(3, charge));
  const twin::Surround surround =
      water_of_members(pile_survey(3, charge)({}), fan_of(0.1, 0.4), start);
  double densest = 0;
  std::size_t kept_before = 0;
  for (const double density : question().densities) {
    const twin::Scenario flown =
        mission(density < 1 ? twin::Intensity{density, twin::PassOrder::coarse_to_fine}
                            : twin::Intensity{});
    std::size_t kept = 0;
    for (std::size_t member = 1; member <= 9; ++member) {
      const twin::FlightCase once{start, member};
      const twin::Flight flight =
          twin::fly(flown, surround, {&once, 1}, question().flights).front();
      kept += twin::reserve_fate(flight, flown, question().flights) == ReserveFate::kept ? 1 : 0;
    }
    EXPECT_GE(kept, kept_before) << "sparser is easier";
    kept_before = kept;
    if (kept >= 9) densest = std::max(densest, density);
    for (const twin::TriedIntensity& one : choice.tried)
      if (one.thinned_by.density == density) {
        EXPECT_EQ(one.kept(), kept) << density;
      }
  }
  EXPECT_EQ(taken, densest) << choice.reason;
  // The slow members had enough, the fast ones not.
  const twin::TriedIntensity& fixed = choice.tried[0];
  EXPECT_EQ(fixed.fates.front(), ReserveFate::kept);
  EXPECT_EQ(fixed.fates.back(), ReserveFate::called_home) << choice.reason;
  EXPECT_LT(fixed.coverage.back(), fixed.coverage.front());
  EXPECT_LT(choice.tried[*choice.chosen].duration_s.front(), fixed.duration_s.front());
}

TEST(AdaptIntensity, IsTheSameOnAnyNumberOfThreads) {
  twin::IntensityQuestion many = question();
  many.threads = 3;
  const twin::IntensityChoice a = chosen_in(0.3, 0.4, 0.25, question());
  const twin::IntensityChoice b = chosen_in(0.3, 0.4, 0.25, many);
  EXPECT_EQ(a.reason, b.reason);
  ASSERT_EQ(a.tried.size(), b.tried.size());
  for (std::size_t i = 0; i < a.tried.size(); ++i) {
    EXPECT_EQ(a.tried[i].charge_left, b.tried[i].charge_left);
    EXPECT_EQ(a.tried[i].duration_s, b.tried[i].duration_s);
  }
}

TEST(AdaptIntensity, RefusesWhatItCannotAnswer) {
  const auto refused = [](const auto& change) {
    twin::IntensityQuestion asked = question();
    change(asked);
    return error_of([&] { (void)chosen_in(0, 0.1, 0.9, asked); });
  };
  using Question = twin::IntensityQuestion;
  EXPECT_NE(refused([](Question& q) { q.members.resize(8); })
                .find("found 8 futures; that the reserve is kept with a probability of 0.9 takes "
                      "at least 9"),
            std::string::npos);
  EXPECT_NE(refused([](Question& q) {
              q.densities = {0.5, 0.2};
            }).find("begin with 1"),
            std::string::npos);
  EXPECT_NE(refused([](Question& q) {
              q.densities = {1, 0.5, 0.5};
            }).find("found 0.5 after 0.5"),
            std::string::npos);
  EXPECT_NE(refused([](Question& q) {
              q.densities = {1, 0};
            }).find("more than 0"),
            std::string::npos);
  EXPECT_NE(refused([](Question& q) { q.keep_share = 1; }).find("keep_share"), std::string::npos);
}

TEST(ReserveFate, SaysWhatCameOfTheReserve) {
  using twin::Cause;
  using twin::ConductEventKind;
  const auto fate = [](const auto& change) {
    twin::VehicleAccount out;
    out.is_done = true;
    out.on_mission.charge = out.least_charge = 0.4;
    out.mission.push_back({100, ConductEventKind::finished, Cause::none, ""});
    change(out);
    return twin::reserve_fate(out, 0.2);
  };
  const auto energy = [](twin::VehicleAccount& out, double charge) {
    out.broke_reserve = true;
    out.on_mission.charge = out.least_charge = charge;
  };
  EXPECT_EQ(fate([](auto&) {}), ReserveFate::kept);
  EXPECT_EQ(fate([&](auto& out) { energy(out, 0.19); }), ReserveFate::broken);
  const auto turn = [](twin::VehicleAccount& out, Cause cause) {
    out.mission.insert(out.mission.begin(), {50, ConductEventKind::turned_for_home, cause, ""});
  };
  EXPECT_EQ(fate([&](auto& out) { turn(out, Cause::limit); }), ReserveFate::kept);
  EXPECT_EQ(fate([&](auto& out) {
              energy(out, 0.21);
              turn(out, Cause::reserve);
            }),
            ReserveFate::called_home);
  EXPECT_EQ(fate([&](auto& out) {
              energy(out, 0.19);
              turn(out, Cause::reserve);
            }),
            ReserveFate::broken);
  EXPECT_EQ(fate([](auto& out) { out.mission.clear(); }), ReserveFate::not_home);
  EXPECT_EQ(fate([&](auto& out) {
              out.mission.clear();
              energy(out, 0);
            }),
            ReserveFate::broken);
}

}  // namespace
}  // namespace slackwater::tests::adapt_intensity_test
