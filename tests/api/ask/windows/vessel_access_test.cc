// The vessel that brings a task: her ways and the transfers of people are in the chance of a start.
#include "api/ask/windows/vessel_access.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "api/ask/windows/windows.h"
#include "api/show/windows/windows_answer.h"
#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/farm_for_tests.h"

namespace slackwater::tests::vessel_access_test {
namespace {

using namespace slackwater::api;
using std::chrono::minutes;

/// A storm of an hour on a calm day, in a forecast of the store's.
class VesselWays : public testing::Test {
 protected:
  static constexpr double calm_m = 0.3, storm_m = 4, at_most_m = 2, over_at_most_m = 1;
  static constexpr minutes passage{60}, transfer{15};

  static void SetUpTestSuite() {
    made_ = std::make_unique<StoreForTests>();
    made_->ingest_days(parse_day("2025-03-01"), 3);
    made_->write("vessel.yaml",
                 "name: Workboat\ntransfer: 15min\nlimits:\n"
                 "  - {significant_wave_height_m: 2, phases: [transit, return]}\n"
                 "  - {significant_wave_height_m: 1, phases: [launch, recovery]}\n");
    made_->write("bare.yaml", farm_at_the_site(*made_));
    made_->write("farm.yaml",
                 farm_at_the_site(*made_, "access: {vessel: " + made_->path("vessel.yaml") +
                                              ", passage: 60min}\n"));
    const ProgramResult issued = made_->run(
        {"forecast", "--site", made_->path("bare.yaml"), "--at", "2025-03-04T05:10:00Z"});
    ASSERT_EQ(issued.exit_code, 0) << issued.err;
  }
  static void TearDownTestSuite() { made_.reset(); }

  static UtcTime storm() { return parse_utc("2025-03-05T12:00:00Z"); }
  static WindowsQuestion question(const char* site) {
    WindowsQuestion question;
    question.site = made_->path(site);
    question.tasks = {"scour_survey"};
    question.practice = AlphaPractice::of_tables({});
    question.waves_as_forecast = true;
    return question;
  }
  /// With that sea, in water and air that hardly move.
  static WindowsQuestion in_the_storm(const char* site) {
    WindowsQuestion asked = question(site);
    Snapshot sea =
        windows_of(question("bare.yaml"), made_->store()).water.surround.field->snapshot();
    for (ForecastColumn& column : sea.columns) {
      for (auto* speeds :
           {&column.current_m_s, &column.member_m_s, &column.wind_m_s, &column.wind_member_m_s})
        std::fill(speeds->begin(), speeds->end(), Horizontal(0.1, 0));
      for (std::size_t t = 0; t < sea.time.size(); ++t)
        column.sea[t].significant_height_m = sea.time[t] == storm() ? storm_m : calm_m;
    }
    asked.water = water_of(std::make_shared<const Snapshot>(std::move(sea)), {});
    return asked;
  }
  /// The greatest height from one time to the other, both moved out to the grid of ten minutes.
  static double highest_m(UtcTime from, UtcTime to) {
    from = std::chrono::floor<std::chrono::duration<long, std::ratio<600>>>(from);
    to = std::chrono::ceil<std::chrono::duration<long, std::ratio<600>>>(to);
    const UtcTime nearest = std::clamp(storm(), from, to);
    const double away_h = std::abs(hours_between(storm(), nearest));
    return calm_m + (storm_m - calm_m) * std::max(0.0, 1 - away_h);
  }

