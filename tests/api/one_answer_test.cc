// One water: the command line, the HTTP service, the C++ library and the twin are asked for the
// same places and times, and say the same.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "api/ask/run/scenario_run.h"
#include "api/door/edr/service.h"
#include "api/issued/in_force.h"
#include "tests/api/issued/issued_store.h"
#include "tests/support/program.h"
#include "twin/environment/environment.h"

namespace slackwater::tests::one_answer_test {
namespace {

using nlohmann::json;
using std::chrono::minutes;

constexpr const char* east = "eastward_sea_water_velocity";
constexpr const char* north = "northward_sea_water_velocity";
constexpr const char* level = "sea_surface_height_above_geoid";

/// What each door prints, m/s: CoverageJSON and CSV round; the twin turns degrees into metres and
/// back.
constexpr double as_printed_m_s = 1e-6;
constexpr double as_csv_m_s = 0.51e-4;
constexpr double as_twin_m_s = 1e-5;

struct Asked {
  double longitude_deg = 0;
  double latitude_deg = 0;
  double depth_m = 0;
  UtcTime time{};
};

/// A store in which four forecasts could be meant, and only one is in force.
class OneAnswer : public ::testing::Test {
 protected:
  OneAnswer() {
    issued_.issue(of_day(0, 1));
    in_force_ = of_day(1, 2);
    issued_.issue(in_force_);
    issued_.issue(of_day(2, 3), ForecastOrigin::hindcast);  // newer, but made in hindsight
    std::filesystem::create_directories(issued_.path() / "sites");
    std::ofstream(issued_.path() / "sites" / (in_force_.site_id + ".yaml"))
        << "id: " << in_force_.site_id
        << "\nname: A site\nlatitude_deg: " << format_degrees(middle().latitude_deg())
        << "\nlongitude_deg: " << format_degrees(middle().longitude_deg()) << "\n";
  }

  static std::string format_degrees(double value) { return json(value).dump(); }

  /// Four columns, valid over three days; `seed` tells one forecast's numbers from another's.
  static Snapshot of_day(int days_later, std::uint64_t seed) {
    Snapshot made = made_up_forecast({.columns = 4, .levels = 6, .members = 3, .seed = seed});
    made.day += std::chrono::days(days_later);
    made.issued += std::chrono::days(days_later);
    for (UtcTime& time : made.time) time += std::chrono::days(days_later);
    for (ForecastColumn& column : made.columns) {
      for (Horizontal& current : column.current_m_s) current *= static_cast<double>(seed);
    }
    add_made_up_level(made);
    return made;
  }

  /// Of the columns: no column is there, so that every door has to interpolate.
  [[nodiscard]] GeoPoint middle() const {
    double latitude = 0;
    double longitude = 0;
    for (const ForecastColumn& column : in_force_.columns) {
      latitude += column.point.latitude_deg() / 4;
      longitude += column.point.longitude_deg() / 4;
    }
    return GeoPoint::from_degrees(latitude, longitude);
  }

  [[nodiscard]] std::vector<Asked> places() const {
    std::vector<Asked> asked;
    const GeoPoint at = middle();
    for (const double off_deg : {0.0, 0.004}) {
      for (const double depth_m : {0.25, 6.5, 12.0}) {
        for (const int minute : {90, 30 * 60 + 17}) {
          asked.push_back({at.longitude_deg() + off_deg, at.latitude_deg() - off_deg / 2, depth_m,
                           in_force_.time.front() + minutes(minute)});
        }
      }
    }
    return asked;
  }

