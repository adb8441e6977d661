#include <algorithm>
#include <string_view>

#include "fields/base/text.h"
#include "tests/twin/mission/mission_for_tests.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/rehearse/flight.h"

namespace slackwater::tests::ten_tasks_test {
namespace {

/// Water that is the same at all times.
struct Water {
  double current_m_s = 0.05;
  double wind_m_s = 2;
  double height_m = 0.2;  ///< significant, of waves of 5 s
};

twin::Scenario mission_of(const std::string& task, const std::string& turbine, const Water& water,
                          const std::string& more = "") {
  const std::string yaml =
      "name: test\nseed: 7\nduration: 4h\nstep_s: 0.05\nlog_every_s: 1\n" +
      formatted(
          "water: {{made_up: {{depth_m: 35, current: [{{depth_m: 0, east_m_s: {}, north_m_s: "
          "0}}], wind: {{speed_m_s: {}, from_deg: 270}}}}}}\n",
          water.current_m_s, water.wind_m_s) +
      formatted(
          "waves: {{components: 8, partitions: [{{significant_height_m: {}, peak_period_s: "
          "5, from_deg: 270}}]}}\n",
          water.height_m) +
      "tasks: [" + task + "]\nturbines: [" + turbine + "]\n";
  const Config config = Config::parse(yaml + more, "mission.yaml");
  return twin::expand_mission(config, small_farm_parts()).scenario;
}

twin::Flight flown(const twin::Scenario& mission) {
  twin::Surround surround = surround_of(mission);
  const UtcTime start = parse_utc("2025-06-02T06:00:00Z");
  surround.field = twin::made_up_field(std::get<twin::MadeUpWater>(mission.water), surround.site,
                                       start, start + std::chrono::hours(5));
  const twin::FlightCase flown{start, 0};
  return twin::fly(mission, surround, {&flown, 1}, {}).front();
}

/// A task, water near its limits, and water beyond one of them.
struct Trial {
  const char* task;
  const char* turbine;
  Water marginal;
  Water forbidden;
  const char* forbids;  ///< the limit, in words
};

const Trial trials[] = {
    {"blade_scan", "A01", {0.05, 5.2, 0.2}, {0.05, 9, 0.2}, "gusts at the work"},
    {"tower_tp_check", "A01", {0.05, 5.5, 0.2}, {0.05, 9, 0.2}, "gusts at the work"},
    {"scour_survey", "A01", {0.46, 2, 0.2}, {0.56, 2, 0.2}, "current"},
    {"cable_burial", "A01", {0.45, 2, 0.2}, {0.55, 2, 0.2}, "current"},
    {"cp_anode", "A01", {0.44, 2, 0.3}, {0.1, 2, 1.7}, "significant wave height"},
    {"mooring_tendon", "F01", {0.44, 2, 0.2}, {0.1, 13, 0.2}, "wind at 10 m"},
    {"biofouling", "A01", {0.36, 2, 0.2}, {0.45, 2, 0.2}, "current"},
    {"access_window", "A01", {0.2, 4, 1.2}, {0.2, 4, 1.8}, "motion of the deck"},
    {"mmez", "A01", {0.3, 5.2, 0.9}, {0.3, 5.2, 1.2}, "significant wave height"},
    {"mob_drill", "A01", {0.2, 6.2, 0.9}, {0.2, 13, 0.9}, "gusts at the work"},
};

void PrintTo(const Trial& trial, std::ostream* out) { *out << trial.task; }

double worst_share(const twin::Flight& flight) {
  double worst = 0;
  for (const twin::VehicleAccount& vehicle : flight.vehicles)
    worst = std::max(worst, vehicle.worst_share);
  return worst;
}

class TenTasks : public testing::TestWithParam<Trial> {};

/// Flights of hours with vessels take half a minute each under sanitizers, where one in calm water
/// has told what they tell; `make soak` makes the others.
bool is_long_here(const Trial& trial) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  const std::string_view task = trial.task;
  return task == "access_window" || task == "mmez" || task == "mob_drill";
#else
  (void)trial;
  return false;
#endif
}

TEST_P(TenTasks, AreDoneInCalmWater) {
  const Trial& trial = GetParam();
  const twin::Flight flight = flown(mission_of(trial.task, trial.turbine, {}));
  EXPECT_TRUE(flight.is_done) << flight.stopped_by;
  EXPECT_LT(worst_share(flight), 0.7);
  for (const twin::VehicleAccount& vehicle : flight.vehicles) {
    EXPECT_EQ(vehicle.held_s, 0) << vehicle.name;
    EXPECT_EQ(vehicle.work_share(), 1) << vehicle.name;
  }
}

TEST_P(TenTasks, AreDoneNearTheirLimitsWithLessToSpare) {
  const Trial& trial = GetParam();
  if (is_long_here(trial)) GTEST_SKIP() << "flown without sanitizers by make soak";
  const twin::Flight flight = flown(mission_of(trial.task, trial.turbine, trial.marginal));
  EXPECT_TRUE(flight.is_done) << flight.stopped_by;
  EXPECT_GT(worst_share(flight), 0.8);
  EXPECT_LE(worst_share(flight), 1);
}

TEST_P(TenTasks, AreNotBegunBeyondThem) {
  const Trial& trial = GetParam();
  if (is_long_here(trial)) GTEST_SKIP() << "flown without sanitizers by make soak";
  const twin::Flight flight = flown(mission_of(trial.task, trial.turbine, trial.forbidden));
  EXPECT_FALSE(flight.is_done);
  EXPECT_NE(flight.stopped_by.find(std::string("limit: ") + trial.forbids), std::string::npos)
      << flight.stopped_by;
  for (const twin::VehicleAccount& vehicle : flight.vehicles) {
    if (vehicle.is_done) continue;
    EXPECT_LT(vehicle.work_share(), 0.7) << vehicle.name;
    // It waits for half an hour, then it is home.
    EXPECT_GT(vehicle.held_s, 1700) << vehicle.name;
    // And safe where its mission ends at its home.
    const auto is_end = [](const auto& event) {
      return event.kind == twin::ConductEventKind::finished;
    };
    EXPECT_TRUE(std::any_of(vehicle.mission.rbegin(), vehicle.mission.rbegin() + 2, is_end))
        << vehicle.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Tasks, TenTasks, testing::ValuesIn(trials),
                         [](const auto& tested) { return std::string(tested.param.task); });

TEST(Flight, IsTheSameToTheBitInWhateverCompanyItIsFlown) {
  twin::Scenario mission = mission_of("cp_anode", "A01", {0.1, 3, 0.4});
  mission.duration_s = 400;
  twin::Surround surround = surround_of(mission);
  const UtcTime start = parse_utc("2025-06-02T06:00:00Z");
  surround.field = twin::made_up_field(std::get<twin::MadeUpWater>(mission.water), surround.site,
                                       start, start + std::chrono::hours(5));
  const std::vector<twin::FlightCase> three{{start, 0}, {start, 1}, {start, 2}};
  const auto together = twin::fly(mission, surround, three, {});
  const auto alone = twin::fly(mission, surround, {&three[2], 1}, {});
  ASSERT_EQ(together.size(), 3U);
  EXPECT_EQ(together[2].vehicles[0].on_mission.drawn_j, alone[0].vehicles[0].on_mission.drawn_j);
  EXPECT_EQ(together[2].ended_s, alone[0].ended_s);
  // Futures differ: the pilot's hand and the gusts are others.
  EXPECT_NE(together[1].vehicles[0].on_mission.drawn_j, together[2].vehicles[0].on_mission.drawn_j);
}

}  // namespace
}  // namespace slackwater::tests::ten_tasks_test
