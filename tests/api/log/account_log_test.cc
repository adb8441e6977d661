// The account of a run is the same from its states and from its log.
#include "api/log/account_log.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "api/ask/run/heard_traffic.h"
#include "api/ask/run/scenario_run.h"
#include "api/log/account_tables.h"
#include "api/show/rehearse/account_json.h"
#include "fields/base/text.h"
#include "fields/site/site.h"
#include "tests/support/error_of.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/mission/mission_for_tests.h"
#include "twin/mission/site_work.h"
#include "twin/scenario/expand_mission.h"

namespace slackwater::tests::account_log_test {
namespace {

using namespace api;

class AccountOfARun : public ::testing::Test {
 protected:
  /// Runs a scenario, at most so long, and compares the account of its end with that of its file.
  twin::RunAccount expect_the_same(twin::Scenario scenario, const std::filesystem::path& beside,
                                   double most_s = 180) {
    scenario.duration_s = std::min(scenario.duration_s, most_s);
    if (!std::holds_alternative<twin::MadeUpWater>(scenario.water)) {
      twin::MadeUpWater water;
      water.depth_m = 35;
      scenario.water = water;
      if (!scenario.start) scenario.start = parse_utc("2025-03-10T06:00:00Z");
      for (twin::ScenarioVehicle& vehicle : scenario.vehicles)
        for (std::size_t l = 0; vehicle.conduct && l < vehicle.conduct->limits.size(); ++l)
          vehicle.conduct->limits[l].may_be_missing = true;
    }
    ScenarioWater water = water_of(scenario, folder_.path() / "store", beside);
    add_heard_traffic(scenario, beside, water);
    const ScenarioResult result = run_scenario(scenario, water, {});
    const std::filesystem::path file = folder_.path() / "run.nc";
    ingest::write_trajectories(result.file, file);
    const twin::RunAccount logged = account_in(ingest::read_trajectories(file), nullptr);
    EXPECT_EQ(logged.vehicles.size(), result.account.vehicles.size());
    for (std::size_t i = 0; i < logged.vehicles.size(); ++i) {
      const twin::VehicleAccount &a = result.account.vehicles[i], &b = logged.vehicles[i];
      EXPECT_TRUE(a == b) << scenario.name << ", " << a.name << "\n"
                          << account_json(a, result.account.start) << "\n"
                          << account_json(b, logged.start);
      for (const AccountColumn& column : account_columns()) {
        const double x = column.get(a), y = column.get(b);
        EXPECT_TRUE(x == y || (std::isnan(x) && std::isnan(y))) << column.name << x << " " << y;
      }
    }
    EXPECT_TRUE(logged == result.account) << scenario.name;
    return logged;
  }

  TemporaryFolder folder_;
};

std::vector<std::filesystem::path> files_of(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(source_folder() / "data" / folder))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  return files;
}

TEST_F(AccountOfARun, IsTheSameFromItsLogForEachScenarioOfTheDataFolder) {
  const auto files = files_of("scenarios");
  EXPECT_GE(files.size(), 3U);
  for (const auto& file : files)
    (void)expect_the_same(twin::read_scenario(file), file.parent_path());
}

TEST_F(AccountOfARun, IsTheSameFromItsLogForEachMissionOfTheDataFolder) {
  const auto files = files_of("missions");
  EXPECT_GE(files.size(), 5U);
  for (const auto& file : files) {
    const Config mission = Config::load(file);
    const Site site = find_site(mission.text("site"), {source_folder() / "data/sites"});
    twin::MissionParts parts = small_farm_parts();
    parts.site = twin::work_site_of(site);
    parts.origin = site.point;
    parts.site_id = site.id;
    twin::Scenario scenario = twin::expand_mission(mission, parts).scenario;
    scenario.origin = site.point;
    scenario.has_origin = true;
    const twin::RunAccount account = expect_the_same(scenario, file.parent_path());
    EXPECT_FALSE(account.vehicles.front().mission.empty()) << file;
  }
}

/// What befalls vehicles, and what they come to, in one run of ten minutes.
constexpr const char* hard_day = R"(name: a hard day
seed: 7
start: 2025-03-10T18:40:00Z
duration: 10min
step_s: 0.05
log_every_s: 1
water: {made_up: {depth_m: 40, current: [{depth_m: 0, east_m_s: 0, north_m_s: -1.5}],
                  wind: {speed_m_s: 3, from_deg: 270}}}
structures:
  - {name: pile, kind: cylinder, north_m: 0, east_m: 0, diameter_m: 6, top_height_m: 20,
     bottom_depth_m: 40}
vehicles:
  - {name: flat, model: x500, state_of_charge: 0.005,
     start: {north_m: 100, east_m: 0, height_m: 40}, tasks: [{do: hold}]}
  - {name: slow, model: lrauv_tethys, start: {north_m: 0, east_m: 90, depth_m: 20},
     tasks: [{do: route, waypoints: [{north_m: 500, east_m: 90, depth_m: 20}]}]}
  - {name: boat, model: ctv24, start: {north_m: -90, east_m: 0, depth_m: 0},
     tasks: [{do: route, waypoints: [{north_m: -60, east_m: 0, depth_m: 0}]}, {do: hold}]}
)";

