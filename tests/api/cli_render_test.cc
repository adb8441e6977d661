// `render`: what a camera saw on an inspection, as pictures and files with their truth; whole files
// or none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "ingest/netcdf/file.h"
#include "tests/support/contains.h"
#include "tests/support/farm_for_tests.h"

namespace slackwater::tests::cli_render_test {
namespace {

using nlohmann::json;

const std::string film = R"(id: film
name: Film a pile
)" + eye_yaml + R"(    conduct: {clear_m: 1}
    inspection:
      surfaces: [{kind: monopile, from: {depth_m: 4}, to: {depth_m: 14}}]
      looks:
        - {instrument: rov_camera, kinds: [monopile], detail_mm: 40, incidence_deg: 70,
           seen_at: 0.3}
      water: {visibility_m: 10}
      defects: [{kind: corrosion, count: 30, size_m: [0.3, 0.6]}]
      detection: [rgb_corrosion]
    work:
      - {pattern: rings, stand_off_m: 2, from: {depth_m: 9}, to: {depth_m: 9}, spacing_m: 1}
)";
const std::string mission =
    "name: film\nseed: 3\nsite: farm.yaml\ntasks: [film.yaml]\nturbines: [T1]\nstart: "
    "2025-03-10T11:00:00Z\nduration: 2min\nstep_s: 0.05\nwater: {made_up: {depth_m: 30, current: "
    "[{depth_m: 0, east_m_s: 0.05, north_m_s: 0}]}}\nwaves: {from: calm}\n";

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class RenderCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = std::make_unique<StoreForTests>();
    (void)made_->write("film.yaml", film);
    (void)made_->write("farm.yaml", farm_yaml());
    (void)made_->write("mission.yaml", mission);
    ASSERT_EQ(made_->run({"rehearse", path("mission.yaml"), "--scenario", path("laid_out.yaml")})
                  .exit_code,
              0);
    ASSERT_EQ(made_->run({"simulate", path("laid_out.yaml"), "--out", path("run.nc")}).exit_code,
              0);
  }
  static void TearDownTestSuite() { made_.reset(); }
  static std::string path(const std::string& name) { return made_->path(name); }

  static inline std::unique_ptr<StoreForTests> made_;
};

