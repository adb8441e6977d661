// What the commands promise: stable keys, idempotence, immutability, and one answer in every form.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "ingest/cf/forecast/forecast_file.h"
#include "tests/support/contains.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_commands_test {
namespace {

using namespace std::chrono;
using nlohmann::json;

constexpr UtcDay day = sys_days{2025y / March / 6};
constexpr const char* at = "2025-03-09T05:00:00Z";  ///< after three days of data

void expect_keys(const json& document, const std::vector<std::string>& keys,
                 const std::string& of) {
  for (const std::string& key : keys) EXPECT_TRUE(document.contains(key)) << key << " of " << of;
}

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

/// The same numbers, to the bit.
void expect_same_numbers(const Snapshot& a, const Snapshot& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.depth_m, b.depth_m);
  ASSERT_EQ(a.columns.size(), b.columns.size());
  for (std::size_t c = 0; c < a.columns.size(); ++c) {
    EXPECT_EQ(a.columns[c].current_m_s, b.columns[c].current_m_s);
    EXPECT_EQ(a.columns[c].current_sigma_m_s, b.columns[c].current_sigma_m_s);
    EXPECT_EQ(a.columns[c].current_status, b.columns[c].current_status);
    EXPECT_EQ(a.columns[c].wind_m_s, b.columns[c].wind_m_s);
    EXPECT_EQ(a.columns[c].wind_source, b.columns[c].wind_source);
    EXPECT_EQ(a.columns[c].sea_source, b.columns[c].sea_source);
  }
}

class Commands : public ::testing::Test {
 protected:
  Commands() { store_.ingest_days(day, 3); }

  [[nodiscard]] json run_json(std::vector<std::string> arguments) const {
    arguments.emplace_back("--json");
    const ProgramResult result = store_.run(arguments);
    EXPECT_EQ(result.exit_code, 0) << arguments[0] << ": " << result.err;
    EXPECT_TRUE(json::accept(result.out)) << arguments[0] << ": " << result.out;
    return json::accept(result.out) ? json::parse(result.out) : json();
  }
  [[nodiscard]] json forecast(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"forecast", "--site", store_.site(), "--at", at};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_json(arguments);
  }
  [[nodiscard]] std::filesystem::path content_of(const json& row) const {
    const auto sha256 = row.at("content_sha256").get<std::string>();
    return store_.store() / "files" / sha256.substr(0, 2) / (sha256 + ".nc");
  }

  StoreForTests store_;
};

TEST_F(Commands, JsonHasTheDocumentedKeys) {
  const auto product = write_product(store_.file("more.nc"), current_product(day + days(3)));
  const json ingest = run_json({"ingest", product.string()});
  ASSERT_EQ(ingest.at("files").size(), 1U);
  expect_keys(ingest["files"][0],
              {"file", "stored", "sha256", "product", "status", "granules", "times",
               "standard_names", "warnings"},
              "ingest");
  EXPECT_TRUE(ingest.at("failed").empty());

  const json issued = forecast();
  expect_keys(issued,
              {"id", "site", "site_yaml", "day", "issued", "valid_from", "valid_to", "wind",
               "horizon_h", "dataset", "degraded", "headline", "verified", "inputs", "columns",
               "attributions", "dry_columns", "code_version"},
              "forecast");
  EXPECT_EQ(issued["day"], "2025-03-08");
  EXPECT_EQ(issued["valid_from"], "2025-03-09T00:00:00Z");
  EXPECT_EQ(issued["valid_to"], "2025-03-12T00:00:00Z");
  ASSERT_TRUE(issued["columns"][0]["calibration"].is_object()) << issued["columns"][0];
  expect_keys(issued["columns"][0]["calibration"],
              {"form", "wind_used", "parameters", "covariance", "misfit", "rms_m_s", "observations",
               "effective_observations", "iterations", "termination", "warnings"},
              "calibration");
  for (const json& input : issued["inputs"])
    EXPECT_EQ(input.at("sha256").at(0).get<std::string>().size(), 64U);

  const json profile =
      run_json({"profile", "--site", store_.site(), "--time", "2025-03-09T06:00:00Z"});
  expect_keys(profile,
              {"site", "latitude_deg", "longitude_deg", "time", "issued", "day", "wind", "origin",
               "member", "members", "seed", "degraded", "contains_stokes", "headline",
               "water_depth_m", "units", "levels", "attributions", "provenance"},
              "profile");
  EXPECT_FALSE(profile["attributions"].empty());

  const json skill = run_json({"verify", "--site", store_.site()});
  ASSERT_TRUE(skill.is_array());
  ASSERT_FALSE(skill.empty());
  expect_keys(skill[0],
              {"site", "column", "day", "issued", "wind", "depth_m", "lead_h", "method", "n",
               "rmse_m_s", "bias_east_m_s", "bias_north_m_s", "speed_bias_m_s", "direction_mae_deg",
               "correlation", "crps_m_s", "coverage_80", "interval_95", "truth"},
              "verify");
  const json hindcast =
      run_json({"hindcast", "--site", store_.site(), "--from", "2025-03-07", "--to", "2025-03-07"});
  ASSERT_FALSE(hindcast.empty());
  for (const auto& [key, value] : skill[0].items())
    EXPECT_TRUE(hindcast[0].contains(key)) << key << ": one schema for both";

  const json check = run_json({"store", "check"});
  expect_keys(
      check,
      {"sound", "findings", "sources", "granules", "forecasts", "content_files", "content_bytes"},
      "store check");
  EXPECT_EQ(check["forecasts"], 2);
  expect_keys(run_json({"store", "list"}), {"sources", "granules", "forecasts"}, "store list");
  const json site = run_json({"site", "check", store_.site(), "--at", at});
  expect_keys(site, {"id", "name", "latitude_deg", "longitude_deg", "valid", "store"},
              "site check");
  EXPECT_EQ(site["store"]["newest_whole_day"], "2025-03-08");
  EXPECT_TRUE(run_json({"site", "list"}).is_array());
  expect_keys(run_json({"store", "prune", "--orphans"}),
              {"sources", "granules", "forecasts", "content_files", "bytes"}, "store prune");
}

