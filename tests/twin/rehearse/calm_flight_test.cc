#include "twin/rehearse/calm_flight.h"

#include <cmath>
#include <fstream>

#include "fields/base/text.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/mission/mission_for_tests.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/rehearse/flight.h"

namespace slackwater::tests::calm_flight_test {
namespace {

/// Water in which little would be seen, and less be flown: a calm flight knows nothing of it.
const char* const a_gale =
    "name: test\nseed: 7\nduration: 4h\nstep_s: 0.05\nlog_every_s: 1\n"
    "water: {made_up: {depth_m: 35, current: [{depth_m: 0, east_m_s: 2, north_m_s: 0}], wind: "
    "{speed_m_s: 20, from_deg: 270}}}\n"
    "waves: {components: 8, partitions: [{significant_height_m: 4, peak_period_s: 8, from_deg: "
    "270}]}\ngusts: dryden\n";

twin::ExpandedMission laid_out(const twin::MissionParts& parts, const std::string& task,
                               const std::string& turbine) {
  return twin::expand_mission(
      Config::parse(a_gale + ("tasks: [" + task + "]\nturbines: [" + turbine + "]\n"),
                    "mission.yaml"),
      parts);
}

twin::CalmFlight flown(const twin::ExpandedMission& mission,
                       const std::filesystem::path& data_folder = source_folder() / "data") {
  const twin::Scenario calm =
      twin::in_dead_calm(mission.scenario, mission.workers, mission.water_depth_m);
  twin::Surround surround = surround_of(calm);
  surround.data_folder = data_folder;
  return twin::fly_in_calm(calm, surround);
}

// --- The ten tasks. ------------------------------------------------------------------------------

struct Sheet {
  const char* task;
  const char* turbine;
  std::size_t looks;  ///< lines of its agents
};
const Sheet sheets[] = {{"blade_scan", "A01", 4},   {"tower_tp_check", "A01", 2},
                        {"scour_survey", "A01", 2}, {"cable_burial", "A01", 3},
                        {"cp_anode", "A01", 4},     {"mooring_tendon", "F01", 1},
                        {"biofouling", "A01", 1},   {"access_window", "A01", 2},
                        {"mmez", "A01", 3},         {"mob_drill", "A01", 2}};
void PrintTo(const Sheet& sheet, std::ostream* out) { *out << sheet.task; }

class TenSheets : public testing::TestWithParam<Sheet> {};

TEST_P(TenSheets, SeeInDeadCalmWhatTheyAskFor) {
  const Sheet& sheet = GetParam();
  const twin::CalmFlight flight = flown(laid_out(small_farm_parts(), sheet.task, sheet.turbine));
  EXPECT_TRUE(flight.is_flown_out);
  // Every look asks for something: what asks for nothing could not fail.
  EXPECT_EQ(flight.looks.size(), sheet.looks);
  for (const twin::CalmLook& look : flight.looks) {
    EXPECT_GT(look.asked, 0) << look.instrument;
    // The table of `api/docs/inspection.md`: --gtest_output=xml.
    RecordProperty(look.surfaces + ", " + look.instrument, std::to_string(look.covered));
    EXPECT_TRUE(look.is_seen()) << look.vehicle << ", " << look.instrument << " at "
                                << look.surfaces << ": " << look.covered << " of " << look.asked
                                << ": " << look.why;
  }
}

INSTANTIATE_TEST_SUITE_P(Tasks, TenSheets, testing::ValuesIn(sheets),
                         [](const auto& tested) { return std::string(tested.param.task); });

// --- One instrument over one cable: the swath is exact. ------------------------------------------

constexpr double reach_m = 6;
constexpr double corridor_m = 16;

/// A magnetometer that looks down all round, and a vehicle that follows the cable with it.
struct OverACable : testing::Test {
  TemporaryFolder data;  ///< that of the program, but for the instruments

  OverACable() {
    namespace fs = std::filesystem;
    for (const auto& entry : fs::directory_iterator(source_folder() / "data"))
      if (entry.is_directory() && entry.path().filename() != "instruments")
        fs::create_directory_symlink(entry.path(), data.path() / entry.path().filename());
    fs::create_directory(data.path() / "instruments");
    std::ofstream(data.path() / "instruments" / "round.yaml")
        << "name: Round magnetometer\nsource: made up\nstatus: estimate\nkind: magnetometer\n"
        << formatted("range_m: [0.1, {:g}]\n", reach_m)
        << "fan: {across_deg: 178, beam_across_deg: 1, beam_along_deg: 1, pings_per_s: 10}\n"
           "aim: {axis: [0, 0, 1]}\nnoise: {sd: 0.1, unit: m}\n";
  }

