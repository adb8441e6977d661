#pragma once
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/page_keys.h"
#include "twin/mission/limit.h"
#include "twin/scenario/actuator_table.h"

// The sections of api/docs/scenario_file.md, and what of the readers asks for the keys of each.

namespace slackwater::twin::scenario_page {

using tests::Words;

/// A function of a reader, or another part of it: from where it begins to where it ends. Without a
/// begin the whole file.
struct Piece {
  const char* file;
  const char* begins = "";
  const char* ends = "\n}\n";
};
/// A section of the page, up to the next heading, and what asks for the keys in its tables.
struct PagePart {
  const char* heading;
  std::vector<Piece> pieces;
  Words no_keys{};    ///< between quotes there: words that a key may have, pieces of messages
  Words made_keys{};  ///< that stand in no quotes
};

inline constexpr const char* reader = "twin/scenario/read_scenario.cc";
inline constexpr const char* place_reader = "twin/scenario/read_place.cc";
inline constexpr const char* task_reader = "twin/scenario/read_task.cc";
inline constexpr const char* water_reader = "twin/scenario/read_surroundings.cc";
inline constexpr const char* traffic_reader = "twin/scenario/read_traffic.cc";
inline constexpr const char* manoeuvre_reader = "twin/scenario/manoeuvre_task.cc";
inline constexpr const char* conduct_reader = "twin/mission/read_conduct.cc";
inline constexpr const char* limit_reader = "twin/mission/limit.cc";
inline constexpr const char* surface_reader = "twin/inspection/surface/read_surface.cc";
inline constexpr const char* defect_facts_reader = "twin/inspection/defect/read_defect_facts.cc";
inline constexpr const char* branch_end = "\n  }";

inline Words limit_keys() {
  Words keys;
  for (const LimitWord& word : limit_words()) keys.insert(word.key);
  return keys;
}

inline Words keys_of_actuators() {
  Words keys;
  for (int unit = 0; unit <= static_cast<int>(KeyUnit::m); ++unit)
    keys.insert("NAME" + std::string(suffix_of(static_cast<KeyUnit>(unit))));
  return keys;
}

inline const std::vector<PagePart>& parts() {
  static const std::vector<PagePart> all{
      {"## The scenario as a whole",
       {{reader, "Scenario read_setting("},
        {reader, "Scenario read(const Config"},
        {reader, "bool read_navigation("},
        {water_reader, "const auto c = config.optional_child(\"waves\")", ";"},
        {traffic_reader, "const auto config = scenario.optional_child(\"traffic\")", ";"}},
       {"none", "dryden", "truth", "sensors", "tasks", "turbines"},
       {"sensors"}},
      {"## Places, times and speeds",
       {{place_reader, "double read_down("},
        {place_reader, "Triple<double> read_place("},
        {place_reader, "AskedSpeed read_speed("}}},
      {"## Water",
       {{water_reader, "std::variant<ForecastWater, MadeUpWater> read_water("},
        {water_reader, "ForecastWater read_forecast("},
        {water_reader, "MadeUpWater read_made_up("}},
       {"water"}},
      {"## Waves",
       {{water_reader, "ScenarioWaves read_waves("}, {water_reader, "RegularWave read_regular("}},
       {"waves", "forecast", "calm"}},
      {"## Structures",
       {{water_reader, "ScenarioStructure read_structure("}},
       {"structure", "cylinder", "box"}},
      {"## Vehicles",
       {{reader, "ScenarioVehicle read_vehicle("},
        {reader, "StepDetail read_detail("},
        {reader, "bool read_navigation("},
        {reader, "FollowerChoice read_follower("},
        {reader, "TetherStart read_tether_start("},
        {reader, "Carrier read_carrier("},
        {reader, "fault_of_names("},
        {reader, "fault_of(const ScenarioVehicle"}},
       {"full", "coarse", "truth", "sensors", "line_of_sight", "no_feed_forward", "paper",
        "public"}},
      {"### Of every task",
       {{task_reader, "const std::string kind = config.text(\"do\")", ";"},
        {task_reader, "config.refuse(\"do\"", "  return task;"}},
       {"fixed", "drifting"}},
      {"### route",
       {{task_reader, "if (kind == \"route\")", branch_end}, {task_reader, "read_waypoints("}},
       {"route", "waypoints"},
       {"waypoints"}},
      {"### hold", {{task_reader, "if (kind == \"hold\")", branch_end}}, {"hold"}},
      {"### lawn_mower",
       {{task_reader, "if (kind == \"lawn_mower\")", branch_end},
        {task_reader, "const auto course = ", "\n"}},
       {"lawn_mower"}},
      {"### orbit", {{task_reader, "if (kind == \"orbit\")", branch_end}}, {"orbit"}},
      {"### depth_sweep",
       {{task_reader, "if (kind == \"depth_sweep\")", branch_end},
        {task_reader, "const auto course = ", "\n"}},
       {"depth_sweep"}},
      {"### aboard",
       {{task_reader, "if (kind == \"aboard\")", branch_end},
        {task_reader, "double read_charger("},
        {task_reader, "bool read_until("}},
       {"aboard", "keep", "charge", "swap", "stand_by"}},
      {"### stand_by", {{task_reader, "if (kind == \"stand_by\")", branch_end}}, {"stand_by"}},
      {"### follow_track",
       {{task_reader, "if (kind == \"follow_track\")", branch_end},
        {traffic_reader, "TrackToFollow read_track_to_follow("},
        {traffic_reader, "uint32_t read_mmsi("},
        {traffic_reader, "AisLog read_log("}},
       {"follow_track"}},
      {"### actuators",
       {{task_reader, "if (kind == \"actuators\")", branch_end},
        {"twin/scenario/actuator_table.cc"}},
       {"actuators", "depth", "heading", "speed"},
       keys_of_actuators()},
      {"### Manoeuvres",
       {{manoeuvre_reader, "ManoeuvreTask read_manoeuvre("},
        {manoeuvre_reader, "bool read_to_port("},
        {manoeuvre_reader, "void read_helm("}},
       {"starboard", "port"}},
      {"#### turning_circle", {{manoeuvre_reader, "void read_turning_circle("}}},
      {"#### zig_zag", {{manoeuvre_reader, "void read_zig_zag("}}},
      {"#### spiral", {{manoeuvre_reader, "void read_spiral("}}},
      {"#### pull_out", {{manoeuvre_reader, "void read_pull_out("}}},
      {"### steps",
       {{manoeuvre_reader, "void read_steps("}, {manoeuvre_reader, "KeptStep read_step("}}},
      {"## Other vessels",
       {{traffic_reader, "ScenarioTraffic read_traffic("},
        {traffic_reader, "MadeUpVessel read_vessel("},
        {traffic_reader, "uint32_t read_mmsi("},
        {traffic_reader, "uint32_t> read_mmsis("},
        {traffic_reader, "AisLog read_log("}},
       {"traffic"}},
      {"## Keeping clear", {{"twin/clearance/read_stand_off.cc"}}},
      {"## Conduct",
       {{conduct_reader, "Triple<double> read_home("},
        {conduct_reader, "Autonomy read_autonomy("},
        {conduct_reader, "void read_pilot("},
        {conduct_reader, "void read_envelope("},
        {conduct_reader, "void read_mammals(", "(void)"},
        {conduct_reader, "const char* name_of("},
        {conduct_reader, "Conduct read_conduct("},
        {limit_reader, "for (const Config& entry : config.children(\"limits\")", ";"},
        {limit_reader, "const auto assume =", ";"},
        {"twin/mission/fault.cc", "vector<Fault> read_faults("}},
       {"auto", "shared", "teleop", "unknown"}},
      {"## Limits",
       {{limit_reader, "std::optional<double> read_down("},
        {limit_reader, "PhaseSet read_phases("},
        {limit_reader, "std::optional<double> read_heading("},
        {limit_reader, "std::optional<Limit> read_limit_by_sea("},
        {limit_reader, "Limit read_limit(const Config"},
        {limit_reader, "read_limits(const Config"},
        {limit_reader, "read_assumptions("},
        {limit_reader, "std::string text_of(const Limit&"},
        {"twin/mission/height_table.cc"},
        {"twin/mission/wave_sector.cc"}},
       {"error", "least", "least_", "limits", "most", "not_checked", "out"},
       limit_keys()},
      {"## Faults",
       {{"twin/mission/fault.cc"}},
       {"faults", "fouled_tether", "lost_gnss", "lost_link", "lost_thruster", "unknown"}},
      {"## Behaviour trees",
       {{"twin/mission/read_behaviour_tree.cc"}},
       {"action", "all", "condition", "kind", "one"}},
      {"## A person adrift",
       {{"twin/mission/read_lookout.cc", "read_surface_place("},
        {"twin/mission/read_lookout.cc", "PersonSearch read_person_search("}}},
      {"## Marine mammals",
       {{"twin/mission/read_lookout.cc", "read_surface_place("},
        {"twin/mission/read_lookout.cc", "MammalDuty read_mammal_duty("},
        {conduct_reader, "(void)read_seconds(", ";"}}},
      {"## Cleaning",
       {{"twin/surface/read_cleaning.cc"},
        {"twin/surface/marine_growth.cc"},
        {"twin/surface/cleaning_tool.cc"}},
       {"clockwise", "thickness"}},
      {"## Inspection",
       {{"twin/inspection/read_inspection.cc"},
        {"twin/inspection/defect/read_defect_plan.cc", "DefectPlan read_defect_plan("}}},
      {"### Clear water and air",
       {{"twin/inspection/instrument/clarity.cc"}},
       {"beam_attenuation", "diffuse_attenuation", "turbidity", "turbidity_fnu", "turbidity_ntu",
        "visibility", "_m", "_per_m"}},
      {"### Defects",
       {{"twin/inspection/defect/read_defect_plan.cc"},
        {defect_facts_reader, "severity_key_of("},
        {defect_facts_reader, "DefectKind read_defect_kind("}},
       {"defects"}},
      {"### Surfaces",
       {{surface_reader, "double read_z("},
        {surface_reader, "Triple<double> read_place("},
        {surface_reader, "SizeKeys<Sizes>::upright()"},
        {surface_reader, "SizeKeys<Sizes>::point("},
        {surface_reader, "Arc read_arc("},
        {surface_reader, "PlannedSurface read_entry("}},
       {"clockwise"}},
      {"#### monopile", {{surface_reader, "MonopileSizes read_sizes("}}},
      {"#### transition_piece", {{surface_reader, "TransitionPieceSizes read_sizes("}}},
      {"#### tower", {{surface_reader, "TowerSizes read_sizes("}}},
      {"#### nacelle", {{surface_reader, "NacelleSizes read_sizes("}}},
      {"#### blade", {{surface_reader, "BladeSizes read_sizes("}}},
      {"#### anodes", {{surface_reader, "AnodesSizes read_sizes("}}},
      {"#### mooring_line", {{surface_reader, "MooringLineSizes read_sizes("}}},
      {"#### cable", {{surface_reader, "CableSizes read_sizes("}}},
      {"#### bed",
       {{surface_reader, "BedSizes::Scour read_scour("}, {surface_reader, "BedSizes read_sizes("}}},
      {"#### water", {{surface_reader, "WaterSizes read_sizes("}}}};
  return all;
}

/// Readers in the same folders of what no scenario holds: missions, and the data that they name.
inline const Words of_no_scenario{"twin/scenario/expand_mission.cc",
                                  "twin/scenario/lay_out_agent.cc",
                                  "twin/scenario/lay_out_surface.cc",
                                  "twin/scenario/tenders.cc",
                                  "twin/mission/work_pattern.cc",
                                  "twin/mission/intensity.cc",
                                  "twin/mission/cable_of_site.cc",
                                  "twin/search/leeway.cc",
                                  "twin/search/search_lookout.cc",
                                  "twin/search/mammals.cc",
                                  "twin/search/mammal_watch.cc",
                                  "twin/inspection/instrument/read_instrument.cc",
                                  "twin/inspection/defect/read_detection_method.cc",
                                  defect_facts_reader};

inline std::string text_of(const Piece& piece) {
  const std::string whole = tests::text_of_source(piece.file);
  if (std::string_view(piece.begins).empty()) return whole;
  const std::size_t begin = whole.find(piece.begins);
  EXPECT_NE(begin, std::string::npos) << piece.begins << " is not in " << piece.file;
  if (begin == std::string::npos) return {};
  return whole.substr(begin, whole.find(piece.ends, begin) - begin);
}

/// Of a time KEY that may also be KEY_s.
inline Words times_read_in(const std::string& source) {
  static const std::regex time(R"re(_seconds\(\*?\w+,\s*"(\w+)")re");
  Words found;
  for (std::sregex_iterator at(source.begin(), source.end(), time), end; at != end; ++at)
    found.insert((*at)[1].str() + "_s");
  return found;
}

inline Words keys_asked_for(const PagePart& part) {
  Words asked;
  for (const Piece& piece : part.pieces) {
    const std::string source = text_of(piece);
    for (const std::string& word : tests::words_quoted_in(source))
      if (!part.no_keys.contains(word)) asked.insert(word);
    asked.merge(times_read_in(source));
  }
  asked.insert(part.made_keys.begin(), part.made_keys.end());
  return asked;
}

}  // namespace slackwater::twin::scenario_page