TEST_F(Commands, IngestingAgainIsANoOpThatSaysSo) {
  const auto digests = store_.digests();
  const json again = run_json({"ingest", store_.file("currents-2025-03-07.nc").string()});
  EXPECT_FALSE(again["files"][0]["stored"].get<bool>());
  // The same bytes by another name are the same file.
  std::filesystem::copy_file(store_.file("currents-2025-03-07.nc"), store_.file("other_name.nc"));
  EXPECT_FALSE(run_json({"ingest", store_.file("other_name.nc").string()})["files"][0]["stored"]
                   .get<bool>());
  EXPECT_EQ(store_.digests(), digests);
}

TEST_F(Commands, ComponentsInTwoFilesGiveTheNumbersOfOneFile) {
  StoreForTests split;
  for (int i = 0; i < 3; ++i) {
    for (const std::string other : {"vo", "uo"}) {
      ProductForTests product = current_product(day + days(i));
      std::erase_if(product.quantities, [&](const ProductQuantity& q) { return q.name == other; });
      split.ingest(write_product(split.file(other + std::to_string(i) + ".nc"), product));
    }
    const std::string name = format_day(day + days(i)) + ".nc";
    split.ingest(store_.file("wind-" + name));
    split.ingest(store_.file("waves-" + name));
  }
  const ProgramResult made = split.run({"forecast", "--site", split.site(), "--at", at});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  static_cast<void>(forecast());
  for (const char* time : {"2025-03-09T00:00:00Z", "2025-03-10T07:30:00Z"}) {
    const ProgramResult one =
        store_.run({"profile", "--site", store_.site(), "--time", time, "--csv"});
    const ProgramResult two =
        split.run({"profile", "--site", split.site(), "--time", time, "--csv"});
    EXPECT_EQ(one.exit_code, 0) << one.err;
    EXPECT_EQ(one.out, two.out) << time;
  }
}

TEST_F(Commands, TheOutFileIsTheStoredForecastAndTheSameInputsGiveTheSameBytes) {
  const auto out = store_.file("forecast.nc");
  static_cast<void>(forecast({"--out", out.string()}));
  const json row = json::parse(store_.listing())["forecasts"][0];
  EXPECT_TRUE(read_bytes(out) == read_bytes(content_of(row))) << "byte for byte";
  const auto again = store_.file("again.nc");
  static_cast<void>(forecast({"--out", again.string()}));
  EXPECT_TRUE(read_bytes(out) == read_bytes(again));
  const Snapshot snapshot = ingest::read_forecast(out);
  EXPECT_EQ(snapshot.time.size(), 73U);
  EXPECT_EQ(snapshot.depth_m, (std::vector<double>{0, 5, 10, 20, 30}));
  EXPECT_FALSE(std::filesystem::exists(out.string() + ".partial"));
}

