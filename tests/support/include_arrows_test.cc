#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/support/shared_data.h"

// Who may include whom: fields -> nothing of ours; ingest, calibration, twin, data -> fields; api
// and tests -> all. Between the folders of a room no arrows lead round in a circle.

namespace slackwater::tests::include_arrows_test {
namespace {

using Arrows = std::map<std::string, std::set<std::string>>;

const std::set<std::string> rooms{"fields", "ingest", "calibration", "twin",
                                  "data",   "api",    "tests"};

const Arrows& allowed_arrows() {
  static const Arrows arrows{{"fields", {}},
                             {"ingest", {"fields"}},
                             {"calibration", {"fields"}},
                             {"twin", {"fields"}},
                             {"data", {"fields"}},
                             {"api", {"fields", "ingest", "calibration", "twin", "data"}},
                             {"tests", rooms}};
  return arrows;
}

/// The room an include line of ours points to, or nothing.
std::string room_of_include(const std::string& line) {
  if (!line.starts_with("#include \"")) return {};
  const std::string path = line.substr(10);
  const std::string room = path.substr(0, path.find('/'));
  return rooms.contains(room) ? room : std::string();
}

std::string forbidden_in(const std::string& room, const std::string& line) {
  const std::string target = room_of_include(line);
  if (target.empty() || target == room || allowed_arrows().at(room).contains(target)) return {};
  return room + " -> " + target + ": " + line;
}

template <typename Visit>
void for_each_line(const std::string& room, const Visit& visit) {
  const auto folder = source_folder() / room;
  if (!std::filesystem::is_directory(folder)) return;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const auto ending = entry.path().extension();
    if (ending != ".h" && ending != ".cc") continue;
    std::ifstream stream(entry.path());
    for (std::string line; std::getline(stream, line);) visit(entry.path(), line);
  }
}

TEST(IncludeArrows, NoRoomIncludesWhatItMayNot) {
  std::size_t lines = 0;
  for (const std::string& room : rooms) {
    for_each_line(room, [&](const std::filesystem::path& file, const std::string& line) {
      lines += room_of_include(line).empty() ? 0 : 1;
      EXPECT_EQ(forbidden_in(room, line), "") << file;
    });
  }
  EXPECT_GT(lines, 200U) << "the sources were not found";
}

TEST(IncludeArrows, AForbiddenArrowIsSeen) {
  EXPECT_NE(forbidden_in("fields", "#include \"ingest/ingest.h\""), "");
  EXPECT_NE(forbidden_in("ingest", "#include \"calibration/solve/calibration.h\""), "");
  EXPECT_NE(forbidden_in("data", "#include \"api/door/cli/command.h\""), "");
  EXPECT_EQ(forbidden_in("api", "#include \"data/store/store.h\""), "");
  EXPECT_EQ(forbidden_in("ingest", "#include <vector>"), "");
}

/// Within api: the other folders of it that a folder may include. The libraries of
/// api/CMakeLists.txt see the same.
const Arrows& allowed_arrows_of_api() {
  static const Arrows arrows{
      {"api/json", {}},
      {"api/program", {}},
      {"api/perception", {"api/program"}},
      {"api/issued", {}},
      {"api/pipeline", {"api/issued", "api/program"}},
      {"api/pipeline/ingest", {"api/program"}},
      {"api/pipeline/fetch", {}},
      {"api/log", {"api/json"}},
      {"api/ask/run", {"api/issued", "api/log", "api/pipeline", "api/program"}},
      {"api/ask/vehicle", {"api/ask/run"}},
      {"api/ask/render", {"api/ask/run", "api/log", "api/program"}},
      {"api/ask/detect", {"api/ask/render", "api/log", "api/perception"}},
      {"api/ask/rehearse", {"api/ask/run", "api/program"}},
      {"api/ask/windows", {"api/ask/rehearse", "api/pipeline", "api/program"}},
      {"api/ask/decisions",
       {"api/ask/rehearse", "api/ask/windows", "api/issued", "api/pipeline", "api/program"}},
      {"api/ask/plan", {"api/program"}},
      {"api/ask/traffic", {"api/ask/run"}},
      {"api/ask/history", {"api/pipeline", "api/pipeline/ingest", "api/program"}},
      {"api/ask/morning", {"api/ask/decisions", "api/ask/plan", "api/ask/windows", "api/program"}},
      {"api/show/report", {"api/json", "api/web/look"}},
      {"api/show/coverage", {"api/json", "api/show/report"}},
      {"api/show/rehearse",
       {"api/ask/rehearse", "api/json", "api/log", "api/program", "api/show/coverage",
        "api/show/report"}},
      {"api/show/vehicle", {"api/ask/vehicle", "api/json", "api/show/rehearse", "api/show/report"}},
      {"api/show/render", {"api/ask/render", "api/program"}},
      {"api/show/perception", {"api/perception"}},
      {"api/show/detect", {"api/ask/detect", "api/perception", "api/program", "api/show/report"}},
      {"api/show/people", {"api/log"}},
      {"api/show/windows", {"api/ask/windows", "api/show/rehearse"}},
      {"api/show/decisions", {"api/ask/decisions"}},
      {"api/show/plan", {"api/ask/plan"}},
      {"api/show/history", {"api/ask/history"}},
      {"api/show/traffic", {"api/ask/traffic"}},
      {"api/show/morning",
       {"api/ask/decisions", "api/ask/morning", "api/ask/plan", "api/ask/windows", "api/pipeline",
        "api/program", "api/show/decisions", "api/show/plan", "api/show/rehearse",
        "api/show/report", "api/show/windows"}},
      {"api/web", {}},
      {"api/web/look", {}},
      {"api/door/http", {}},
      {"api/door/foxglove", {"api/door/http"}},
      {"api/door/dds/message", {}},
      {"api/door/dds/intake", {}},
      {"api/door/dds", {"api/door/dds/intake", "api/door/dds/message"}},
      {"api/door/live",
       {"api/ask/run", "api/door/dds", "api/door/dds/message", "api/door/live/topics", "api/issued",
        "api/log"}},
      {"api/door/live/topics",
       {"api/ask/render", "api/ask/run", "api/door/dds", "api/door/dds/message",
        "api/door/foxglove", "api/perception"}},
      {"api/door/people/wire", {}},
      {"api/door/people",
       {"api/ask/run", "api/door/http", "api/door/live/topics", "api/door/people/wire", "api/log",
        "api/program", "api/web"}},
      {"api/door/people/playback",
       {"api/ask/run", "api/door/http", "api/door/people", "api/door/people/wire", "api/log"}},
      {"api/door/desk", {"api/ask/decisions", "api/ask/history",
                         "api/ask/morning",   "api/ask/plan",
                         "api/ask/rehearse",  "api/ask/traffic",
                         "api/ask/windows",   "api/door/edr/read",
                         "api/door/http",     "api/door/morning",
                         "api/issued",        "api/pipeline",
                         "api/program",       "api/show/decisions",
                         "api/show/history",  "api/show/morning",
                         "api/show/plan",     "api/show/rehearse",
                         "api/show/report",   "api/show/traffic",
                         "api/show/windows",  "api/web"}},
      {"api/door/sessions",
       {"api/ask/rehearse", "api/ask/run", "api/door/http", "api/door/people", "api/program"}},
      {"api/door/edr/read", {}},
      {"api/door/edr/sample", {"api/door/edr/read", "api/issued"}},
      {"api/door/edr/write",
       {"api/door/edr/sample", "api/door/edr/read", "api/issued", "api/program", "api/web/look"}},
      {"api/door/edr",
       {"api/door/edr/write", "api/door/edr/sample", "api/door/edr/read", "api/issued",
        "api/door/http"}},
      {"api/door/morning",
       {"api/ask/morning", "api/pipeline", "api/program", "api/show/morning", "api/show/report"}},
      {"api/made_up/synthetic", {}},
      {"api/made_up/demo",
       {"api/ask/morning", "api/made_up/synthetic", "api/pipeline", "api/pipeline/ingest",
        "api/program", "api/show/morning", "api/show/report"}},
      {"api/door/cli", {"api/ask/traffic", "api/ask/windows", "api/door/dds", "api/program"}},
      {"api/door/cli/decide",
       {"api/ask/decisions", "api/ask/morning", "api/ask/plan", "api/door/cli", "api/door/morning",
        "api/program", "api/show/decisions", "api/show/morning", "api/show/plan",
        "api/show/windows"}},
      {"api/door/cli/run",
       {"api/ask/rehearse", "api/ask/run", "api/door/cli", "api/door/cli/see", "api/door/foxglove",
        "api/door/http", "api/door/live", "api/door/live/topics", "api/door/people", "api/log",
        "api/show/coverage", "api/show/people", "api/show/rehearse"}},
      {"api/door/cli/sea",
       {"api/ask/history", "api/ask/morning", "api/door/cli", "api/door/morning", "api/issued",
        "api/pipeline", "api/pipeline/fetch", "api/pipeline/ingest", "api/program",
        "api/show/history", "api/show/morning", "api/show/report"}},
      {"api/door/cli/see",
       {"api/ask/detect", "api/ask/render", "api/door/cli", "api/door/live/topics",
        "api/perception", "api/program", "api/show/detect", "api/show/perception",
        "api/show/rehearse", "api/show/render", "api/show/report"}},
      {"api/door/cli/serve",
       {"api/door/cli", "api/door/desk", "api/door/edr", "api/door/http", "api/door/live",
        "api/door/people", "api/door/people/playback", "api/door/sessions", "api/issued",
        "api/program"}},
      {"api/door/cli/store",
       {"api/door/cli", "api/made_up/demo", "api/pipeline", "api/pipeline/ingest", "api/program",
        "api/show/morning", "api/show/report", "api/show/traffic"}},
      {"api/door/cli/vehicle",
       {"api/ask/vehicle", "api/door/cli", "api/program", "api/show/report", "api/show/vehicle"}}};
  return arrows;
}

/// The folder that an include line leads to, where it is another one of the same room.
std::string folder_of_include(const std::string& folder, const std::string& line) {
  const std::string room = folder.substr(0, folder.find('/'));
  if (room_of_include(line) != room) return {};
  const std::string path = line.substr(10, line.find('"', 10) - 10);
  const std::string target = path.substr(0, path.rfind('/'));
  return target == folder ? std::string() : target;
}

Arrows folder_arrows(const std::string& room) {
  Arrows arrows;
  for_each_line(room, [&](const std::filesystem::path& file, const std::string& line) {
    const auto path = std::filesystem::relative(file.parent_path(), source_folder());
    const std::string target = folder_of_include(path.string(), line);
    if (!target.empty()) arrows[path.string()].insert(target);
  });
  return arrows;
}

std::string forbidden_in_api(const std::string& folder, const std::set<std::string>& targets) {
  const auto known = allowed_arrows_of_api().find(folder);
  if (known == allowed_arrows_of_api().end()) return folder + " is not in the table of this test";
  for (const std::string& target : targets)
    if (!known->second.contains(target)) return folder + " -> " + target;
  return {};
}

TEST(IncludeArrows, NoFolderOfApiIncludesWhatItMayNot) {
  const Arrows found = folder_arrows("api");
  EXPECT_GT(found.size(), 5U) << "the sources were not found";
  for (const auto& [folder, targets] : found) EXPECT_EQ(forbidden_in_api(folder, targets), "");
}

/// How an answer is told, which a question does not know.
std::string way_of_telling_in(const std::string& line) {
  for (const char* way : {"<nlohmann/", "html", "printf", "<iostream>", "\"api/json/"})
    if (line.find(way) != std::string::npos) return way;
  return {};
}

TEST(IncludeArrows, QuestionsKnowNoWayOfTellingTheirAnswers) {
  std::size_t lines = 0;
  for_each_line("api/ask", [&](const std::filesystem::path& file, const std::string& line) {
    ++lines;
    EXPECT_EQ(way_of_telling_in(line), "") << file << ": " << line;
  });
  EXPECT_GT(lines, 3000U) << "the sources were not found";
  EXPECT_NE(way_of_telling_in("#include <nlohmann/json_fwd.hpp>"), "");
}

TEST(IncludeArrows, AForbiddenArrowWithinApiIsSeen) {
  EXPECT_NE(forbidden_in_api("api/door/http", {"api/program"}), "");
  EXPECT_NE(forbidden_in_api("api/door/edr/read", {"api/door/edr/sample"}), "");
  EXPECT_NE(forbidden_in_api("api/pipeline", {"api/show/report"}), "");
  EXPECT_NE(forbidden_in_api("api/ask/windows", {"api/show/windows"}), "");
  EXPECT_NE(forbidden_in_api("api/show/plan", {"api/door/cli"}), "");
  EXPECT_NE(forbidden_in_api("api/door/cli/sea", {"api/door/live"}), "");
  EXPECT_NE(forbidden_in_api("api/utils", {"api/door/cli"}), "");
  EXPECT_EQ(forbidden_in_api("api/door/edr/write", {"api/door/edr/sample"}), "");
}

/// The folders on a way that leads back to where it began, "a -> b -> a"; empty where there is
/// none.
std::string cycle_in(Arrows arrows) {
  // What leads nowhere is on no cycle; it goes, and with it the arrows that point to it.
  for (bool is_less = true; is_less;) {
    is_less = false;
    for (auto& [folder, targets] : arrows)
      is_less |= std::erase_if(targets, [&](const std::string& t) { return !arrows.contains(t); });
    is_less |= std::erase_if(arrows, [](const auto& entry) { return entry.second.empty(); });
  }
  if (arrows.empty()) return {};
  // Each folder that is left leads on to another: whoever walks comes past a place twice.
  std::vector<std::string> way{arrows.begin()->first};
  for (;;) {
    const std::string next = *arrows.at(way.back()).begin();
    const auto seen = std::find(way.begin(), way.end(), next);
    if (seen == way.end()) {
      way.push_back(next);
      continue;
    }
    std::string text;
    for (auto at = seen; at != way.end(); ++at) text += *at + " -> ";
    return text + next;
  }
}

TEST(IncludeArrows, NoFoldersOfARoomIncludeEachOtherInACircle) {
  std::size_t arrows = 0;
  for (const std::string& room : rooms) {
    if (room == "tests") continue;
    const Arrows found = folder_arrows(room);
    arrows += found.size();
    EXPECT_EQ(cycle_in(found), "") << room;
  }
  EXPECT_GT(arrows, 20U) << "the sources were not found";
}

TEST(IncludeArrows, ACircleOfFoldersIsSeen) {
  EXPECT_EQ(folder_of_include("twin/control", "#include \"twin/body/attitude.h\""), "twin/body");
  EXPECT_EQ(folder_of_include("twin/body", "#include \"twin/body/attitude.h\""), "");
  EXPECT_EQ(folder_of_include("twin/body", "#include \"fields/base/numbers/real.h\""), "");
  EXPECT_EQ(cycle_in({{"a", {"b", "c"}}, {"b", {"c"}}}), "");
  EXPECT_EQ(cycle_in({{"a", {"b"}}, {"b", {"a", "c"}}}), "a -> b -> a");
  EXPECT_EQ(cycle_in({{"a", {"b"}}, {"b", {"c"}}, {"c", {"d"}}, {"d", {"b"}}}), "b -> c -> d -> b");
  Arrows planted = folder_arrows("twin");
  planted["twin/body"].insert("twin/agent");
  EXPECT_NE(cycle_in(planted), "");
}

/// A header that shows a library to its own folder, and says so.
bool is_inner(const std::filesystem::path& file) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("//") && line.find("Only sources of this folder include") != line.npos)
      return true;
  return false;
}

