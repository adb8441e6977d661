// A limit whose bound goes by the sea: ahead, at its starts, in a flight and by the planner's rule
// it is the same judgement.
#include <cmath>

#include "fields/base/error.h"
#include "tests/twin/mission/mission_for_tests.h"
#include "tests/twin/run/sea_for_tests.h"
#include "twin/agent/conduct.h"
#include "twin/rehearse/by_the_limits.h"
#include "twin/rehearse/flight.h"
#include "twin/rehearse/limit_ahead.h"
#include "twin/risk/start_chances.h"

namespace slackwater::tests::table_limit_test {
namespace {

const double unknown = std::nan("");

constexpr const char* by_both =
    "{peak_period_s: [4, 8, 12], rows: [{from_bow_deg: 0, at_most: [1.8, 1.5, 1.0]}, "
    "{from_bow_deg: 90, at_most: [1.2, 1.0, 0.6]}, {from_bow_deg: 180, at_most: [1.6, 1.3, 0.9]}]}";

/// The same, written down as one looks it up on paper.
double on_paper(double period_s, double off_deg) {
  const double rows[3][3] = {{1.8, 1.5, 1.0}, {1.2, 1.0, 0.6}, {1.6, 1.3, 0.9}};
  const double t = std::min(std::max((period_s - 4) / 4, 0.0), 2.0), a = off_deg / 90;
  const int i = std::min(static_cast<int>(a), 1), j = std::min(static_cast<int>(t), 1);
  const double v = a - i, u = t - j;
  return (1 - v) * ((1 - u) * rows[i][j] + u * rows[i][j + 1]) +
         v * ((1 - u) * rows[i + 1][j] + u * rows[i + 1][j + 1]);
}

/// An ROV that goes to a place in the north, and back if it is to: its bow is north, or both.
twin::Scenario northward(const std::string& limit, bool and_back = false, bool errs = false) {
  return with_forecast_waves(
      std::string("name: test\nseed: 3\nduration: 55min\nstep_s: 0.05\nlog_every_s: 1\nwater: "
                  "{made_up: {depth_m: 40}}\nwaves: {from: calm, components: 8}\nvehicles:\n"
                  "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: "
                  "20}, speed_m_s: 0.5, conduct: {limits: [{phases: [work], ") +
          limit +
          "}]}, tasks: [{do: route, phase: work, waypoints: [{north_m: 300, east_m: 0, depth_m: "
          "20}" +
          (and_back ? ", {north_m: 0, east_m: 0, depth_m: 20}" : "") + "]}]}\n",
      errs);
}
twin::Scenario by_table(const std::string& table = by_both, bool and_back = false) {
  return northward("significant_wave_height_m: " + table, and_back);
}

std::vector<twin::LimitAhead> ahead_of(const twin::Scenario& mission,
                                       const std::vector<SeaState>& hourly, const StepClock& clock,
                                       const twin::WaveFutures* waves = nullptr) {
  twin::Scenario scenario = mission;
  scenario.start = sea_start();
  scenario.duration_s = 60;
  twin::Surround surround = in_forecast_sea(scenario, hourly);
  surround.is_only_asked = true;
  return twin::limits_ahead(twin::set_up(scenario, surround), 0, clock, 1, waves);
}

/// Seas whose height, period and direction all change; between stamps height and period are linear
/// and directions are weighed by energy.
const std::vector<SeaState> restless{{0.9, 5, 350}, {1.3, 7, 30},  {1.1, 9, 80},
                                     {0.7, 12, 80}, {1.2, 14, 80}, {0.5, 4, 200}};
SeaState at_hour(double hour) {
  const auto i = std::min(static_cast<std::size_t>(hour), restless.size() - 2);
  const double upper = hour - static_cast<double>(i);
  const SeaState &a = restless[i], &b = restless[i + 1];
  double north = 0, east = 0;
  for (const auto& [weight, sea] : {std::pair(1 - upper, a), std::pair(upper, b)}) {
    const double energy = weight * sea.significant_height_m * sea.significant_height_m;
    north += energy * std::cos(sea.from_direction_deg * constants::degree);
    east += energy * std::sin(sea.from_direction_deg * constants::degree);
  }
  return {(1 - upper) * a.significant_height_m + upper * b.significant_height_m,
          (1 - upper) * a.peak_period_s + upper * b.peak_period_s,
          std::atan2(east, north) / constants::degree};
}

const StepClock five_hours{sea_start(), std::chrono::minutes(10), 30};

TEST(TableLimit, AheadIsTheShareOfTheBoundThatOneLooksUp) {
  const auto ahead = ahead_of(by_table(), restless, five_hours);
  ASSERT_EQ(ahead.size(), 1U);
  ASSERT_EQ(ahead[0].bows.size(), 1U);
  ASSERT_EQ(ahead[0].members.size(), 1U);
  ASSERT_EQ(ahead[0].by_sea.size(), five_hours.steps);
  const auto share_at = [](std::size_t stamp) {
    const SeaState sea = at_hour(static_cast<double>(stamp) / 6);
    return sea.significant_height_m / on_paper(sea.peak_period_s, std::abs(sea.from_direction_deg));
  };
  std::size_t broken = 0;
  for (std::size_t i = 0; i < five_hours.steps; ++i) {
    const double worse = std::max(share_at(i), share_at(i + 1));
    EXPECT_NEAR(ahead[0].members[0][i], worse, 1e-6) << i;
    broken += worse > 1 ? 1 : 0;
    const SeaState told =
        at_hour(static_cast<double>(share_at(i + 1) > share_at(i) ? i + 1 : i) / 6);
    EXPECT_NEAR(*ahead[0].by_sea[i].peak_period_s, told.peak_period_s, 1e-6) << i;
    EXPECT_NEAR(ahead[0].by_sea[i].at_most_m,
                on_paper(told.peak_period_s, std::abs(told.from_direction_deg)), 1e-6)
        << i;
  }
  EXPECT_GT(broken, 5U);
  EXPECT_LT(broken, 25U);
}

/// In every future its own height is held against the bound of the hour, start by start.
TEST(TableLimit, StartsHoldInTheFuturesInWhichOneCountsThemByHand) {
  constexpr std::size_t futures = 49;
  twin::Scenario mission = by_table();
  const twin::Surround surround = in_forecast_sea(mission, restless);
  const twin::WaveFutures waves(surround.field->snapshot(), futures);
  const auto ahead = ahead_of(mission, restless, five_hours, &waves);
  ASSERT_EQ(ahead[0].members.size(), futures);
  twin::StartQuestion question;
  question.steps = five_hours.steps;
  question.members = futures;
  question.limits = 1;
  question.starts = {0, 1, 20};
  twin::WatchedLimit watched;
  watched.bound = {twin::BoundSide::at_most,
                   ahead[0].bound_of(mission.vehicles[0].conduct->limits[0])};
  watched.when = {{1, 5}};
  watched.members.assign(ahead[0].members.begin(), ahead[0].members.end());
  question.watched.push_back(watched);
  const auto chances = twin::start_chances(question);
  std::size_t all = 0;
  for (std::size_t s = 0; s < question.starts.count; ++s) {
    std::size_t held = 0;
    for (std::size_t f = 0; f < futures; ++f) {
      bool holds = true;
      for (std::size_t stamp = s + 1; stamp <= s + 5; ++stamp) {
        const SeaState sea = at_hour(static_cast<double>(stamp) / 6);
        const double height_m =
            waves.height_m(f, sea.significant_height_m, five_hours.time_of(stamp));
        holds &= height_m <= on_paper(sea.peak_period_s, std::abs(sea.from_direction_deg));
      }
      held += holds ? 1 : 0;
    }
    EXPECT_EQ(chances[s].held, held) << s;
    all += held;
  }
  EXPECT_GT(all, futures);
  EXPECT_LT(all, 19 * futures);
}

/// The same height, as wind sea and as a long swell; and from ahead and abeam.
TEST(TableLimit, ALongSwellForbidsWhatAWindSeaOfThatHeightAllows) {
  const auto allows = [](double period_s, double from_deg) {
    const twin::Scenario mission = by_table();
    const std::vector<SeaState> hourly(2, {1.09, period_s, from_deg});
    return twin::by_the_limits(mission, in_forecast_sea(mission, hourly), sea_start(), {});
  };
  EXPECT_TRUE(allows(6, 0).allows);
  const twin::LimitsSay swell = allows(13, 0), abeam = allows(6, 90);
  EXPECT_FALSE(swell.allows);
  EXPECT_NEAR(swell.share, 1.09, 1e-6);
  EXPECT_NE(swell.binding.find("forecast 1.09 m, the limit 1 m at a peak period of 13 s (the table "
                               "ends at 12 s), waves 0 degrees off the bow"),
            std::string::npos)
      << swell.binding;
  EXPECT_TRUE(abeam.allows) << "at most 1.1 m at 6 s";
  EXPECT_NEAR(abeam.share, 1.09 / 1.1, 1e-6);
  EXPECT_FALSE(allows(6.4, 90).allows) << "1.08 m";
  EXPECT_FALSE(allows(6.4, 270).allows) << "of either side";
}

TEST(TableLimit, TheWorstOfItsBowsCounts) {
  const StepClock clock{sea_start(), std::chrono::minutes(10), 3};
  const std::vector<SeaState> ahead_sea(2, {1, 4, 0});
  const auto there = ahead_of(by_table(by_both, false), ahead_sea, clock);
  const auto and_back = ahead_of(by_table(by_both, true), ahead_sea, clock);
  EXPECT_NEAR(there[0].members[0][0], 1 / 1.8, 1e-9);
  EXPECT_NEAR(and_back[0].members[0][0], 1 / 1.6, 1e-9) << "astern on its way back";
  const auto fixed =
      ahead_of(northward(std::string("heading_deg: 90, significant_wave_height_m: ") + by_both),
               ahead_sea, clock);
  EXPECT_TRUE(fixed[0].bows.empty()) << "the limit has a bow of its own";
  EXPECT_NEAR(fixed[0].members[0][0], 1 / 1.2, 1e-9);
}

/// Where a forecast has a height without a period, or without a direction, the worst counts and is
/// told; a plain limit on the height needs neither.
TEST(TableLimit, WhatTheForecastDoesNotTellIsTheWorst) {
  const StepClock clock{sea_start(), std::chrono::minutes(10), 3};
  const auto share = [&](const std::string& limit, const SeaState& sea) {
    const auto ahead = ahead_of(northward(limit), {sea, sea}, clock);
    return std::pair(ahead[0].members[0][1],
                     ahead[0].by_sea.empty() ? twin::HeightBound{} : ahead[0].by_sea[1]);
  };
  const std::string table = std::string("significant_wave_height_m: ") + by_both;
  const auto no_period = share(table, {0.9, unknown, 0});
  EXPECT_NEAR(no_period.first, 0.9 / 1.0, 1e-9);
  EXPECT_TRUE(std::isnan(*no_period.second.peak_period_s));
  const auto no_direction = share(table, {0.9, 4, unknown});
  EXPECT_NEAR(no_direction.first, 0.9 / 1.2, 1e-9);
  EXPECT_TRUE(std::isnan(*no_direction.second.off_bow_rad));
  const auto neither = share(table, {0.9, unknown, unknown});
  EXPECT_NEAR(neither.first, 0.9 / 0.6, 1e-9);
  EXPECT_THROW(static_cast<void>(share(table, {unknown, 4, 0})), Error) << "a height is wanted";
  EXPECT_EQ(share("significant_wave_height_m: 1.5", {0.9, unknown, unknown}).first, 0.9);
  EXPECT_EQ(
      share("significant_wave_height_m: 1.5, from_bow_deg: [80, 100]", {0.9, 4, unknown}).first,
      0.9)
      << "they may come from there";
}

/// The sheet of crew transfer, its bound on waves by a table: she pushes on the landing in the
/// south of the pile, bow to the north, so that a sea from the east is abeam.
TEST(TableLimit, ABowOnALandingPointsFromItToTheTower) {
  const std::string yaml =
      "name: landing\nseed: 7\nduration: 2h\nstep_s: 0.05\nlog_every_s: 1\nwater: {made_up: "
      "{depth_m: 35, wind: {speed_m_s: 3, from_deg: 270}}}\ntasks: [access_window]\nturbines: "
      "[A01]\nwaves: {partitions: [{significant_height_m: 0.9, peak_period_s: 8, from_deg: 90}]}\n";
  twin::Scenario mission =
      twin::expand_mission(Config::parse(yaml, "mission.yaml"), small_farm_parts()).scenario;
  twin::Limit& waves = mission.vehicles.at(0).conduct.value().limits.at(0);
  ASSERT_EQ(waves.variable, twin::LimitVariable::significant_wave_height);
  waves.table =
      twin::read_limits(
          Config::parse(std::string("limits: [{significant_wave_height_m: ") + by_both + "}]",
                        "limit.yaml"))
          .front()
          .table;
  waves.bound = waves.table->least_m();
  mission.start = sea_start();
  twin::Surround surround = surround_of(mission);
  surround.is_only_asked = true;
  const auto ahead = twin::limits_ahead(twin::set_up(mission, surround), 0,
                                        {sea_start(), std::chrono::minutes(10), 3}, 1, nullptr);
  ASSERT_FALSE(ahead.empty());
  EXPECT_EQ(ahead[0].limit, 0U);
  EXPECT_EQ(ahead[0].phase, twin::Phase::work);
  ASSERT_EQ(ahead[0].bows.size(), 1U);
  EXPECT_NEAR(*ahead[0].by_sea[1].off_bow_rad / constants::degree, 90, 1e-6);
  EXPECT_NEAR(ahead[0].members[0][1], 0.9 / 1.0, 1e-9);
}

/// 1.2 m all the time; the period grows from 5 to 12 s within the hour. The bound falls from 1.5 m
/// at 5 s to 0.8 m at 12 s and passes 1.2 m at 8 s, after 3/7 h.
TEST(TableLimit, HoldsTheWorkOfARunWhenTheSwellGrowsLong) {
  const twin::Scenario mission = by_table("{peak_period_s: [5, 12], at_most: [1.5, 0.8]}", true);
  const twin::Surround surround = in_forecast_sea(mission, {{1.2, 5, 0}, {1.2, 12, 0}});
  twin::Scenario slow = mission;
  slow.vehicles[0].speed_m_s = 0.3;  // 2000 s out and back
  const twin::FlightCase flown{sea_start(), 0};
  const twin::Flight flight = twin::fly(slow, surround, {&flown, 1}, {}).front();
  const twin::MissionEvent* hold = nullptr;
  for (const twin::MissionEvent& event : flight.vehicles[0].mission)
    if (hold == nullptr && event.kind == twin::ConductEventKind::hold_began) hold = &event;
  ASSERT_NE(hold, nullptr);
  EXPECT_EQ(hold->cause, twin::Cause::limit);
  EXPECT_NEAR(hold->t_s, 3600.0 * 3 / 7, 5);
  EXPECT_NEAR(hold->value.value_or(0), 1.2, 1e-6);
  EXPECT_NE(hold->text.find("at most 0.8 to 1.5 m by peak period"), std::string::npos)
      << hold->text;
}

}  // namespace
}  // namespace slackwater::tests::table_limit_test