TEST_F(Commands, AForecastAsIssuedIsNeverOverwritten) {
  static_cast<void>(forecast());
  const json first = json::parse(store_.listing())["forecasts"][0];
  const std::string bytes = read_bytes(content_of(first));
  const json again = forecast();
  EXPECT_EQ(again["id"], first["id"]) << "the same inputs at the same time: nothing is added";
  // The provider rewrites a day: a new forecast follows, the old one stands.
  ProductForTests rewritten = current_product(day + days(2));
  rewritten.quantity("uo").value = [](const ProductCell& cell) {
    return WaterForTests::eastward_m_s(cell) + 0.2;
  };
  store_.ingest(write_product(store_.file("rewritten.nc"), rewritten));
  static_cast<void>(forecast());
  const json list = json::parse(store_.listing())["forecasts"];
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0], first);
  EXPECT_EQ(read_bytes(content_of(list[0])), bytes);
  EXPECT_NE(list[1]["content_sha256"], first["content_sha256"]);
}

TEST_F(Commands, ProfileSaysTheSameInEveryFormAndAsTheFile) {
  const auto out = store_.file("forecast.nc");
  static_cast<void>(forecast({"--out", out.string()}));
  const Snapshot snapshot = ingest::read_forecast(out);
  const std::vector<std::string> query{"profile", "--site", store_.site(), "--time",
                                       "2025-03-09T06:00:00Z"};
  const json levels = run_json(query)["levels"];
  std::vector<std::string> with_csv = query;
  with_csv.emplace_back("--csv");
  const auto rows = rows_of(store_.run(with_csv).out);
  const ProgramResult table = store_.run(query);
  ASSERT_EQ(levels.size(), snapshot.depth_m.size());
  ASSERT_EQ(rows.size(), levels.size() + 1);
  EXPECT_EQ(rows[0][1], "depth_m");
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const Horizontal stored =
        snapshot.columns[0].current_m_s[6 * snapshot.depth_m.size() + k];  // hour 6
    const double east = levels[k]["eastward_sea_water_velocity"]["value"];
    const double north = levels[k]["northward_sea_water_velocity"]["value"];
    EXPECT_DOUBLE_EQ(levels[k]["depth_m"].get<double>(), snapshot.depth_m[k]);
    // At a stamp and a level nothing is interpolated, only rounded to single precision.
    EXPECT_NEAR(east, stored.real(), 3e-8);
    EXPECT_NEAR(north, stored.imag(), 3e-8);
    EXPECT_LT(levels[k]["eastward_sea_water_velocity"]["p10"].get<double>(), east);
    EXPECT_GT(levels[k]["eastward_sea_water_velocity"]["p90"].get<double>(), east);
    EXPECT_NEAR(std::stod(rows[k + 1][2]), east, 5.1e-5);  // four decimals
    EXPECT_NEAR(std::stod(rows[k + 1][5]), north, 5.1e-5);
    char speed[32];
    std::snprintf(speed, sizeof speed, "%9.3f", std::abs(stored));
    EXPECT_TRUE(contains(table.out, speed)) << speed << " in " << table.out;
  }
}

TEST_F(Commands, ProfileBelowTheBedAndAboveTheSurfaceIsAStatusNotANumber) {
  static_cast<void>(forecast());
  const json levels = run_json({"profile", "--site", store_.site(), "--time",
                                "2025-03-09T06:20:00Z", "--depth=-2,2.5,31"})["levels"];
  ASSERT_EQ(levels.size(), 3U);
  EXPECT_EQ(levels[0]["status"], "above_surface");
  EXPECT_EQ(levels[1]["status"], "ok");
  EXPECT_EQ(levels[2]["status"], "below_bed");
  EXPECT_FALSE(levels[0].contains("eastward_sea_water_velocity"));
  EXPECT_FALSE(levels[2].contains("sea_water_speed"));
}