TEST_F(RenderCommand, LeavesPicturesWithTheirTruth) {
  const ProgramResult run =
      made_->run({"render", path("run.nc"), "--sensor", "rov_camera", "--every", "30s", "--threads",
                  "2", "--out", path("seen"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json frames = json::parse(run.out).at("frames");
  ASSERT_GE(frames.size(), 3U);
  std::size_t of_pile = 0;
  for (const json& frame : frames) {
    const std::filesystem::path png = path("seen/") + frame.at("png").get<std::string>();
    EXPECT_EQ(bytes_of(png).substr(1, 3), "PNG");
    const auto file =
        ingest::netcdf::File::open(path("seen/") + frame.at("netcdf").get<std::string>());
    const auto depth = file.read_all(*file.find("depth"));
    const auto kind = file.read_all(*file.find("seen_class"));
    const auto defect = file.read_all(*file.find("defect"));
    ASSERT_EQ(depth.size(), 640U * 360);
    std::size_t pile = 0;
    std::map<std::size_t, std::size_t> marked;
    for (std::size_t i = 0; i < depth.size(); ++i) {
      pile += kind[i] == 1 ? 1 : 0;
      if (kind[i] == 1) {
        EXPECT_GT(depth[i], 0);
      }
      if (defect[i] > 0) ++marked[static_cast<std::size_t>(defect[i])];
    }
    of_pile += pile;
    EXPECT_EQ(frame.at("pixels").value("monopile", std::size_t{0}), pile);
    EXPECT_EQ(frame.at("defects").size(), marked.size());
    const auto planted = file.read_all(*file.find("planted_pixels"));
    EXPECT_EQ(planted.size(), 30U);
    for (const auto& [number, pixels] : marked)
      EXPECT_EQ(planted[number - 1], static_cast<double>(pixels));
    std::size_t named = 0;
    for (const auto& attribute : file.attributes()) named += attribute.name == "camera_matrix";
    EXPECT_EQ(named, 1U);
  }
  EXPECT_GT(of_pile, 100000U);
}

/// Run lengths down the columns, zeros first, as a mask row by row.
std::vector<bool> mask_of(const json& segmentation) {
  const auto high = segmentation.at("size")[0].get<std::size_t>();
  const auto wide = segmentation.at("size")[1].get<std::size_t>();
  std::vector<bool> mask(high * wide);
  std::size_t place = 0;
  bool is_in = false;
  for (const std::size_t run : segmentation.at("counts")) {
    for (std::size_t i = 0; i < run; ++i, ++place)
      mask.at(place % high * wide + place / high) = is_in;
    is_in = !is_in;
  }
  EXPECT_EQ(place, mask.size());
  return mask;
}

/// A sensor that a run is asked for sees what is seen of its log later.
TEST_F(RenderCommand, SimulateLeavesWhatItsSensorsSaw) {
  const ProgramResult later = made_->run({"render", path("run.nc"), "--sensor", "rov_camera",
                                          "--at", "50s", "--out", path("later"), "--json"});
  ASSERT_EQ(later.exit_code, 0) << later.err;
  const std::string vehicle = json::parse(later.out).at("vehicle");
  const auto seeing = [&](const std::string& see, const std::string& by = "corrosion_by_colour") {
    return made_->run({"simulate", path("laid_out.yaml"), "--out", path("seeing.nc"), "--see", see,
                       "--by", by, "--html", path("seeing.html"), "--json"});
  };
  const ProgramResult run = seeing(vehicle + "/rov_camera@0.02");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json seen = json::parse(run.out).at("seen");
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_GE(seen[0].at("frames").size(), 2U);
  const std::string name = "rov_camera_000050.000";
  EXPECT_EQ(bytes_of(path("seeing-" + vehicle + "-rov_camera/" + name + ".png")),
            bytes_of(path("later/" + name + ".png")));
  // What a detector found there is told by the log from then on, and the run is the same.
  const json& detected = seen[0].at("detected");
  const ProgramResult score = made_->run({"score", path("seeing.nc"), "--json"});
  ASSERT_EQ(score.exit_code, 0) << score.err;
  const json card = json::parse(score.out).at("runs")[0].at("vehicles")[0];
  EXPECT_EQ(card.at("detectors"), json::array({{{"sensor", "rov_camera"},
                                                {"detector", "corrosion_by_colour"},
                                                {"pictures", seen[0].at("frames").size()},
                                                {"kinds", detected.at("kinds")}}}));
  EXPECT_TRUE(contains(made_->run({"score", path("seeing.nc")}).out,
                       vehicle + ": corrosion_by_colour in "));
  const std::string page = bytes_of(path("seeing.html"));
  EXPECT_TRUE(contains(page, "What detectors found in its pictures"));
  EXPECT_FALSE(contains(page, "False alarms</th>")) << "that is truth";
  const ProgramResult replayed = made_->run({"replay", path("seeing.nc")});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
  EXPECT_TRUE(contains(seeing("nobody/rov_camera@1").err, "found no vehicle nobody"));
  EXPECT_TRUE(contains(seeing(vehicle + "/imaging_sonar@1").err, "--by: looks at what a camera"));
  EXPECT_TRUE(contains(seeing(vehicle + "/rov_camera@1", "no_detector").err, "no_detector"));
  EXPECT_TRUE(contains(seeing(vehicle + "/no_eye@1").err, "rov_camera"));
  const ProgramResult without =
      made_->run({"simulate", path("laid_out.yaml"), "--see", vehicle + "/rov_camera@0.02"});
  EXPECT_TRUE(contains(without.err, "--out")) << without.err;
}

TEST_F(RenderCommand, LabelsWhatWasPlantedAsDetectReadsIt) {
  const ProgramResult run = made_->run({"render", path("run.nc"), "--sensor", "rov_camera",
                                        "--every", "40s", "--out", path("labelled")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json labels = json::parse(bytes_of(path("labelled/rov_camera_labels.json")));
  std::size_t labelled = 0;
  for (const json& label : labels.at("annotations")) {
    const json& image = labels.at("images").at(label.at("image_id").get<std::size_t>() - 1);
    const std::string png = image.at("file_name");
    const auto file =
        ingest::netcdf::File::open(path("labelled/") + png.substr(0, png.size() - 4) + ".nc");
    const auto defect = file.read_all(*file.find("defect"));
    const auto planted = file.read_all(*file.find("planted_number"));
    const std::vector<bool> mask = mask_of(label.at("segmentation"));
    const auto wide = image.at("width").get<std::size_t>();
    std::size_t left = wide, top = defect.size(), right = 0, bottom = 0, pixels = 0;
    for (std::size_t i = 0; i < defect.size(); ++i) {
      const bool is_of_it = defect[i] > 0 && planted.at(static_cast<std::size_t>(defect[i]) - 1) ==
                                                 label.at("planted_number").get<double>();
      ASSERT_EQ(mask[i], is_of_it) << i;
      if (!is_of_it) continue;
      ++pixels;
      left = std::min(left, i % wide);
      right = std::max(right, i % wide + 1);
      top = std::min(top, i / wide);
      bottom = std::max(bottom, i / wide + 1);
    }
    EXPECT_EQ(label.at("bbox"), json({left, top, right - left, bottom - top}));
    EXPECT_EQ(label.at("area"), pixels);
    EXPECT_EQ(label.at("iscrowd"), pixels < 25 ? 1 : 0);
    labelled += pixels;
  }
  EXPECT_GT(labelled, 100U) << "nothing planted is in view";
  const ProgramResult score =
      made_->run({"detect", "--score", path("labelled"), "--by", "corrosion_by_colour", "--json"});
  ASSERT_EQ(score.exit_code, 0) << score.err;
  EXPECT_EQ(json::parse(score.out).at("pictures"), labels.at("images").size());
}

std::size_t times_in(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++times;
  return times;
}

TEST_F(RenderCommand, TellsWhatADetectorFindsOnTheRun) {
  const ProgramResult run =
      made_->run({"render", path("run.nc"), "--sensor", "rov_camera", "--every", "20s", "--out",
                  path("looked_at"), "--by", "corrosion_by_colour", "--html", path("seen.html"),
                  "--findings", path("found.geojson"), "--truth", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json told = json::parse(run.out);
  const json& detected = told.at("detected");
  EXPECT_EQ(detected.at("by"), "corrosion_by_colour");
  const json& rust = detected.at("kinds")[0];
  EXPECT_EQ(rust.at("of"), "corrosion");
  std::set<json> in_view;
  for (const json& frame : told.at("frames"))
    for (const json& defect : frame.at("defects"))
      if (defect.at("pixels") >= 25) in_view.insert(defect.at("number"));
  EXPECT_EQ(rust.at("in_view"), in_view.size());
  EXPECT_GT(in_view.size(), 0U);
  EXPECT_LE(rust.at("found"), rust.at("in_view"));
  std::size_t false_alarms = 0;
  for (const json& one : detected.at("findings")) {
    false_alarms += one.at("defect").is_null() ? 1 : 0;
    EXPECT_TRUE(contains(one.at("surface").get<std::string>(), "T1")) << one;
    EXPECT_LT(one.at("position_enu_m")[2], -3) << one;
  }
  EXPECT_EQ(rust.at("false_alarms"), false_alarms);
  const json map = json::parse(bytes_of(path("found.geojson")));
  ASSERT_EQ(map.at("features").size(), detected.at("findings").size());
  std::size_t said_false = 0;
  for (const json& feature : map.at("features"))
    said_false += feature.at("properties").at("truth") == "false alarm" ? 1 : 0;
  EXPECT_EQ(said_false, false_alarms);
  const std::string page = bytes_of(path("seen.html"));
  EXPECT_EQ(times_in(page, "<figure>"), told.at("frames").size());
  EXPECT_EQ(times_in(page, "data:image/jpeg;base64,/9j/"), told.at("frames").size());
  std::size_t shown = 0;
  for (const json& frame : told.at("frames")) shown += frame.at("defects").size();
  EXPECT_EQ(times_in(page, "class=\"truth\""), shown);
}

TEST_F(RenderCommand, TheSameMomentIsTheSameBytes) {
  const auto seen = [](const std::string& folder, const std::string& threads) {
    const ProgramResult run =
        made_->run({"render", path("run.nc"), "--sensor", "imaging_sonar", "--at", "40s", "--out",
                    path(folder), "--threads", threads});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const std::string name = path(folder) + "/imaging_sonar_000040.000";
    return bytes_of(name + ".png") + bytes_of(name + ".nc");
  };
  const std::string one = seen("one", "1");
  EXPECT_GT(one.size(), 1000U);
  EXPECT_EQ(one, seen("two", "2"));
}

/// Wide and high of a PNG, by its header.
std::pair<std::size_t, std::size_t> size_of_png(const std::string& file) {
  const std::string bytes = bytes_of(file);
  const auto number = [&](std::size_t from) {
    std::size_t value = 0;
    for (std::size_t i = from; i < from + 4; ++i)
      value = 256 * value + static_cast<unsigned char>(bytes.at(i));
    return value;
  };
  return {number(16), number(20)};
}

// What tells a line at a time leaves one picture of all its pings, and no picture of each.
TEST_F(RenderCommand, LeavesAWaterfallOfPings) {
  struct Kind {
    std::string sensor, variable;
    std::size_t values_wide, values_high;  // 0: as many as pings
  };
  for (const Kind& kind :
       {Kind{"side_scan", "mean_intensity", 2048, 0}, Kind{"multibeam", "true_depth", 512, 0},
        Kind{"echo_sounder", "intensity", 0, 1000}, Kind{"adcp", "eastward_velocity", 0, 40}}) {
    const auto seen = [&](const std::string& threads) {
      const ProgramResult run =
          made_->run({"render", path("run.nc"), "--sensor", kind.sensor, "--every", "30s", "--out",
                      path(kind.sensor + threads), "--threads", threads, "--json"});
      EXPECT_EQ(run.exit_code, 0) << run.err;
      return json::parse(run.out);
    };
    const json told = seen("1");
    const json& frames = told.at("frames");
    ASSERT_GE(frames.size(), 4U);
    EXPECT_EQ(told.at("waterfall"), kind.sensor + "_waterfall.png");
    const std::string folder = path(kind.sensor + "1") + "/";
    const auto [wide, high] = size_of_png(folder + kind.sensor + "_waterfall.png");
    EXPECT_EQ(wide, kind.values_wide > 0 ? kind.values_wide : frames.size());
    EXPECT_EQ(high, kind.values_high > 0 ? kind.values_high : frames.size());
    for (const json& frame : frames) {
      EXPECT_FALSE(frame.contains("png"));
      const auto file = ingest::netcdf::File::open(folder + frame.at("netcdf").get<std::string>());
      ASSERT_NE(file.find(kind.variable), nullptr);
      const auto values = file.read_all(*file.find(kind.variable));
      EXPECT_GT(std::count_if(values.begin(), values.end(),
                              [](double value) { return std::isfinite(value) && value != 0; }),
                10)
          << kind.sensor;
    }
    (void)seen("2");
    const std::string other = path(kind.sensor + "2") + "/";
    for (const json& frame : frames) {
      const std::string name = frame.at("netcdf");
      EXPECT_EQ(bytes_of(folder + name), bytes_of(other + name)) << name;
    }
    EXPECT_EQ(bytes_of(folder + kind.sensor + "_waterfall.png"),
              bytes_of(other + kind.sensor + "_waterfall.png"));
  }
}

TEST_F(RenderCommand, SaysWhatIsWrongInOneLine) {
  const auto said = [](std::vector<std::string> more) {
    std::vector<std::string> arguments{"render", path("run.nc"), "--out", path("none")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramResult run = made_->run(arguments);
    EXPECT_NE(run.exit_code, 0);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    return run.err;
  };
  EXPECT_TRUE(contains(said({"--sensor", "rov_camera"}), "say when"));
  EXPECT_TRUE(
      contains(said({"--sensor", "rov_camera", "--at", "3h"}), "expected a time of the run"));
  EXPECT_TRUE(contains(said({"--sensor", "uav_camera", "--at", "3s"}), "--vehicle"));
  EXPECT_TRUE(
      contains(said({"--sensor", "rov_camera", "--at", "3s", "--water", "mud"}), "coastal_3"));
  EXPECT_TRUE(contains(said({"--sensor", "rov_camera", "--at", "3s", "--html", path("a.html")}),
                       "name one with --by"));
  EXPECT_TRUE(contains(said({"--sensor", "rov_camera", "--at", "3s", "--by", "corrosion_by_colour",
                             "--findings", path("a.txt")}),
                       ".geojson"));
  EXPECT_TRUE(contains(
      said({"--sensor", "imaging_sonar", "--at", "3s", "--by", "corrosion_by_colour"}), "camera"));
  EXPECT_TRUE(contains(said({"--sensor", "rov_camera", "--at", "3s", "--by", "nobody"}),
                       "corrosion_by_colour"));
  // A disk that takes nothing: no half of a file is left.
  std::filesystem::create_directories(path("full/rov_camera_000003.000.nc/in_the_way"));
  const ProgramResult full = made_->run(
      {"render", path("run.nc"), "--sensor", "rov_camera", "--at", "3s", "--out", path("full")});
  EXPECT_EQ(full.exit_code, 5) << full.err;
  EXPECT_FALSE(std::filesystem::exists(path("full/rov_camera_000003.000.nc.partial")));
  EXPECT_FALSE(std::filesystem::exists(path("full/rov_camera_000003.000.png")));
}

}  // namespace
}  // namespace slackwater::tests::cli_render_test