TEST(IncludeArrows, InnerHeadersStayInTheirFolder) {
  std::size_t inner = 0;
  for (const std::string& room : rooms) {
    if (room == "tests") continue;
    for_each_line(room, [&](const std::filesystem::path& file, const std::string& line) {
      if (!line.starts_with("#include \"")) return;
      const auto included = source_folder() / line.substr(10, line.rfind('"') - 10);
      if (!is_inner(included)) return;
      ++inner;
      EXPECT_EQ(file.parent_path(), included.parent_path()) << file << ": " << line;
    });
  }
  EXPECT_GT(inner, 5U) << "the sources were not found";
}

// But fmt, with which every room writes its texts.
TEST(IncludeArrows, EachLibraryHasOneDoor) {
  const std::vector<std::pair<std::string, std::string>> doors{{"netcdf.h", "ingest/netcdf"},
                                                               {"ceres/", "calibration"},
                                                               {"sqlite3.h", "data/store"},
                                                               {"eccodes.h", "ingest/grib"},
                                                               {"udunits2.h", "ingest/cf"},
                                                               {"proj.h", "fields/geo"},
                                                               {"yaml-cpp/", "fields/base"},
                                                               {"nlohmann/", "api"},
                                                               {"CLI/", "api"},
                                                               {"openssl/", "fields/base"},
                                                               {"boost/", "api/door/http"},
                                                               {"zlib.h", "api/door/http"},
                                                               {"spdlog/", "fields/base"},
                                                               {"date/", "fields/base/local_time"},
                                                               {"seccomp.h", "fields/base/process"},
                                                               {"cereal/", "ingest/apart"},
                                                               {"coin/", "api/ask/plan"},
                                                               {"png.h", "api/show/render"},
                                                               {"turbojpeg.h", "api/perception"},
                                                               {"zstd.h", "data/bag"},
                                                               {"lz4frame.h", "data/bag"},
                                                               {"fastdds/", "api/door/dds"},
                                                               {"fastrtps/", "api/door/dds"},
                                                               {"fastcdr/", "api/door/dds/message"},
                                                               {"embree", "twin/inspection/cast/"},
                                                               {"opencv2/", "api/perception"},
                                                               // Kept for what is to come.
                                                               {"gdal", "api/publish"}};
  for (const std::string& room : rooms) {
    if (room == "tests") continue;
    for_each_line(room, [&](const std::filesystem::path& file, const std::string& line) {
      if (!line.starts_with("#include <")) return;
      const std::string where = std::filesystem::relative(file, source_folder()).string();
      for (const auto& [library, door] : doors) {
        if (line.substr(10).starts_with(library)) {
          // gpsdecode answers in JSON, and a forecast file holds some: second doors, not seen from
          // outside.
          // An MCAP has the sums of zlib in it; downloads of vessels' positions are packed too.
          const bool is_second_door =
              (library == "nlohmann/" && (where.starts_with("ingest/ais/") ||
                                          where == "ingest/cf/forecast/provenance_json.cc" ||
                                          where == "ingest/cf/forecast/averaged_json.cc")) ||
              (library == "zlib.h" && where == "data/bag/crc32.cc") ||
              (library == "png.h" && where == "api/perception/read_picture.cc") ||
              (library == "zstd.h" && where == "ingest/text/byte_source.cc");
          EXPECT_TRUE(where.starts_with(door) || is_second_door) << where << ": " << line;
          EXPECT_FALSE(where.ends_with(".h") && library != "nlohmann/" && !is_inner(file))
              << "a library in a header: " << where;
        }
      }
    });
  }
}

}  // namespace
}  // namespace slackwater::tests::include_arrows_test