TEST_F(Commands, ProfileOutsideTheForecastNamesTheValidRangeOrTheDistance) {
  static_cast<void>(forecast());
  for (const char* time : {"2025-03-08T23:59:59Z", "2025-03-12T00:00:01Z"}) {
    const ProgramResult result = store_.run({"profile", "--site", store_.site(), "--time", time});
    EXPECT_EQ(result.exit_code, 4) << result.out;
    EXPECT_TRUE(contains(result.err, "2025-03-09T00:00:00Z") &&
                contains(result.err, "2025-03-12T00:00:00Z"))
        << result.err;
  }
  for (const char* time : {"2025-03-09T00:00:00Z", "2025-03-12T00:00:00Z"}) {
    EXPECT_EQ(store_.run({"profile", "--site", store_.site(), "--time", time}).exit_code, 0)
        << "both ends belong to it";
  }
  const ProgramResult far =
      store_.run({"profile", "--lat", "54.2", "--lon", "6.5", "--time", "2025-03-09T06:00:00Z"});
  EXPECT_EQ(far.exit_code, 4);
  EXPECT_TRUE(contains(far.err, "22.3 km")) << far.err;  // 0.2 degrees of latitude
}

TEST_F(Commands, TheNewestForecastAnswers) {
  static_cast<void>(forecast());
  store_.ingest_days(day + days(3), 1);
  ASSERT_EQ(
      store_.run({"forecast", "--site", store_.site(), "--at", "2025-03-10T05:00:00Z"}).exit_code,
      0);
  EXPECT_EQ(run_json({"profile", "--site", store_.site(), "--time", "2025-03-10T06:00:00Z"})["day"],
            "2025-03-09");
  EXPECT_EQ(run_json({"profile", "--site", store_.site(), "--time", "2025-03-09T06:00:00Z"})["day"],
            "2025-03-08");
}

TEST_F(Commands, PrintDownloadsGivesExactSubsetLinesAndTouchesNothing) {
  const auto digests = store_.digests();
  const json document = forecast({"--print-downloads", "--day", "2025-03-08"});
  EXPECT_EQ(store_.digests(), digests);
  expect_keys(document, {"site", "day", "lines"}, "--print-downloads");
  // The form of the examples in the products reference: dataset, part, variables, box, depths,
  // times, output.
  const std::string number = R"(-?\d+(\.\d+)?)";
  const std::string stamp = R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d)";
  const std::regex form("copernicusmarine subset -i \\S+( --dataset-part \\S+)?( -v \\S+)+ -x " +
                        number + " -X " + number + " -y " + number + " -Y " + number +
                        "( -z 0 -Z \\d+)?( -t " + stamp + " -T " + stamp +
                        ")?( --coordinates-selection-method outside)? -o \\S+ -f \\S+\\.nc");
  std::string commands;
  std::size_t loops = 0;
  for (const json& line : document["lines"]) {
    const auto text = line.get<std::string>();
    if (text.rfind("#", 0) == 0) continue;
    if (contains(text, "nomads.ncep.noaa.gov"))
      ++loops;  // of the wind forecast: tests/api/pipeline/fetch/download_lines_test.cc
    else
      EXPECT_TRUE(std::regex_match(text, form)) << text;
    commands += text + "\n";
  }
  EXPECT_TRUE(contains(commands, "-i cmems_mod_nws_phy-cur_anfc_1.5km-3D_PT1H-i -v uo -v vo -x "))
      << commands;
  EXPECT_TRUE(contains(commands, "-i cmems_mod_nws_phy-ssh_anfc_1.5km-2D_PT1H-i -v zos -x "))
      << commands;
  EXPECT_TRUE(contains(commands, " -z 0 -Z ")) << commands;
  EXPECT_TRUE(contains(commands, "cmems_mod_nws_wav_anfc_1.5km_PT1H-i")) << commands;
  EXPECT_TRUE(
      contains(commands, "cmems_mod_nws_phy_anfc_1.5km_static --dataset-part bathy -v deptho"))
      << commands;
  EXPECT_TRUE(contains(
      commands, "cmems_obs-wind_glo_phy_nrt_l4_0.125deg_PT1H -v eastward_wind -v northward_wind"))
      << commands;
  EXPECT_TRUE(contains(commands, "T00:00:00 -T 2025-03-12T00:00:00"))
      << "to the end of the horizon: " << commands;
  EXPECT_EQ(loops, 1U) << commands;
  EXPECT_TRUE(contains(commands, "gfs.t00z.pgrb2.0p25.f$h")) << "of 9 March, 05:00: " << commands;

  const json longer = forecast({"--print-downloads", "--day", "2025-03-08", "--history", "60d"});
  EXPECT_TRUE(contains(longer.dump(), " -t 2025-01-07T00:00:00 -T 2025-03-12T00:00:00"));
  EXPECT_EQ(longer["lines"].size(), document["lines"].size());
}