  IssuedStore issued_;
  Snapshot in_force_;
};

Horizontal from_library(const std::filesystem::path& folder, const Asked& asked) {
  store::Store store = store::Store::open(folder, store::OpenMode::read_only);
  const auto row = api::forecast_in_force(store, {}).row;
  const CurrentSample sample =
      api::read_field(store, row, ingest::Members::none)
          ->current({asked.longitude_deg, asked.latitude_deg, asked.depth_m, asked.time});
  EXPECT_EQ(sample.status, SampleStatus::ok);
  return sample.velocity_m_s;
}

Horizontal from_profile(const std::filesystem::path& folder, const Asked& asked) {
  const ProgramResult result =
      run_program({"--store", folder.string(), "profile", "--json", "--lat",
                   json(asked.latitude_deg).dump(), "--lon", json(asked.longitude_deg).dump(),
                   "--time", format_utc(asked.time), "--depth", json(asked.depth_m).dump()});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const json level = json::parse(result.out).at("levels").at(0);
  return {level.at(east).at("value").get<double>(), level.at(north).at("value").get<double>()};
}

Horizontal from_sample(const IssuedStore& issued, const std::string& site, const Asked& asked) {
  const std::filesystem::path points = issued.beside("points.csv");
  const std::filesystem::path out = issued.beside("samples.csv");
  std::ofstream(points) << "latitude_deg,longitude_deg\n"
                        << json(asked.latitude_deg) << ',' << json(asked.longitude_deg) << '\n';
  const std::string time = format_utc(asked.time);
  const ProgramResult result =
      run_program({"--store", issued.path().string(), "sample", "--site", site, "--points",
                   points.string(), "--from", time, "--to", time, "--depths",
                   json(asked.depth_m).dump(), "--out", out.string()});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  std::ifstream stream(out);
  std::string names;
  std::string values;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with('#')) continue;
    (names.empty() ? names : values) = line;
  }
  const auto value_of = [&](const std::string& name) {
    std::istringstream heads(names);
    std::istringstream cells(values);
    std::string head;
    std::string cell;
    while (std::getline(heads, head, ',') && std::getline(cells, cell, ','))
      if (head == name) return std::stod(cell);
    ADD_FAILURE() << name << " in " << names;
    return std::nan("");
  };
  return {value_of("east_m_s"), value_of("north_m_s")};
}

Horizontal from_http(const std::filesystem::path& folder, const Asked& asked) {
  api::http::Router router;
  api::edr::add_routes(router, std::make_shared<api::IssuedFields>(folder), "http://edr.test");
  api::http::Request request;
  request.method = "GET";
  request.host = "edr.test";
  request.path = "/collections/currents/position";
  request.query = "coords=POINT(" + json(asked.longitude_deg).dump() + "%20" +
                  json(asked.latitude_deg).dump() + ")&z=" + json(asked.depth_m).dump() +
                  "&datetime=" + format_utc(asked.time) + "&parameter-name=" + east + "," + north;
  const api::http::Response answer = api::http::completed(router(request));
  EXPECT_EQ(answer.status, 200) << answer.body;
  const json ranges = json::parse(answer.body).at("ranges");
  return {ranges.at(east).at("values").at(0).get<double>(),
          ranges.at(north).at("values").at(0).get<double>()};
}

/// The level of the sea, m.
double level_from_http(const std::filesystem::path& folder, const Asked& asked) {
  api::http::Router router;
  api::edr::add_routes(router, std::make_shared<api::IssuedFields>(folder), "http://edr.test");
  api::http::Request request;
  request.method = "GET";
  request.host = "edr.test";
  request.path = "/collections/sea-level/position";
  request.query = "coords=POINT(" + json(asked.longitude_deg).dump() + "%20" +
                  json(asked.latitude_deg).dump() + ")&datetime=" + format_utc(asked.time);
  const api::http::Response answer = api::http::completed(router(request));
  EXPECT_EQ(answer.status, 200) << answer.body;
  return json::parse(answer.body).at("ranges").at(level).at("values").at(0).get<double>();
}

double level_from_profile(const std::filesystem::path& folder, const Asked& asked) {
  const ProgramResult result = run_program(
      {"--store", folder.string(), "profile", "--json", "--lat", json(asked.latitude_deg).dump(),
       "--lon", json(asked.longitude_deg).dump(), "--time", format_utc(asked.time)});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return json::parse(result.out).at("sea_level").at(level).get<double>();
}

/// What the DDS topic `/SITE/tide_level` says too (api/door/dds/message/site_messages.cc).
double level_from_library(const std::filesystem::path& folder, const Asked& asked) {
  store::Store store = store::Store::open(folder, store::OpenMode::read_only);
  const auto row = api::forecast_in_force(store, {}).row;
  const Place place{asked.longitude_deg, asked.latitude_deg, 0, asked.time};
  SeaLevelSample sample;
  api::read_field(store, row, ingest::Members::none)->sample_sea_level({&place, 1}, {&sample, 1});
  EXPECT_EQ(sample.status, SampleStatus::ok);
  return sample.level_m;
}

