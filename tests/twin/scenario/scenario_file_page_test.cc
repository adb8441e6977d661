#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "tests/support/contains.h"
#include "tests/support/page_keys.h"
#include "tests/support/page_ranges.h"
#include "tests/twin/scenario/scenario_page_parts.h"
#include "twin/inspection/surface/usual_sizes.h"
#include "twin/scenario/scenario.h"

// The page api/docs/scenario_file.md has the keys that the readers of a scenario ask for, each in
// the section of its reader, and no others; their ranges and defaults are those of the code; and
// its examples are scenarios.

namespace slackwater::twin::scenario_file_page_test {
namespace {

namespace fs = std::filesystem;

using namespace scenario_page;
using tests::in_one_but_not;
using tests::number_in;
using tests::ranges_told;
using tests::section_of;
using tests::text_of_source;
using tests::words_quoted_in;

/// Up to the next heading, whatever its level.
std::string own_text_of(const std::string& page, const std::string& heading) {
  const std::string section = section_of(page, heading);
  return section.substr(0, section.find("\n##", 1));
}

const std::string& page() {
  static const std::string text = text_of_source("api/docs/scenario_file.md");
  return text;
}

TEST(ScenarioFilePage, HasTheKeysThatTheReadersAskFor) {
  std::size_t count = 0;
  for (const PagePart& part : parts()) {
    const Words asked = keys_asked_for(part);
    const Words told = tests::keys_in_tables(own_text_of(page(), part.heading));
    EXPECT_EQ(in_one_but_not(asked, told), "") << "are not in a table of: " << part.heading;
    EXPECT_EQ(in_one_but_not(told, asked), "") << "nobody asks for, of: " << part.heading;
    count += told.size();
  }
  EXPECT_GT(count, 300U) << "the page was not read";
  EXPECT_TRUE(tests::contains(own_text_of(page(), "## Limits"), "`least_`"));
}

/// Else the keys of a new reader, or of a new function of one, would be missed.
TEST(ScenarioFilePage, EveryReaderHasASection) {
  Words known = of_no_scenario;
  for (const PagePart& part : parts())
    for (const Piece& piece : part.pieces) known.insert(piece.file);
  const std::regex asks(R"re((number|integer|texts?|children|child|flag)\(\s*"\w+")re");
  std::size_t count = 0;
  for (const char* folder :
       {"scenario", "mission", "clearance", "search", "surface", "traffic", "inspection"}) {
    const fs::path root = tests::source_folder();
    for (const auto& entry : fs::recursive_directory_iterator(root / "twin" / folder)) {
      const std::string file = fs::relative(entry.path(), root).generic_string();
      if (!file.ends_with(".cc") || !std::regex_search(text_of_source(file), asks)) continue;
      ++count;
      EXPECT_TRUE(known.contains(file)) << file << " reads keys, and the page has no section of it";
    }
  }
  EXPECT_GT(count, 20U) << "the sources were not found";
}

TEST(ScenarioFilePage, EveryFunctionOfAReaderHasASection) {
  for (const char* file :
       {reader, place_reader, task_reader, water_reader, traffic_reader, surface_reader,
        limit_reader, conduct_reader, "twin/mission/read_lookout.cc"}) {
    Words in_pieces;
    for (const PagePart& part : parts())
      for (const Piece& piece : part.pieces)
        if (std::string_view(piece.file) == file) in_pieces.merge(words_quoted_in(text_of(piece)));
    Words in_file = words_quoted_in(text_of_source(file));
    // Units and words for people of its table; checked by themselves.
    if (file == limit_reader)
      for (const LimitWord& word : limit_words())
        for (const char* told : {word.key, word.unit, word.meaning}) in_file.erase(told);
    EXPECT_EQ(in_one_but_not(in_file, in_pieces), "") << "are in no section's part of " << file;
  }
}

/// A row of a table: | key | unit | meaning | default | range |.
struct Row {
  std::vector<std::string> keys;
  std::string unit, otherwise, range;
};
std::vector<Row> rows_of(const std::string& heading) {
  std::vector<Row> rows;
  for (const std::string& line : tests::rows_of_keys(own_text_of(page(), heading))) {
    std::vector<std::string> cells;
    for (std::size_t at = 0; at + 1 < line.size();) {
      const std::size_t end = std::min(line.find('|', at + 1), line.size());
      cells.emplace_back(trimmed(line.substr(at + 1, end - at - 1)));
      at = end;
    }
    EXPECT_EQ(cells.size(), 5U) << heading << ": " << line;
    if (cells.size() == 5) rows.push_back({tests::keys_of_row(line), cells[1], cells[3], cells[4]});
  }
  return rows;
}

bool are_one(double code, double told) { return std::isnan(code) || code == told; }

TEST(ScenarioFilePage, HasTheRangesOfTheReaders) {
  static const std::regex asked(
      R"re((?:number|integer|numbers|rad|seconds|read_range)\((?:\*?\w+,\s*)?"(\w+)",)re"
      R"re(\s*(?:&\w+::\w+,\s*)?([^()]*)\))re");
  const std::string constants = text_of_source("twin/mission/reach.h");
  std::size_t count = 0;
  for (const PagePart& part : parts()) {
    const std::vector<Row> rows = rows_of(part.heading);
    for (const Piece& piece : part.pieces) {
      const std::string source = text_of(piece);
      const std::string around = text_of_source(piece.file) + source + constants;
      for (std::sregex_iterator at(source.begin(), source.end(), asked), end; at != end; ++at) {
        const std::string key = (*at)[1].str();
        const Range code = tests::range_passed((*at)[2].str(), around);
        if (std::isnan(code.low) && std::isnan(code.high)) continue;
        ++count;
        const bool is_told = std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
          const std::vector<Range> told = ranges_told(row.range);
          return std::find(row.keys.begin(), row.keys.end(), key) != row.keys.end() &&
                 std::any_of(told.begin(), told.end(), [&](const Range& range) {
                   return are_one(code.low, range.low) && are_one(code.high, range.high);
                 });
        });
        EXPECT_TRUE(is_told) << part.heading << ": " << key << " is " << code.low << " to "
                             << code.high << " in " << piece.file;
      }
    }
  }
  EXPECT_GT(count, 200U) << "the sources were not read";
  const std::vector<Row> limits = rows_of("## Limits");
  for (const LimitWord& word : limit_words()) {
    const auto row = std::find_if(limits.begin(), limits.end(), [&](const Row& r) {
      return r.keys == std::vector<std::string>{word.key};
    });
    ASSERT_NE(row, limits.end()) << word.key;
    EXPECT_EQ(ranges_told(row->range), std::vector<Range>{word.range}) << word.key;
    EXPECT_EQ(row->unit, std::string_view(word.unit) == "degrees C" ? "°C" : word.unit);
  }
}