/// The loop of the wind forecast as a shell runs it, with a curl that notes what it is asked for:
/// the steps in order in one file, and a failed step fails the line.
TEST_F(Commands, TheLineOfTheWindForecastIsOneThatAShellRuns) {
  const json document = forecast({"--print-downloads", "--day", "2025-03-08", "--horizon", "3h"});
  const auto loop = document["lines"].back().get<std::string>();
  const auto ran_with = [&](const std::string& curl) {
    const std::filesystem::path folder = store_.file("shell");
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder / "bin");
    for (const auto& [name, text] :
         {std::pair<std::string, std::string>{"curl", curl}, {"sleep", "exit 0\n"}}) {
      std::ofstream(folder / "bin" / name) << "#!/bin/sh\n" << text;
      std::filesystem::permissions(folder / "bin" / name, std::filesystem::perms::owner_all);
    }
    std::ofstream(folder / "line.sh") << loop << "\n";
    const int code =
        std::system(("cd '" + folder.string() + "' && PATH=\"$PWD/bin:$PATH\" sh line.sh").c_str());
    std::ifstream file(folder / "downloads" / "test_site_wind_forecast.grib2");
    return std::pair(code == 0, std::string(std::istreambuf_iterator<char>(file), {}));
  };
  // The last argument is the address; its last digits before the variables the step.
  const std::string notes =
      "for last; do :; done; step=${last#*0p25.f}; printf '%s ' "
      "\"${step%%&*}\"\n";
  EXPECT_EQ(ran_with(notes), std::pair(true, std::string("000 003 ")));
  EXPECT_EQ(ran_with(notes + "[ \"${step%%&*}\" = 000 ]\n"),
            std::pair(false, std::string("000 003 ")));
}

TEST_F(Commands, TheSameInputsAtTheSameTimeAreTheSameForecastAndOthersGetTheirOwn) {
  const std::string site = store_.site();
  const auto issued = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"forecast", "--site", site, "--at", "2025-03-09T05:00:00Z",
                                       "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramResult result = store_.run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::parse(result.out);
  };
  const auto rows = [&] { return json::parse(store_.listing())["forecasts"].size(); };
  const json first = issued({});
  EXPECT_FALSE(first["already_issued"].get<bool>());
  const std::size_t before = rows();
  for (int turn = 0; turn < 2; ++turn) {
    const json again = issued({});
    EXPECT_EQ(again["id"], first["id"]);
    EXPECT_TRUE(again["already_issued"].get<bool>());
  }
  const ProgramResult told =
      store_.run({"forecast", "--site", site, "--at", "2025-03-09T05:00:00Z"});
  EXPECT_TRUE(contains(told.out, "already issued as " + first["id"].dump())) << told.out;
  EXPECT_EQ(rows(), before);
  const ProgramResult check = store_.run({"store", "check"});
  EXPECT_EQ(check.exit_code, 0) << check.out;
  EXPECT_NE(issued({"--horizon", "48h"})["id"], first["id"]);
  EXPECT_NE(issued({"--wind", "persist"})["id"], first["id"]);
  EXPECT_EQ(rows(), before + 2);
}

TEST_F(Commands, HindcastGivesTheNumbersOfTheForecastIssuedAtTheEndOfTheDay) {
  const std::string site = store_.site();
  for (const char* wind : {"best", "forecast", "persist"}) {
    ASSERT_EQ(store_
                  .run({"hindcast", "--site", site, "--from", "2025-03-07", "--to", "2025-03-07",
                        "--wind", wind})
                  .exit_code,
              0);
    std::vector<std::string> live_job{
        "forecast", "--site", site, "--day", "2025-03-07", "--at", "2025-03-08T00:00:00Z",
        "--wind",   wind};
    if (std::string(wind) == "best") live_job.emplace_back("--hindsight");
    ASSERT_EQ(store_.run(live_job).exit_code, 0);
    const json list = json::parse(store_.listing())["forecasts"];
    const json& past = *(list.end() - 2);
    const json& live = list.back();
    EXPECT_EQ(past["origin"], "hindcast");
    EXPECT_EQ(live["origin"], std::string(wind) == "best" ? "hindcast" : "forecast")
        << "in hindsight";
    const Snapshot a = ingest::read_forecast(content_of(past));
    const Snapshot b = ingest::read_forecast(content_of(live));
    SCOPED_TRACE(wind);
    expect_same_numbers(a, b);
  }
}

}  // namespace
}  // namespace slackwater::tests::cli_commands_test
