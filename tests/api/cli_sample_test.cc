// `slackwater sample`: every number in the file is the sampler's own, a place without one is filled
// and says why, and a question that cannot be answered leaves no file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "data/store/store.h"
#include "fields/base/encode/csv.h"
#include "fields/service/field.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "ingest/cf/forecast/provenance_json.h"
#include "ingest/netcdf/file.h"
#include "tests/support/made_up_forecast.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_sample_test {
namespace {

using ingest::netcdf::File;
using nlohmann::json;

constexpr float fill = 9.9692099683868690e+36F;

class Sample : public ::testing::Test {
 protected:
  void SetUp() override {
    snapshot_ = std::make_shared<const Snapshot>(publish(1));
    write_bytes(store_.file("made_up.yaml"),
                "id: made_up\nname: Made-up site\nlatitude_deg: 48.85\nlongitude_deg: -2.55\n");
    write_bytes(points(), "name,lat,lon\na,48.851,-2.55\nb,48.868,-2.549\nc,48.85,-2.0\n");
  }
  Snapshot publish(std::uint64_t seed) const {
    store::Store store = store::Store::open(store_.store(), store::OpenMode::create_or_write);
    Snapshot made = made_up_forecast({.columns = 4, .members = 3, .seed = seed});
    made.issued += std::chrono::hours(seed);
    const std::filesystem::path content = store.staging_folder() / "made_up.nc";
    ingest::write_forecast(content, made);
    Snapshot read = ingest::read_forecast(content);  // members as rounded
    store::ForecastRow row;
    row.site_id = made.site_id;
    row.day = made.day;
    row.issued = made.issued;
    row.valid_from = made.time.front();
    row.valid_to = made.time.back();
    row.wind_policy = made.wind_policy.value();
    row.summary_json = "{}";
    row.code_version = "test";
    store.commit_forecast(row, content);
    return read;
  }
  [[nodiscard]] std::filesystem::path points() const { return store_.file("points.csv"); }
  [[nodiscard]] std::filesystem::path out(const std::string& name = "out.nc") const {
    return store_.file(name);
  }
  /// With the options that must be there, unless `more` gives them.
  [[nodiscard]] ProgramResult sample(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"sample"};
    const auto add = [&](const std::string& option, const std::string& value) {
      if (std::find(more.begin(), more.end(), option) != more.end()) return;
      arguments.insert(arguments.end(), {option, value});
    };
    add("--site", store_.file("made_up.yaml").string());
    add("--points", points().string());
    add("--out", out().string());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return store_.run(arguments);
  }

  StoreForTests store_;
  std::shared_ptr<const Snapshot> snapshot_;
};

/// Every place of a file beside the sampler, to the bit: values, statuses, and what stands where
/// there is no value.
void expect_the_samplers_own(const File& file, const Field& field, std::size_t member,
                             const std::string& suffix) {
  const auto all = [&](const std::string& name) { return file.read_all(*file.find(name)); };
  const auto lat = all("latitude");
  const auto lon = all("longitude");
  const auto time = all("time");
  const auto depth = all("depth");
  const auto east = all("eastward_sea_water_velocity" + suffix);
  const auto north = all("northward_sea_water_velocity" + suffix);
  const auto status = all("sea_water_velocity_status");
  const std::size_t block = lat.size() * time.size() * depth.size();
  ASSERT_EQ(status.size(), block);
  std::vector<CurrentSample> expected(depth.size());
  std::size_t o = 0;
  std::size_t wrong = 0;
  for (std::size_t p = 0; p < lat.size(); ++p) {
    for (const double seconds : time) {
      const UtcTime when{Duration(static_cast<Duration::rep>(std::llround(seconds * 1000)))};
      field.sample_profile(lon[p], lat[p], when, depth, expected, member);
      for (const CurrentSample& sample : expected) {
        const std::size_t i = o + (member > 0 ? (member - 1) * block : 0);
        const bool is_there = has_value(sample.status);
        const auto u = static_cast<float>(sample.velocity_m_s.real());
        const auto v = static_cast<float>(sample.velocity_m_s.imag());
        wrong += static_cast<float>(east[i]) != (is_there ? u : fill);
        wrong += static_cast<float>(north[i]) != (is_there ? v : fill);
        if (member == 0) wrong += status[o] != static_cast<double>(sample.status);
        ++o;
      }
    }
  }
  EXPECT_EQ(wrong, 0U) << "of " << block << " places, member " << member;
}