/// The number that the page says a key has where it is left out.
double default_told(const std::string& heading, const std::string& key) {
  for (const Row& row : rows_of(heading)) {
    if (std::find(row.keys.begin(), row.keys.end(), key) == row.keys.end()) continue;
    const std::string first = row.otherwise.substr(0, row.otherwise.find(' '));
    if (const double value = number_in(first); !std::isnan(value)) return value;
  }
  ADD_FAILURE() << heading << ": " << key << " has no default that is a number";
  return constants::nan;
}

/// There 0 stands for nothing.
const Words none_by_default{"hold_bus_v", "depth_bound_m", "most_speed_m_s", "density_kg_m3"};

/// `optional_number("key", {0, 5}).value_or(2)`.
TEST(ScenarioFilePage, HasTheDefaultsThatReadersSpellOut) {
  static const std::regex spelled(
      R"re(optional_(?:number|integer)\("(\w+)",[^()]*\)\s*\.value_or\(([\d.]+)\))re");
  std::size_t count = 0;
  for (const PagePart& part : parts()) {
    for (const Piece& piece : part.pieces) {
      const std::string source = text_of(piece);
      for (std::sregex_iterator at(source.begin(), source.end(), spelled), end; at != end; ++at) {
        const std::string key = (*at)[1].str();
        if (none_by_default.contains(key)) continue;
        ++count;
        EXPECT_EQ(default_told(part.heading, key), number_in((*at)[2].str()))
            << part.heading << ": " << key;
      }
    }
  }
  EXPECT_GT(count, 15U) << "the sources were not read";
}