Horizontal from_twin(const std::filesystem::path& folder, const std::string& site,
                     const Asked& asked) {
  twin::Scenario scenario;
  scenario.water = twin::ForecastWater{site, {}, {}};
  scenario.start = asked.time;
  const api::ScenarioWater water = api::water_of(scenario, folder, {});
  twin::Environment environment;
  environment.field = water.surround.field;
  environment.origin = GeoPoint::from_degrees(asked.latitude_deg, asked.longitude_deg);
  environment.epoch = asked.time;
  const twin::WaterSample sample =
      twin::EnvironmentSampler(environment).current({0, 0, asked.depth_m}, 0, 0);
  EXPECT_EQ(sample.status, SampleStatus::ok);
  return {sample.current_m_s.y, sample.current_m_s.x};  // NED
}

TEST_F(OneAnswer, OfTheSeaLevelToo) {
  const std::filesystem::path store = issued_.path();
  for (const Asked& asked : places()) {
    const double library = level_from_library(store, asked);
    EXPECT_EQ(level_from_profile(store, asked), library);
    EXPECT_NEAR(level_from_http(store, asked), library, 6e-6);
  }
}

/// What `profile --site` says of the level of the sea, as JSON and as words.
std::pair<json, std::string> level_of_the_site(const std::filesystem::path& folder,
                                               const Snapshot& in_force, const std::string& more) {
  std::filesystem::create_directories(folder / "sites");
  std::ofstream(folder / "sites" / (in_force.site_id + ".yaml"))
      << "id: " << in_force.site_id << "\nlatitude_deg: 48.85\nlongitude_deg: -2.55\n"
      << more;
  std::vector<std::string> asked{"--store",
                                 folder.string(),
                                 "profile",
                                 "--site",
                                 in_force.site_id,
                                 "--time",
                                 format_utc(in_force.time.at(2))};
  const ProgramResult words = run_program(asked);
  asked.emplace_back("--json");
  const ProgramResult result = run_program(asked);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return {json::parse(result.out).at("sea_level"), words.out};
}

TEST_F(OneAnswer, TheLevelIsToldOverTheSitesChartDatumTooWhereItStatesOne) {
  const std::filesystem::path store = issued_.path();
  const auto [bare, bare_words] = level_of_the_site(store, in_force_, "");
  EXPECT_TRUE(bare.at("chart_datum").is_null());
  EXPECT_FALSE(bare.contains("water_surface_height_above_reference_datum"));
  EXPECT_NE(bare_words.find("over mean sea level"), std::string::npos) << bare_words;
  EXPECT_NE(bare_words.find("the site states no chart datum"), std::string::npos) << bare_words;

  const auto [told, words] = level_of_the_site(
      store, in_force_,
      "chart_datum: {name: LAT, below_mean_sea_level_m: 5.93, source: chart 7128}\n");
  EXPECT_EQ(told.at("chart_datum"),
            json({{"name", "LAT"}, {"below_mean_sea_level_m", 5.93}, {"source", "chart 7128"}}));
  EXPECT_EQ(told.at(level), bare.at(level)) << "the level over mean sea level is what it was";
  const json& over = told.at("water_surface_height_above_reference_datum");
  EXPECT_DOUBLE_EQ(over.at("value").get<double>(), bare.at(level).get<double>() + 5.93);
  for (const char* quantile : {"p10", "p50", "p90"})
    EXPECT_DOUBLE_EQ(over.at(quantile).get<double>(), bare.at(quantile).get<double>() + 5.93);
  EXPECT_NE(words.find("m over chart datum, LAT"), std::string::npos) << words;
}

TEST_F(OneAnswer, ComesFromEveryDoor) {
  const std::filesystem::path store = issued_.path();
  for (const Asked& asked : places()) {
    SCOPED_TRACE(format_utc(asked.time) + ", " + json(asked.depth_m).dump() + " m");
    const Horizontal library = from_library(store, asked);
    EXPECT_GT(std::abs(library), 0.01) << "a place where nothing flows tells nothing";
    EXPECT_EQ(from_profile(store, asked), library) << "JSON prints what reads back to the bit";
    EXPECT_LT(std::abs(from_sample(issued_, in_force_.site_id, asked) - library), as_csv_m_s);
    EXPECT_LT(std::abs(from_http(store, asked) - library), as_printed_m_s);
    EXPECT_LT(std::abs(from_twin(store, in_force_.site_id, asked) - library), as_twin_m_s);
  }
}

}  // namespace
}  // namespace slackwater::tests::one_answer_test
