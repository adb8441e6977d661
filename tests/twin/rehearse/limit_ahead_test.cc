#include "twin/rehearse/limit_ahead.h"

#include <set>

#include "tests/twin/mission/mission_for_tests.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/agent/conduct.h"
#include "twin/rehearse/by_the_limits.h"
#include "twin/rehearse/flight.h"
#include "twin/rehearse/planned_work.h"

namespace slackwater::tests::limit_ahead_test {
namespace {

const UtcTime start = parse_utc("2025-06-02T06:00:00Z");
constexpr std::size_t members = 4;

twin::Scenario mission_of(const std::string& task, const std::string& more = "") {
  const std::string yaml =
      "name: ahead\nseed: 7\nduration: 2h\nstep_s: 0.05\nlog_every_s: 1\nwater: {made_up: "
      "{depth_m: 35, current: [{depth_m: 0, east_m_s: 0.2, north_m_s: 0}], wind: {speed_m_s: 3, "
      "from_deg: 270}}}\ntasks: [" +
      task + "]\nturbines: [A01]\n" + more;
  return twin::expand_mission(Config::parse(yaml, "mission.yaml"), small_farm_parts()).scenario;
}

/// Six hours in which member m has a current of (1 + m) times the central one's, which grows, and
/// a wind of its own.
twin::Surround water_of(const twin::Scenario& mission) {
  twin::Surround surround = surround_of(mission);
  surround.field = twin::made_up_field(std::get<twin::MadeUpWater>(mission.water), surround.site,
                                       start, start + std::chrono::hours(6));
  auto snapshot = std::make_shared<Snapshot>(surround.field->snapshot());
  snapshot->members = members;
  for (ForecastColumn& column : snapshot->columns) {
    const std::size_t levels = snapshot->depth_m.size();
    for (std::size_t i = 0; i < column.current_m_s.size(); ++i)
      column.current_m_s[i] *= 0.5 + static_cast<double>(i / levels);
    for (std::size_t m = 1; m < members; ++m) {
      for (const Horizontal& central : column.current_m_s)
        column.member_m_s.push_back(static_cast<double>(1 + m) * central);
      for (const Horizontal& central : column.wind_m_s)
        column.wind_member_m_s.push_back(static_cast<double>(2 + m) * central);
    }
  }
  surround.field = std::make_shared<Field>(std::move(snapshot));
  return surround;
}

/// Set up as a planner does, the run itself looked at for a minute.
twin::ReadyRun ready_of(const twin::Scenario& mission, const twin::Surround& surround,
                        std::size_t member) {
  twin::Scenario scenario = mission;
  // A future is a member here, whatever made-up water is elsewhere.
  scenario.member = member;
  scenario.start = start;
  scenario.duration_s = 60;
  return twin::set_up(scenario, surround);
}

const StepClock clock_of_four_hours{start, std::chrono::minutes(10), 24};

TEST(LimitAhead, IsWhatARunOfThatMemberLooksAtAtThosePlaces) {
  const twin::Scenario mission = mission_of("blade_scan"), survey = mission_of("scour_survey");
  for (const twin::Scenario* one : {&mission, &survey}) {
    const twin::Surround surround = water_of(*one);
    const twin::ReadyRun central = ready_of(*one, surround, 0);
    const auto all = twin::limits_ahead(central, 0, clock_of_four_hours, members, nullptr);
    std::size_t compared = 0;
    for (std::size_t m = 0; m < members; ++m) {
      const twin::ReadyRun run = ready_of(*one, surround, m);
      for (const twin::LimitAhead& ahead : all) {
        if (m >= ahead.members.size()) continue;
        const twin::Limit& limit = run.agents[0].conduct->plan.limits[ahead.limit];
        twin::AgentState there = run.states[0];
        for (const std::size_t i : {0U, 7U, 23U}) {
          std::vector<double> values;
          for (const auto& place_m : ahead.places_m)
            for (const std::size_t end : {i, i + 1}) {
              there.vehicle.body.position_m = place_m;
              values.push_back(
                  twin::value_of(limit, run.agents[0], 600.0 * static_cast<double>(end), there));
            }
          if (std::isnan(values.front())) {
            EXPECT_TRUE(std::isnan(ahead.members[m][i]));
          } else {
            const auto [least, most] = std::minmax_element(values.begin(), values.end());
            EXPECT_EQ(ahead.members[m][i], limit.is_least ? *least : *most)
                << text_of(limit) << ", member " << m;
            ++compared;
          }
        }
      }
    }
    EXPECT_GT(compared, 30U) << one->vehicles.front().name;
  }
}

TEST(LimitAhead, MembersHoldAsOneCountsByHand) {
  const twin::Scenario mission = mission_of("scour_survey");
  const twin::ReadyRun ready = ready_of(mission, water_of(mission), 0);
  // From 0.1 to 0.3 m/s in six hours, times 1, 2, 3 and 4: the last member passes 0.5 m/s after 45
  // minutes, in the fifth step; the others do not within the first hour.
  for (const twin::LimitAhead& ahead :
       twin::limits_ahead(ready, 0, clock_of_four_hours, members, nullptr)) {
    const twin::Limit& limit = ready.agents[0].conduct->plan.limits[ahead.limit];
    if (limit.variable != twin::LimitVariable::current_speed) continue;
    ASSERT_EQ(ahead.members.size(), members);
    for (std::size_t m = 0; m < members; ++m) {
      const double times = static_cast<double>(1 + m);
      EXPECT_NEAR(ahead.members[m][4], times * (0.1 + 0.2 * 50 / 360), 1e-6);
      EXPECT_TRUE(limit.holds(ahead.members[m][3]));
      EXPECT_EQ(limit.holds(ahead.members[m][4]), m < 3);
    }
  }
}

TEST(LimitAhead, LimitsOfALaunchCountWhereTheVehicleStands) {
  const twin::Scenario mission = mission_of(
      "cable_burial",
      "waves: {components: 8, partitions: [{significant_height_m: 2, peak_period_s: 6, from_deg: "
      "270}]}\n");
  const twin::Surround surround = water_of(mission);
  const twin::ReadyRun ready = ready_of(mission, surround, 0);
  std::set<twin::Phase> phases;
  for (const twin::LimitAhead& ahead :
       twin::limits_ahead(ready, 0, clock_of_four_hours, members, nullptr)) {
    const twin::Limit& limit = ready.agents[0].conduct->plan.limits[ahead.limit];
    if (limit.variable != twin::LimitVariable::significant_wave_height) continue;
    phases.insert(ahead.phase);
    EXPECT_EQ(ahead.members.size(), 1U) << "a sea without spread is read once";
    EXPECT_DOUBLE_EQ(ahead.members[0][5], 2);
  }
  EXPECT_EQ(phases, (std::set{twin::Phase::launch, twin::Phase::recovery}));
  EXPECT_FALSE(twin::by_the_limits(mission, surround, start, {}).allows);
}

TEST(LimitAhead, WavesOfMembersErrAsForecastsDo) {
  const twin::Scenario mission = mission_of(
      "scour_survey",
      "waves: {components: 8, partitions: [{significant_height_m: 1.4, peak_period_s: 6, from_deg: "
      "270}]}\n");
  const twin::Surround surround = water_of(mission);
  const twin::ReadyRun ready = ready_of(mission, surround, 0);
  Snapshot forecast;
  forecast.seed = 3;
  forecast.members = members;
  forecast.columns.resize(1);
  for (int h = 0; h <= 6; ++h) {
    forecast.time.push_back(start + std::chrono::hours(h));
    forecast.columns[0].sea.push_back({1.4, 6, 270});
  }
  const twin::WaveFutures waves(forecast, members);
  for (const twin::LimitAhead& ahead :
       twin::limits_ahead(ready, 0, clock_of_four_hours, members, &waves)) {
    const twin::Limit& limit = ready.agents[0].conduct->plan.limits[ahead.limit];
    if (limit.variable != twin::LimitVariable::significant_wave_height) continue;
    ASSERT_EQ(ahead.members.size(), members);
    EXPECT_DOUBLE_EQ(ahead.members[0][3], 1.4);
    const UtcTime from = clock_of_four_hours.time_of(3), to = clock_of_four_hours.time_of(4);
    EXPECT_EQ(ahead.members[2][3],
              std::max(waves.height_m(2, 1.4, from), waves.height_m(2, 1.4, to)));
  }
}

TEST(PlannedWork, TakesAboutAsLongAsTheFlight) {
  const twin::Scenario mission = mission_of("scour_survey");
  twin::Surround surround = surround_of(mission);
  surround.field = twin::made_up_field(std::get<twin::MadeUpWater>(mission.water), surround.site,
                                       start, start + std::chrono::hours(4));
  const twin::ReadyRun ready = ready_of(mission, surround, 0);
  const twin::PhasePlan plan =
      twin::plan_of(ready.states[0].vehicle.body.position_m, ready.agents[0].mission);
  const twin::FlightCase flown{start, 0};
  const twin::Flight flight = twin::fly(mission, surround, {&flown, 1}, {}).front();
  ASSERT_TRUE(flight.is_done) << flight.stopped_by;
  EXPECT_NEAR(plan.duration_s() / flight.ended_s, 1, 0.2)
      << plan.duration_s() << " s planned, " << flight.ended_s << " s flown";
  EXPECT_EQ(plan.phases.front().phase, twin::Phase::launch);
  EXPECT_EQ(plan.phases.front().duration_s, 180);
  EXPECT_EQ(plan.phases.back().phase, twin::Phase::recovery);
}

/// A sea from the west, 1 m high, with which a bow meets it head on, abeam or astern.
TEST(LimitAhead, AHeightCountsWhereTheWavesComeFromItsSectorWithAnyBowOfThePhase) {
  const twin::Scenario mission =
      mission_of("scour_survey",
                 "waves: {partitions: [{significant_height_m: 1, peak_period_s: 6, from_deg: 270}]}"
                 "\n");
  const twin::Surround surround = water_of(mission);
  const twin::ReadyRun ready = ready_of(mission, surround, 0);
  twin::AgentState there = ready.states[0];
  twin::Limit limit;
  limit.variable = twin::LimitVariable::significant_wave_height;
  limit.bound = 0.5;
  limit.waves = twin::WaveSector{Range{0, 0.5}, {}, {}};  // head seas
  const std::vector<twin::Triple<double>> places_m{{0, 30, 0}};
  const auto worst = [&](const std::vector<twin::Course>& bows) {
    return twin::worst_at(limit, ready.agents[0], places_m, bows, 0, there).value;
  };
  const twin::Course east{0, 1}, west{0, -1}, north{1, 0};
  EXPECT_EQ(worst({west}), 1);
  EXPECT_EQ(worst({east}), 0);
  EXPECT_EQ(worst({north, east}), 0);
  EXPECT_EQ(worst({north, west, east}), 1) << "with one of its bows";
  EXPECT_EQ(worst({}), 1) << "whatever the bow, where there is none";
  limit.waves->peak_period_s = Range{7, 30};
  EXPECT_EQ(worst({}), 0) << "but not of other periods";
  limit.waves->peak_period_s.reset();
  limit.waves->heading_rad = 0;
  const twin::PhaseReach reach{{}, {}, {}, {west}};
  EXPECT_TRUE(twin::bows_of(limit, reach).empty()) << "the limit has a heading of its own";
  EXPECT_EQ(worst({}), 0);
}

}  // namespace
}  // namespace slackwater::tests::limit_ahead_test
