// What is written of a scenario is read as the same scenario, to the bit.
#include "twin/scenario/write_scenario.h"

#include <gtest/gtest.h>

#include "tests/support/asked_number.h"
#include "tests/support/error_of.h"
#include "tests/twin/mission/mission_for_tests.h"
#include "tests/twin/scenario/random_scenario.h"
#include "twin/mission/site_work.h"

namespace slackwater::tests::write_scenario_test {
namespace {

/// But for the text that it came of.
twin::Scenario without_text(twin::Scenario scenario) {
  scenario.yaml.clear();
  return scenario;
}

void expect_comes_back(const twin::Scenario& scenario, const std::string& who) {
  const std::string yaml = write_scenario(scenario);
  twin::Scenario again;
  ASSERT_EQ(error_of([&] { return again = twin::parse_scenario(yaml, who); }), "no error") << yaml;
  EXPECT_EQ(again.yaml, yaml);
  EXPECT_TRUE(without_text(again) == without_text(scenario)) << who << "\n" << yaml;
  EXPECT_EQ(write_scenario(again), yaml) << who;
}

std::vector<std::filesystem::path> files_of(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(source_folder() / "data" / folder))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  return files;
}

TEST(WriteScenario, EachOfTheDataFolderComesBack) {
  const auto files = files_of("scenarios");
  EXPECT_GE(files.size(), 3U);
  for (const auto& file : files) expect_comes_back(twin::read_scenario(file), file.string());
}

TEST(WriteScenario, EachMissionOfTheDataFolderComesBackAsItWasLaidOut) {
  const auto files = files_of("missions");
  EXPECT_GE(files.size(), 5U);
  for (const auto& file : files) {
    const Config mission = Config::load(file);
    const Site site = find_site(mission.text("site"), {source_folder() / "data/sites"});
    twin::MissionParts parts = small_farm_parts();
    parts.site = twin::work_site_of(site);
    parts.origin = site.point;
    parts.site_id = site.id;
    expect_comes_back(twin::expand_mission(mission, parts).scenario, file.string());
  }
}

TEST(WriteScenario, EachTaskComesBackAsItWasLaidOut) {
  const auto files = files_of("tasks");
  EXPECT_GE(files.size(), 10U);
  for (const auto& file : files) {
    const std::string id = file.stem().string();
    const Config mission =
        Config::parse("{name: t, seed: 1, duration: 3h, tasks: [" + id + "], turbines: [" +
                          (id == "mooring_tendon" ? "F01" : "A01, A02") + "]}",
                      "mission.yaml");
    twin::MissionParts parts = small_farm_parts();
    parts.site_id = "a";
    std::optional<twin::Scenario> scenario;
    try {
      scenario = twin::expand_mission(mission, parts).scenario;
    } catch (const Error&) {  // on a tether, at one turbine alone
      scenario = twin::expand_mission(Config::parse("{name: t, seed: 1, duration: 3h, tasks: [" +
                                                        id + "], turbines: [A01]}",
                                                    "mission.yaml"),
                                      parts)
                     .scenario;
    }
    expect_comes_back(*scenario, id);
  }
}

TEST(WriteScenario, MadeUpOnesComeBack) {
  const int seeds = asked_number("SLACKWATER_SCENARIOS", 80);
  for (int seed = 1; seed <= seeds && !HasFailure(); ++seed)
    expect_comes_back(RandomScenario(static_cast<std::uint64_t>(seed)).make(),
                      "seed " + std::to_string(seed));
}

}  // namespace
}  // namespace slackwater::tests::write_scenario_test