TEST(ScenarioFilePage, HasTheDefaultsOfTheValues) {
  const ScenarioTraffic traffic;
  const StandOff clear;
  const Conduct conduct;
  const CleaningPlan cleaning;
  const InspectionLine line;
  const struct {
    const char* heading;
    const char* key;
    double is;
  } all[]{{"## The scenario as a whole", "home_after", Scenario{}.home_after_s},
          {"## Waves", "components", static_cast<double>(ScenarioWaves{}.components)},
          {"## Waves", "spreading_s", WavePartition{}.spreading_s},
          {"### follow_track", "within_m", TrackToFollow{}.within_m},
          {"### Manoeuvres", "approach_s", ManoeuvreTask{}.approach_s},
          {"#### zig_zag", "executes", static_cast<double>(ManoeuvreTask{}.executes)},
          {"## Other vessels", "reach_km", AisLog{}.reach_m / 1000},
          {"## Other vessels", "cpa_m", traffic.alarm.distance_m},
          {"## Other vessels", "tcpa_min", traffic.alarm.time_s / 60},
          {"## Keeping clear", "craft_m", clear.craft_m},
          {"## Keeping clear", "structure_m", clear.structure_m},
          {"## Keeping clear", "tether_m", clear.tether_m},
          {"## Keeping clear", "vessel_m", clear.vessel_m},
          {"## Keeping clear", "vertical_m", clear.vertical_m},
          {"## Conduct", "tick_s", conduct.tick_s},
          {"## Conduct", "clear_m", conduct.clear_m},
          {"## Conduct", "share", conduct.reserve.share},
          {"## Conduct", "margin", conduct.reserve.margin},
          {"## Conduct", "resume_after", conduct.holding.resume_after_s},
          {"## Conduct", "overlap_m", conduct.holding.overlap_m},
          {"## Conduct", "wander_m", conduct.pilot.wander_m},
          {"## Conduct", "memory_s", conduct.pilot.memory_s},
          {"## Conduct", "haste", conduct.pilot.haste},
          {"## Conduct", "stand_off_m", conduct.envelope.stand_off_m},
          {"## A person adrift", "diffusivity_m2_s", PersonSearch{}.diffusivity_m2_s},
          {"## Cleaning", "cell_m", cleaning.cell_m},
          {"## Cleaning", "band_m", cleaning.band_m},
          {"## Cleaning", "clean_below_mm", cleaning.clean_below_mm},
          {"## Cleaning", "done_at", cleaning.done_at},
          {"## Cleaning", "up_to_height_m", -cleaning.growth.top_m},
          {"## Inspection", "seen_at", line.seen_at},
          {"## Inspection", "rays_per_look", static_cast<double>(Scenario{}.rays_per_look)},
          {"### Clear water and air", "daylight", Clarity{}.daylight},
          {"#### transition_piece", "fender_radius_m", usual::fender_radius_m},
          {"#### transition_piece", "flange_width_m", usual::flange_width_m},
          {"#### transition_piece", "flange_thickness_m", usual::flange_thickness_m},
          {"#### transition_piece", "bolts", usual::bolts},
          {"#### tower", "top_radius_m", usual::tower_top_share},
          {"#### nacelle", "length_m", usual::nacelle_length_m},
          {"#### nacelle", "width_m", usual::nacelle_width_m},
          {"#### nacelle", "tall_m", usual::nacelle_height_m},
          {"#### nacelle", "ahead_m", usual::nacelle_ahead_m},
          {"#### nacelle", "roof_rise_m", usual::nacelle_roof_rise_m},
          {"#### blade", "overhang_m", usual::overhang_m},
          {"#### blade", "root_m", usual::blade_root_m},
          {"#### blade", "chord_m", usual::blade_chord_m},
          {"#### blade", "tip_chord_m", usual::blade_tip_chord_m},
          {"#### blade", "root_thickness", usual::blade_root_thickness},
          {"#### blade", "tip_thickness", usual::blade_tip_thickness},
          {"#### blade", "twist_deg", usual::blade_twist_deg},
          {"#### blade", "camber", usual::blade_camber},
          {"#### anodes", "bars", usual::anode_bars},
          {"#### anodes", "rows", usual::anode_rows},
          {"#### anodes", "length_m", usual::anode_length_m},
          {"#### anodes", "width_m", usual::anode_width_m},
          {"#### anodes", "off_m", usual::anode_off_m},
          {"#### mooring_line", "radius_m", usual::chain_radius_m},
          {"#### cable", "burial_m", usual::burial_m},
          {"#### cable", "corridor_m", usual::corridor_m},
          {"#### cable", "radius_m", usual::cable_radius_m},
          {"#### bed", "outer_m", usual::bed_radii},
          {"#### bed", "slope_deg", usual::slope_deg}};
  for (const auto& [heading, key, is] : all)
    EXPECT_EQ(default_told(heading, key), is) << heading << ": " << key;
}

/// Lines of a block, moved to the right.
std::string indented(const std::string& block) {
  std::string lines = "    " + block;
  for (std::size_t at = lines.find('\n'); at + 1 < lines.size(); at = lines.find('\n', at + 1))
    lines.insert(at + 1, "    ");
  return lines;
}

/// An example that is not whole, in the smallest one: of its vehicle, or in the place of the same
/// key. Whoever does a task there may go aboard.
std::string whole_with(const std::string& block) {
  std::string whole = tests::yaml_block_of(page(), "name: The smallest");
  const std::string key = "\n" + block.substr(0, block.find(':') + 1);
  if (key == "\nname:") return block;
  if (key == "\nconduct:") return whole + indented(block);
  if (key == "\ntasks:")
    return whole + "    conduct: {}\n    carrier: {name: tender, forward_m: -4}\n" +
           indented(block);
  if (const std::size_t had = whole.find(key); had != std::string::npos) {
    const bool is_last = key == "\nvehicles:";
    whole.erase(had, is_last ? std::string::npos : whole.find('\n', had + 1) - had);
    if (is_last) whole += "\n";
  }
  return whole + block;
}