  [[nodiscard]] twin::ExpandedMission at(double above_bed_m, double seen_at,
                                         double detail_mm = 5000) const {
    twin::MissionParts parts = small_farm_parts();
    parts.site.cables = {{"straight", {{0, 0, 35}, {0, 700, 35}}, 1}};
    const std::string task = formatted(
        "id: track\nname: Track\nagents:\n  - role: tracker\n    model: lrauv_tethys\n"
        "    speed_m_s: 1\n    start: {{distance_m: 80, depth_m: 6}}\n"
        "    clear_m: 20\n    conduct: {{}}\n    inspection:\n"
        "      surfaces: [{{kind: cable, cable: straight, corridor_m: {:g}, off_ends_m: 80}}]\n"
        "      patch_m: 0.5\n"
        "      looks: [{{instrument: round, kinds: [cable], detail_mm: {:g}, seen_at: {:g}}}]\n"
        "    work:\n      - {{pattern: cable, cable: straight, at: {{above_bed_m: {:g}}}, "
        "off_ends_m: 80}}\n",
        corridor_m, detail_mm, seen_at, above_bed_m);
    parts.task = [task](const std::string&) { return Config::parse(task, "track.yaml"); };
    return laid_out(parts, "track", "A01");
  }
  [[nodiscard]] twin::CalmFlight flown(const twin::ExpandedMission& mission) const {
    return calm_flight_test::flown(mission, data.path());
  }
};

/// Of a strip, of what is in reach of a line above its middle: 2 sqrt(R^2 - h^2).
double share_in_reach(double above_bed_m) {
  if (above_bed_m >= reach_m) return 0;
  return std::min(1.0, 2 * std::sqrt(reach_m * reach_m - above_bed_m * above_bed_m) / corridor_m);
}

TEST_F(OverACable, WhatIsSweptIsTheChordOfTheReach) {
  for (const double above_bed_m : {2.0, 3.0, 4.0, 5.0, 5.5}) {
    const twin::CalmFlight flight = flown(at(above_bed_m, 0.01));
    EXPECT_TRUE(flight.is_flown_out);
    ASSERT_EQ(flight.looks.size(), 1U);
    // Half a patch at either edge, and what the vehicle is off its line and depth.
    EXPECT_NEAR(flight.looks[0].covered, share_in_reach(above_bed_m), 0.8 / corridor_m)
        << above_bed_m;
  }
}

TEST_F(OverACable, NothingIsSweptFromBeyondTheReach) {
  for (const double above_bed_m : {6.3, 7.0}) {
    const twin::CalmFlight flight = flown(at(above_bed_m, 0.9));
    EXPECT_TRUE(flight.is_flown_out) << "done, and nothing seen";
    ASSERT_EQ(flight.looks.size(), 1U);
    EXPECT_EQ(flight.looks[0].covered, 0) << above_bed_m;
    EXPECT_FALSE(flight.looks[0].is_seen());
    const std::string& why = flight.looks[0].why;
    const std::string passes = "it reaches 6 m, the path passes ";
    ASSERT_EQ(why.find(passes), 0U) << why;
    EXPECT_NEAR(std::stod(why.substr(passes.size())), above_bed_m, 0.3) << why;
    EXPECT_NE(why.find("100 % are never in its view; lay the path nearer"), std::string::npos)
        << why;
  }
}

TEST_F(OverACable, WhatIsTooCoarseIsToldSo) {
  // Its beam of a degree is wider than a centimetre from 4 m.
  const twin::CalmFlight flight = flown(at(4, 0.9, 10));
  ASSERT_EQ(flight.looks.size(), 1U);
  EXPECT_EQ(flight.looks[0].covered, 0);
  EXPECT_NE(flight.looks[0].why.find("without the detail of 10 mm"), std::string::npos)
      << flight.looks[0].why;
}

/// P(done) and P(seen) are two: the same flight, by what is asked of it.
TEST_F(OverACable, AFlightThatSeesNothingIsDoneAndNotSeen) {
  const auto flown_once = [&](double above_bed_m, double seen_at) {
    const twin::ExpandedMission mission = at(above_bed_m, seen_at);
    const twin::Scenario calm =
        twin::in_dead_calm(mission.scenario, mission.workers, mission.water_depth_m);
    twin::Surround surround = surround_of(calm);
    surround.data_folder = data.path();
    const UtcTime start = parse_utc("2025-06-02T06:00:00Z");
    surround.field = twin::made_up_field(std::get<twin::MadeUpWater>(calm.water), surround.site,
                                         start, start + std::chrono::hours(5));
    const twin::FlightCase once{start, 0};
    return twin::fly(calm, surround, {&once, 1}, {mission.scenario.duration_s, mission.workers})
        .front();
  };
  const twin::Flight blind = flown_once(7, 0.5);
  EXPECT_TRUE(blind.is_done) << blind.stopped_by;
  EXPECT_EQ(blind.is_seen, std::optional(false));
  EXPECT_FALSE(blind.is_success());
  EXPECT_EQ(blind.stopped_by, "");
  EXPECT_EQ(blind.unseen_by, "less than 50 % covered by the Round magnetometer (tracker)");
  EXPECT_TRUE(blind.vehicles[0].risks().has(twin::RiskCause::unseen));
  EXPECT_FALSE(blind.vehicles[0].risks().has(twin::RiskCause::work));
  const twin::Flight seeing = flown_once(2, 0.5);
  EXPECT_TRUE(seeing.is_done && seeing.is_seen == true && seeing.is_success());
  EXPECT_TRUE(seeing.vehicles[0].risks().none());
  // Where nothing is asked there is nothing to have seen.
  const twin::Flight unasked = flown_once(7, 0);
  EXPECT_TRUE(unasked.is_done && !unasked.is_seen && unasked.is_success());
}

}  // namespace
}  // namespace slackwater::tests::calm_flight_test