TEST_F(Sample, EveryNumberOfTheFileIsTheSamplersOwnAndNoneIsNaN) {
  const ProgramResult result =
      sample({"--from", "2025-03-09T23:30:00Z", "--to", "2025-03-10T06:00:00Z", "--step", "30min",
              "--depths", "0/60/25", "--members"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const File file = File::open(out());
  EXPECT_EQ(file.text("featureType"), "timeSeriesProfile");
  EXPECT_EQ(file.text("slackwater_provenance"), ingest::provenance_json(snapshot_->provenance));
  EXPECT_EQ(file.find("time")->size(), 14U);
  const Field field(snapshot_);
  expect_the_samplers_own(file, field, 0, "");
  expect_the_samplers_own(file, field, 1, "_member");
  expect_the_samplers_own(file, field, 2, "_member");
  std::set<double> statuses;
  for (const double s : file.read_all(*file.find("sea_water_velocity_status"))) statuses.insert(s);
  EXPECT_EQ(statuses, (std::set<double>{0, 3, 4, 5})) << "ok, below bed, outside area, time";
}

TEST_F(Sample, MorePlacesThanOneBlockHoldsAreTheSamplersOwnToo) {
  std::ostringstream text;
  text << "latitude_deg,longitude_deg\n";
  for (int p = 0; p < 80; ++p) text << 48.85 + 0.0003 * p << ",-2.55\r\n";
  write_bytes(points(), text.str());
  ASSERT_EQ(sample({"--depths", "0/43/60"}).exit_code, 0);  // 80 x 73 x 60: two blocks
  expect_the_samplers_own(File::open(out()), Field(snapshot_), 0, "");
}

TEST_F(Sample, WithoutMoreWordsItIsTheForecastsOwnTimesAndLevels) {
  const ProgramResult result = sample({"--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json answer = json::parse(result.out);
  EXPECT_EQ(answer["times"], snapshot_->time.size());
  EXPECT_EQ(answer["depth_m"].get<std::vector<double>>(), snapshot_->depth_m);
  EXPECT_EQ(answer["members"], 1);
  EXPECT_EQ(answer["attributions"][0], "made up for tests");
  const std::size_t per_point = snapshot_->time.size() * snapshot_->depth_m.size();
  EXPECT_EQ(answer["status"]["outside_area"], per_point) << "the third point";
  EXPECT_EQ(
      answer["status"]["ok"].get<std::size_t>() + answer["status"]["below_bed"].get<std::size_t>(),
      2 * per_point);
}

TEST_F(Sample, CsvSaysTheSameInRows) {
  const std::vector<std::string> asked{"--to", "2025-03-10T01:00:00Z", "--depths", "5,60"};
  std::vector<std::string> csv = asked;
  csv.insert(csv.end(), {"--out", out("out.csv").string()});
  ASSERT_EQ(sample(asked).exit_code, 0);
  ASSERT_EQ(sample(csv).exit_code, 0);
  const File file = File::open(out());
  const auto east = file.read_all(*file.find("eastward_sea_water_velocity"));
  std::ifstream in(out("out.csv"));
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line,
            "point,longitude_deg,latitude_deg,time,depth_m,member,east_m_s,north_m_s,status,name");
  std::size_t rows = 0;
  for (; std::getline(in, line); ++rows) {
    std::vector<std::string> cells;
    std::istringstream words(line);
    for (std::string cell; std::getline(words, cell, ',');) cells.push_back(cell);
    ASSERT_EQ(cells.size(), 10U) << line;
    EXPECT_EQ(cells[9], std::string(1, "abc"[std::stoul(cells[0]) - 1])) << line;
    EXPECT_EQ(cells[6].empty(), cells[8] != "ok") << line;
    if (cells[8] == "ok") {
      EXPECT_NEAR(std::stod(cells[6]), east[rows], 0.51e-4) << line;
    }
  }
  EXPECT_EQ(rows, east.size());
}

/// The points file says "WTG 7"; both outputs forgot it and said "2".
TEST_F(Sample, ThePointsKeepTheirNamesInBothKindsOfFile) {
  write_bytes(points(),
              "station,lat,lon,name\r\n9,48.851,-2.55,\"cable, north\"\r\n8,48.868,-2.549,WTG 7\r\n"
              "7,48.85,-2.55\r\n");
  ASSERT_EQ(sample().exit_code, 0);
  const File file = File::open(out());
  const auto* variable = file.find("point_name");
  ASSERT_NE(variable, nullptr);
  ASSERT_EQ(variable->shape, (std::vector<std::size_t>{3, 12}));
  EXPECT_EQ(file.read_text(*variable).substr(0, 12), "cable, north");
  EXPECT_EQ(file.read_text(*variable).substr(12, 5), "WTG 7");
  EXPECT_TRUE(
      file.find("eastward_sea_water_velocity")->text("coordinates")->ends_with("point_name"));

  ASSERT_EQ(sample({"--out", out("out.csv").string()}).exit_code, 0);
  std::ifstream in(out("out.csv"));
  std::set<std::string> ends;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    const auto cells = csv_cells(line);
    ASSERT_TRUE(cells && cells->size() == 10U) << line;
    ends.insert(cells->front() + " " + cells->back());
  }
  EXPECT_EQ(ends, (std::set<std::string>{"1 cable, north", "2 WTG 7", "3 "}));
}

TEST_F(Sample, WithoutNamesThereAreNoNames) {
  write_bytes(points(), "lat,lon\n48.851,-2.55\n");
  ASSERT_EQ(sample().exit_code, 0);
  EXPECT_EQ(File::open(out()).find("point_name"), nullptr);
}

TEST_F(Sample, TheFileOfPointsIsNotWrittenOver) {
  const ProgramResult result = sample({"--out", points().string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("which is the file of points"), std::string::npos) << result.err;
}

TEST_F(Sample, AnInstanceIsTheForecastOfThatIdAndNewestTheLastIssued) {
  const Snapshot later = publish(2);
  const auto issued = [&](const std::string& instance) {
    const ProgramResult result = sample({"--json", "--instance", instance});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::parse(result.out)["issued"].get<std::string>();
  };
  EXPECT_EQ(issued("newest"), format_utc(later.issued));
  EXPECT_EQ(issued("1"), format_utc(snapshot_->issued));
  EXPECT_EQ(issued("2"), format_utc(later.issued));
}

TEST_F(Sample, WhatCannotBeAnsweredSaysWhyAndLeavesNoFile) {
  struct Case {
    std::vector<std::string> arguments;
    int exit_code;
    std::string word;
  };
  const auto file = [&](const std::string& name, const std::string& text) {
    write_bytes(store_.file(name), text);
    return store_.file(name).string();
  };
  const std::vector<Case> cases{
      {{"--step", "0h"}, 2, "--step"},
      {{"--step", "often"}, 2, "--step"},
      {{"--step", "1"}, 2, "--step"},
      {{"--from", "today"}, 2, "--from"},
      {{"--to", "2025-03-10"}, 2, "--to"},
      {{"--from", "2025-03-11T00:00:00Z", "--to", "2025-03-10T00:00:00Z"}, 2, "after --to"},
      {{"--from", "1800-01-01T00:00:00Z", "--to", "2200-01-01T00:00:00Z", "--step", "1h",
        "--depths", "0/80/5000"},
       2,
       "values, expected at most"},
      {{"--depths", "deep"}, 2, "from/to/count"},
      {{"--depths", "5,5"}, 2, "rising order"},
      {{"--depths", "-1,5"}, 2, "rising order"},
      {{"--depths", "0/80/1"}, 2, "from/to/count"},
      {{"--depths", "0/80/1e9"}, 2, "from/to/count"},
      {{"--depths", "nan"}, 2, "--depths"},
      {{"--out", out("out.txt").string()}, 2, ".nc or .csv"},
      {{"--out", (store_.file("no") / "out.nc").string()}, 2, "found no folder"},
      {{"--instance", "today"}, 2, "newest or the id"},
      {{"--instance", "99"}, 4, "its newest is 1"},
      {{"--site", "nowhere"}, 4, "nowhere"},
      {{"--points", store_.file("none.csv").string()}, 4, "No such file"},
      {{"--points", store_.file("").string()}, 3, "found the folder"},
      {{"--points", file("empty.csv", "")}, 3, "latitude_deg"},
      {{"--points", file("bare.csv", "48.85,-2.55\n")}, 3, "line 1"},
      {{"--points", file("head.csv", "lat,lon\n\n")}, 3, "no points"},
      {{"--points", file("word.csv", "lat,lon\n48.85,-2.55\n48.85,west\n")},
       3,
       "line 3: found 'west'"},
      {{"--points", file("quote.csv", "lat,lon,name\n48,2,\"a\n")},
       3,
       "a quote that is not closed"},
      {{"--points", file("short.csv", "lat,lon\n48.85\n")}, 3, "line 2"},
      {{"--points", file("nan.csv", "lat,lon\nnan,2\n")}, 3, "line 2"},
      {{"--points", file("pole.csv", "lat,lon\n97,2\n")}, 3, "line 2"},
      {{"--points", file("turns.csv", "lat,lon\n48,1e9\n")}, 3, "-360 to 360"},
      {{"--points", file("far.csv", "lat,lon\n10,10\n")}, 4, "outside_area"},
      {{"--from", "2026-01-01T00:00:00Z", "--to", "2026-01-01T01:00:00Z"},
       4,
       "2025-03-13T00:00:00Z"},
  };
  for (const Case& c : cases) {
    const ProgramResult result = sample(c.arguments);
    const std::string asked = c.arguments[0] + " " + c.arguments[1];
    EXPECT_EQ(result.exit_code, c.exit_code) << asked << ": " << result.err;
    EXPECT_NE(result.err.find(c.word), std::string::npos) << asked << ": " << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(std::filesystem::exists(out())) << asked;
    EXPECT_FALSE(std::filesystem::exists(out("out.nc.partial"))) << asked;
  }
}

}  // namespace
}  // namespace slackwater::tests::cli_sample_test