TEST(ScenarioFilePage, ItsExamplesAreScenarios) {
  std::size_t count = 0;
  for (const std::string& block : tests::yaml_blocks(page())) {
    SCOPED_TRACE(block);
    ++count;
    EXPECT_FALSE(parse_scenario(whole_with(block), "example.yaml").vehicles.empty());
  }
  EXPECT_GT(count, 20U) << "the page was not read";
}

TEST(ScenarioFilePage, ItsTimesAreTimes) {
  const std::string smallest = tests::yaml_block_of(page(), "name: The smallest");
  const std::string times = tests::after(page(), "**A time** is", '\n');
  std::size_t count = 0;
  for (std::string time : tests::between(times, '`')) {
    if (time.starts_with("KEY: ")) time.erase(0, 5);
    if (!time.ends_with('n') && !time.ends_with('h') && !time.ends_with('d')) continue;
    ++count;
    std::string yaml = smallest;
    yaml.replace(yaml.find("1min"), 4, time);
    EXPECT_GT(parse_scenario(yaml, "time.yaml").duration_s, 0) << time;
  }
  EXPECT_EQ(count, 4U) << times;
}

TEST(ScenarioFilePage, HasAnExampleOfEachTask) {
  const std::string read_task = text_of({task_reader, "ScenarioTask read_task("});
  static const std::regex kind(R"re(kind == "(\w+)")re");
  std::size_t count = 0;
  for (std::sregex_iterator at(read_task.begin(), read_task.end(), kind), end; at != end; ++at) {
    const std::string word = (*at)[1].str();
    ++count;
    EXPECT_TRUE(tests::contains(own_text_of(page(), "### " + word), "- {do: " + word));
  }
  EXPECT_GT(count, 8U) << "the reader was not found";
  for (const auto kind : {ManoeuvreKind::turning_circle, ManoeuvreKind::zig_zag,
                          ManoeuvreKind::spiral, ManoeuvreKind::pull_out, ManoeuvreKind::steps}) {
    const std::string word = name_of(kind);
    const std::string heading = (kind == ManoeuvreKind::steps ? "### " : "#### ") + word;
    EXPECT_TRUE(tests::contains(own_text_of(page(), heading), "- {do: " + word));
  }
}

TEST(ScenarioFilePage, AScenarioRefusesWhatOnlyAMissionHas) {
  const std::string section = section_of(page(), "## What only a mission has");
  const std::string smallest = tests::yaml_block_of(page(), "name: The smallest");
  std::size_t count = 0;
  for (std::size_t at = section.find("\n| `"); at != std::string::npos;
       at = section.find("\n| `", at + 1)) {
    const std::string key = tests::between(section.substr(at), '`').front();
    ++count;
    try {
      (void)parse_scenario(key + ": 1\n" + smallest, "mission.yaml");
      ADD_FAILURE() << key << " is not refused";
    } catch (const Error& problem) {
      EXPECT_TRUE(tests::contains(problem.message(), "mission.yaml:1"));
      EXPECT_TRUE(tests::contains(problem.message(), key));
    }
  }
  EXPECT_EQ(count, 5U);
}

TEST(ScenarioFilePage, RangesAreRead) {
  const std::string source =
      "constexpr double day_s = 24 * 3600.0;\nconstexpr Range reach{-1'000, 2 * day_s};\n";
  EXPECT_EQ(tests::range_passed("{0, 5e3}", source), (Range{0, 5000}));
  EXPECT_EQ(tests::range_passed("1, 30 * day_s", source), (Range{1, 30 * 86400}));
  EXPECT_EQ(tests::range_passed("reach", source), (Range{-1000, 2 * 86400}));
  EXPECT_TRUE(std::isnan(tests::range_passed("{0, 0.5 * wide_m}", source).high));
  EXPECT_EQ(ranges_told("0.05 … 200; of air 1 … 1e6"), (std::vector<Range>{{0.05, 200}, {1, 1e6}}));
  EXPECT_EQ(ranges_told("±360"), (std::vector<Range>{{-360, 360}}));
  EXPECT_TRUE(std::isnan(ranges_told("0 … half of the width").front().high));
  EXPECT_TRUE(ranges_told("100").empty());
}

}  // namespace
}  // namespace slackwater::twin::scenario_file_page_test