TEST_F(AccountOfARun, TellsWhatBefellWhomWithTimesAndCauses) {
  const twin::RunAccount account =
      expect_the_same(twin::parse_scenario(hard_day, "hard_day.yaml"), folder_.path(), 600);
  ASSERT_EQ(account.vehicles.size(), 3U);
  const twin::VehicleAccount &flat = account.vehicles[0], &slow = account.vehicles[1],
                             &boat = account.vehicles[2];
  ASSERT_EQ(flat.fate.size(), 3U);
  EXPECT_EQ(flat.fate[0].what, twin::Fate::battery_empty);
  EXPECT_EQ(flat.fate[1], (twin::FateEvent{twin::Fate::fell, std::nullopt}));
  EXPECT_EQ(flat.fate[2].what, twin::Fate::struck_sea);
  EXPECT_LT(*flat.fate[0].at_s, *flat.fate[2].at_s);
  EXPECT_EQ(flat.stopped_by, "battery empty");
  EXPECT_TRUE(flat.risks().has(twin::RiskCause::energy));
  EXPECT_EQ(slow.fate.back().what, twin::Fate::slower_than_water);
  EXPECT_EQ(slow.stopped_by, "made no headway against the water");
  EXPECT_TRUE(slow.risks().has(twin::RiskCause::station));
  EXPECT_TRUE(boat.fate.empty());
  EXPECT_TRUE(boat.is_done);
  EXPECT_GT(boat.in_all.fuel_kg, 0);
  EXPECT_TRUE(boat.closest.structure.has_value());
  EXPECT_EQ(boat.closest.structure->to, "pile");
}

TEST(Fates, HaveOneNameAndOneWordingEach) {
  std::set<std::string> names, words;
  constexpr int count = static_cast<int>(twin::Fate::diverged) + 1;
  for (int i = 0; i < count; ++i) {
    const auto fate = static_cast<twin::Fate>(i);
    names.insert(name_of(fate));
    words.insert(words_of(fate));
    EXPECT_EQ(twin::fate_named(name_of(fate)), fate);
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(count));
  EXPECT_EQ(words.size(), static_cast<std::size_t>(count));
  EXPECT_FALSE(twin::fate_named("sang"));
}

TEST_F(AccountOfARun, ALogWhoseAccountIsDamagedIsRefused) {
  const twin::Scenario scenario = twin::parse_scenario(hard_day, "hard_day.yaml");
  twin::Scenario brief = scenario;
  brief.duration_s = 5;
  const ScenarioWater water = water_of(brief, folder_.path() / "store", folder_.path());
  const ingest::TrajectoryFile log = run_scenario(brief, water, {}).file;
  const auto refused = [&](auto&& change) {
    ingest::TrajectoryFile other = log;
    for (ingest::TrajectoryTable& table : other.tables)
      if (table.name == "fate") change(table);
    return error_of([&] { return account_in(other, nullptr); });
  };
  EXPECT_EQ(refused([](auto&) {}), "no error");
  EXPECT_NE(
      refused([](auto& t) { t.columns.erase(t.columns.begin() + 8); }).find("no column halted"),
      std::string::npos);
  EXPECT_NE(refused([](auto& t) { t.texts[1].values[0] = "vanished"; }).find("'vanished' as halt"),
            std::string::npos);
  EXPECT_NE(refused([](auto& t) { t.name = "luck"; }).find("0 rows, expected one for each of 3"),
            std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::account_log_test