  inline static std::unique_ptr<StoreForTests> made_;
};

TEST_F(VesselWays, AreInTheChanceOfEveryStart) {
  const TaskWindows alone = windows_of(in_the_storm("bare.yaml"), made_->store()).tasks.front();
  const TaskWindows brought = windows_of(in_the_storm("farm.yaml"), made_->store()).tasks.front();
  ASSERT_EQ(alone.starts.size(), brought.starts.size());
  std::size_t lost = 0;
  for (std::size_t i = 0; i < alone.starts.size(); ++i) {
    const UtcTime start = alone.starts[i].start;
    ASSERT_EQ(brought.starts[i].start, start);
    const UtcTime done = start + std::chrono::minutes(90), late = done + minutes(30);
    ASSERT_EQ(brought.planned_s, 5400);
    ASSERT_EQ(brought.contingency_s, 1800);
    const bool out = highest_m(start - transfer - passage, start - transfer) <= at_most_m;
    const bool over = highest_m(start - transfer, start) <= over_at_most_m;
    const bool back = highest_m(done, late + transfer) <= over_at_most_m;
    const bool home = highest_m(done + transfer, late + transfer + passage) <= at_most_m;
    EXPECT_EQ(brought.starts[i].chance.by_threshold,
              alone.starts[i].chance.by_threshold && out && over && back && home)
        << format_utc(start);
    EXPECT_LE(brought.starts[i].probability, alone.starts[i].probability);
    lost += alone.starts[i].chance.by_threshold && !brought.starts[i].chance.by_threshold ? 1 : 0;
  }
  EXPECT_GE(lost, 4U) << "two starts before the storm and two after it";
  EXPECT_TRUE(alone.starts.front().chance.by_threshold);
  EXPECT_TRUE(brought.starts.front().chance.by_threshold) << "the way out began the day before";
}

TEST_F(VesselWays, SayWhereAndWhenTheyStopAStart) {
  const TaskWindows brought = windows_of(in_the_storm("farm.yaml"), made_->store()).tasks.front();
  const auto start = std::find_if(brought.starts.begin(), brought.starts.end(), [](const auto& s) {
    return s.start == parse_utc("2025-03-05T13:30:00Z");
  });
  ASSERT_NE(start, brought.starts.end());
  ASSERT_TRUE(start->chance.binding && start->chance.binding->is_exceeded);
  EXPECT_EQ(text_of(brought.limits[start->chance.binding->limit]),
            "significant wave height at most 2 m under way (Workboat)");
  EXPECT_EQ(format_utc(*start->binds_at), "2025-03-05T12:10:00Z") << "as she leaves port";
}

/// The landing is in the north of the pile, so that she pushes on it with her bow to the south.
TEST_F(VesselWays, LetPeopleGoOverByTheAngleOffABowOnTheLanding) {
  const auto thresholds = [&](const std::string& phases, double from_deg, std::string* told) {
    made_->write("table.yaml",
                 "name: Workboat\ntransfer: 15min\nlimits:\n  - {significant_wave_height_m: {rows: "
                 "[{from_bow_deg: 0, at_most: 2}, {from_bow_deg: 90, at_most: 1}]}, phases: [" +
                     phases + "]}\n");
    made_->write("by_table.yaml",
                 farm_at_the_site(*made_, "access: {vessel: " + made_->path("table.yaml") +
                                              ", passage: 60min}\n"));
    WindowsQuestion asked = in_the_storm("bare.yaml");
    asked.site = made_->path("by_table.yaml");
    Snapshot sea = asked.water->surround.field->snapshot();
    for (ForecastColumn& column : sea.columns)
      std::fill(column.sea.begin(), column.sea.end(), SeaState{1.3, 6, from_deg});
    asked.water = water_of(std::make_shared<const Snapshot>(std::move(sea)), {});
    const WindowsAnswer answer = windows_of(asked, made_->store());
    *told = windows_text(asked, answer);
    const TaskWindows& task = answer.tasks.front();
    std::size_t allowed = 0;
    for (const TaskStart& start : task.starts) allowed += start.chance.by_threshold ? 1 : 0;
    EXPECT_TRUE(allowed == 0 || allowed == task.starts.size()) << "the sea is always the same";
    return allowed > 0;
  };
  std::string told;
  EXPECT_TRUE(thresholds("launch, recovery", 180, &told)) << told;
  EXPECT_FALSE(thresholds("launch, recovery", 90, &told));
  EXPECT_TRUE(contains(told, "the limit 1 m at waves 90 degrees off the bow at ")) << told;
  EXPECT_TRUE(contains(told, "heading 180")) << told;
  EXPECT_FALSE(thresholds("launch, recovery", 0, &told)) << "following seas are as at 90";
  EXPECT_TRUE(contains(told, "180 degrees off the bow (the table ends at 90)")) << told;
  // Under way nobody knows her bow.
  EXPECT_FALSE(thresholds("transit", 180, &told));
  EXPECT_TRUE(
      contains(told, "the worst heading, since that of the bow or of the waves is not known"))
      << told;
}

TEST_F(VesselWays, AreToldBesideTheChances) {
  const WindowsQuestion asked = in_the_storm("farm.yaml");
  const WindowsAnswer answer = windows_of(asked, made_->store());
  EXPECT_TRUE(contains(windows_text(asked, answer),
                       "the ways of the workboat (1.0 h each) and the transfers (15 min each)"));
  EXPECT_EQ(windows_json(asked, answer).at("access"),
            (nlohmann::json{{"vessel", "Workboat"}, {"passage_min", 60}, {"transfer_min", 15}}));
  EXPECT_TRUE(windows_json(asked, windows_of(in_the_storm("bare.yaml"), made_->store()))
                  .at("access")
                  .is_null());
}

TEST_F(VesselWays, CannotHaveBegunBeforeTheForecastWasIssued) {
  WindowsQuestion asked = in_the_storm("farm.yaml");
  asked.from = parse_utc("2025-03-04T05:30:00Z");
  asked.to = parse_utc("2025-03-04T12:00:00Z");
  const TaskWindows task = windows_of(asked, made_->store()).tasks.front();
  for (const TaskStart& start : task.starts) {
    const bool is_late = start.start < parse_utc("2025-03-04T06:25:00Z");
    EXPECT_EQ(!start.forbidden.empty(), is_late) << format_utc(start.start);
    if (is_late) {
      EXPECT_EQ(start.probability, 0);
      EXPECT_TRUE(contains(start.forbidden, "before the forecast was issued")) << start.forbidden;
    }
  }
}

TEST_F(VesselWays, OfStartsTooEarlyForTheForecastAreNamedAsTheCause) {
  WindowsQuestion asked = in_the_storm("farm.yaml");
  const UtcTime begins = asked.water->surround.field->range().from;
  asked.from = begins;
  asked.to = begins + std::chrono::hours(1);
  try {
    (void)windows_of(asked, made_->store());
    ADD_FAILURE() << "she would have left before anything is known";
  } catch (const Error& refused) {
    EXPECT_TRUE(contains(refused.message(), "the vessel leaves port 1.3 h before a start"))
        << refused.message();
    EXPECT_TRUE(contains(refused.message(), "ask for starts from"));
  }
  asked.to = begins + std::chrono::hours(6);
  const TaskWindows task = windows_of(asked, made_->store()).tasks.front();
  EXPECT_GE(task.starts.front().start, begins + transfer + passage);
  EXPECT_TRUE(std::any_of(task.notes.begin(), task.notes.end(), [](const std::string& note) {
    return contains(note, "are left out: the vessel leaves port");
  }));
}

TEST_F(VesselWays, AreRefusedWhereTheyCannotBe) {
  const auto refusal = [&](const std::string& vessel, const std::string& passage) {
    made_->write("bad.yaml", farm_at_the_site(*made_, "access: {vessel: " + vessel +
                                                          ", passage: " + passage + "}\n"));
    try {
      (void)windows_of(question("bad.yaml"), made_->store());
    } catch (const Error& refused) {
      return std::string(refused.message());
    }
    return std::string();
  };
  const std::string good = made_->path("vessel.yaml");
  EXPECT_TRUE(contains(refusal("crew_transfer_vesel", "1h"), "crew_transfer_vessel"));
  EXPECT_TRUE(contains(refusal(good, "25h"), "0min to 24h"));
  EXPECT_TRUE(contains(refusal(good, "fast"), "passage"));
  made_->write("deck.yaml", "name: Boat\ntransfer: 15min\nlimits: [{deck_motion_m: 1}]\n");
  EXPECT_TRUE(contains(refusal(made_->path("deck.yaml"), "1h"), "only a run shows"));
  made_->write("more.yaml", "name: Boat\ntransfer: 15min\nspeed: 5\nlimits: []\n");
  EXPECT_TRUE(contains(refusal(made_->path("more.yaml"), "1h"), "speed"));
}

TEST(StepsOfAccess, AreHersFromPortToPort) {
  using twin::Phase;
  const VesselAccess vessel{"Boat", minutes(60), minutes(15), {}};
  const auto steps = [&](std::initializer_list<Phase> phases) {
    twin::PhaseSet set;
    set.bits = 0;
    for (const Phase phase : phases) set.add(phase);
    return steps_of_access(vessel, set, 8, 3600, 1200, minutes(10));
  };
  // 75 min before the start are 8 steps; the work takes 6, its contingency 2.
  EXPECT_EQ(steps({Phase::transit}), (twin::StepRanges{{0, 7}}));
  EXPECT_EQ(steps({Phase::launch}), (twin::StepRanges{{6, 8}}));
  EXPECT_EQ(steps({Phase::work}), (twin::StepRanges{{8, 16}}));
  EXPECT_EQ(steps({Phase::recovery}), (twin::StepRanges{{14, 18}}));
  EXPECT_EQ(steps({Phase::return_home}), (twin::StepRanges{{15, 24}}));
  EXPECT_EQ(steps({Phase::launch, Phase::recovery}), (twin::StepRanges{{6, 8}, {14, 18}}));
  EXPECT_EQ(
      steps({Phase::transit, Phase::launch, Phase::work, Phase::recovery, Phase::return_home}),
      (twin::StepRanges{{0, 24}}));
}

}  // namespace
}  // namespace slackwater::tests::vessel_access_test
