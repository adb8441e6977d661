// A site whose depth is not that of the product: the issued file, the command line, the HTTP
// service, `sample`, the C++ library and the twin are asked for the same depths, and say the same.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "api/ask/run/scenario_run.h"
#include "api/door/edr/service.h"
#include "api/issued/in_force.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/store_for_tests.h"
#include "twin/environment/environment.h"

namespace slackwater::tests::bed_at_every_door_test {
namespace {

using nlohmann::json;

constexpr const char* east = "eastward_sea_water_velocity";
constexpr UtcDay day = std::chrono::sys_days{std::chrono::year{2025} / 3 / 6};
const UtcTime then = parse_utc("2025-03-09T06:00:00Z");

/// What a door says of a depth.
struct Said {
  std::string status;  ///< "" where a door gives numbers alone
  std::optional<double> east_m_s;
};

class BedAtEveryDoor : public ::testing::Test {
 protected:
  /// The product is wet to 30 m.
  BedAtEveryDoor() { store_.ingest_days(day, 3); }

  void issue(double site_depth_m) {
    const auto sites = store_.store() / "sites";
    std::filesystem::create_directories(sites);
    std::ofstream(sites / "test_site.yaml")
        << "id: test_site\nlatitude_deg: 54\nlongitude_deg: 6.5\nwater_depth_m: " << site_depth_m
        << "\n";
    const ProgramResult result =
        store_.run({"forecast", "--site", "test_site", "--at", "2025-03-09T05:00:00Z", "--out",
                    store_.file("issued.nc").string(), "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    notes_ = json::parse(result.out).at("columns").at(0).at("notes").dump();
    store::Store store = store::Store::open(store_.store(), store::OpenMode::read_only);
    field_ = api::read_field(store, api::forecast_in_force(store, {}).row, ingest::Members::none);
  }

  [[nodiscard]] Said library(double depth_m) const {
    return said(field_->current({6.5, 54, depth_m, then}));
  }
  [[nodiscard]] Said profile(double depth_m) const {
    const ProgramResult result = store_.run({"profile", "--site", "test_site", "--json", "--time",
                                             format_utc(then), "--depth", json(depth_m).dump()});
    const json level = json::parse(result.out).at("levels").at(0);
    Said found{level.at("status"), {}};
    if (level.contains(east)) found.east_m_s = level.at(east).at("value").get<double>();
    return found;
  }
  [[nodiscard]] Said sample(double depth_m) const {
    std::ofstream(store_.file("points.csv")) << "latitude_deg,longitude_deg\n54,6.5\n";
    const std::string time = format_utc(then);
    const ProgramResult result =
        store_.run({"sample", "--site", "test_site", "--points", store_.file("points.csv").string(),
                    "--from", time, "--to", time, "--depths", json(depth_m).dump(), "--json",
                    "--out", store_.file("samples.nc").string()});
    Said found;
    if (result.exit_code == 4) {  // not one value: there is no file, the error counts
      const bool is_below = (result.out + result.err).find("(below_bed 1)") != std::string::npos;
      return {is_below ? "below_bed" : result.out + result.err, {}};
    }
    const json counts = json::parse(result.out).at("status");
    for (const auto& [status, count] : counts.items())
      if (count == 1) found.status = status;
    return found;
  }
  [[nodiscard]] Said http(double depth_m) const {
    api::http::Router router;
    api::edr::add_routes(router, std::make_shared<api::IssuedFields>(store_.store()),
                         "http://edr.test");
    api::http::Request request;
    request.method = "GET";
    request.host = "edr.test";
    request.path = "/collections/currents/position";
    request.query = "coords=POINT(6.5%2054)&z=" + json(depth_m).dump() +
                    "&datetime=" + format_utc(then) + "&parameter-name=" + east;
    const api::http::Response answer = api::http::completed(router(request));
    if (answer.status != 200) return {"below_bed", {}};  // deeper than anything that it holds
    const json document = json::parse(answer.body);
    const json value = document.at("ranges").at(east).at("values").at(0);
    const std::string notes = document.at("slackwater:provenance").at("notes").dump();
    const auto says = [&](const char* word) { return notes.find(word) != std::string::npos; };
    Said found{says("carry the current") ? "carried" : says("below_bed") ? "below_bed" : "ok", {}};
    if (!value.is_null()) found.east_m_s = value.get<double>();
    return found;
  }
  [[nodiscard]] Said twin(double depth_m) const {
    twin::Scenario scenario;
    scenario.water = twin::ForecastWater{"test_site", {}, {}};
    scenario.start = then;
    const api::ScenarioWater water = api::water_of(scenario, store_.store(), {});
    twin::Environment environment;
    environment.field = water.surround.field;
    environment.origin = GeoPoint::from_degrees(54, 6.5);
    environment.epoch = then;
    const twin::WaterSample found =
        twin::EnvironmentSampler(environment).current({0, 0, depth_m}, 0, 0);
    Said answer{std::string(name_of(found.status)), {}};
    if (has_value(found.status)) answer.east_m_s = found.current_m_s.y;
    return answer;
  }
  /// At a level of the file.
  [[nodiscard]] Said file(std::size_t level) const {
    const Snapshot issued = ingest::read_forecast(store_.file("issued.nc"), ingest::Members::none);
    const ForecastColumn& column = issued.columns.at(0);
    const std::size_t o = 6 * issued.depth_m.size() + level;
    return said({column.current_m_s[o], 0, column.current_status[o]});
  }

  static Said said(const CurrentSample& sample) {
    Said found{std::string(name_of(sample.status)), {}};
    if (has_value(sample.status)) found.east_m_s = sample.velocity_m_s.real();
    return found;
  }
  static void expect_same(const Said& found, const Said& expected, double as_printed_m_s) {
    EXPECT_EQ(found.status, expected.status);
    ASSERT_EQ(found.east_m_s.has_value(), expected.east_m_s.has_value());
    if (!found.east_m_s) return;
    EXPECT_NEAR(*found.east_m_s, *expected.east_m_s, as_printed_m_s);
  }
  void expect_one_answer(double depth_m, const std::string& status) const {
    SCOPED_TRACE(std::to_string(depth_m) + " m");
    const Said expected = library(depth_m);
    EXPECT_EQ(expected.status, status);
    {
      SCOPED_TRACE("profile");
      expect_same(profile(depth_m), expected, 0);
    }
    {
      SCOPED_TRACE("http");
      expect_same(http(depth_m), expected, 1e-6);
    }
    {
      SCOPED_TRACE("twin");
      expect_same(twin(depth_m), expected, 1e-5);
    }
    EXPECT_EQ(sample(depth_m).status, status);
    const std::vector<double>& levels = field_->snapshot().depth_m;
    for (std::size_t k = 0; k < levels.size(); ++k) {
      SCOPED_TRACE("file");
      if (levels[k] == depth_m) expect_same(file(k), expected, 1e-6);
    }
  }

  StoreForTests store_;
  std::shared_ptr<const Field> field_;
  std::string notes_;
};

TEST_F(BedAtEveryDoor, ASiteShallowerThanTheProductEndsAtItsOwnBed) {
  issue(8);
  for (const double depth_m : {0.0, 5.0, 7.5}) expect_one_answer(depth_m, "ok");
  for (const double depth_m : {9.0, 10.0, 20.0, 30.0}) expect_one_answer(depth_m, "below_bed");
  EXPECT_NE(notes_.find("the site gives 8 m of water, but the currents go down to 30 m"),
            std::string::npos)
      << notes_;
}

TEST_F(BedAtEveryDoor, ASiteDeeperThanTheProductCarriesItsDeepestValueAndSaysSo) {
  issue(60);
  for (const double depth_m : {20.0, 30.0, 35.0}) expect_one_answer(depth_m, "ok");
  for (const double depth_m : {37.0, 50.0, 60.0}) expect_one_answer(depth_m, "carried");
  expect_one_answer(61, "below_bed");
  EXPECT_NE(notes_.find("the site gives 60 m of water, but the currents end at 30 m"),
            std::string::npos)
      << notes_;
}

TEST_F(BedAtEveryDoor, DepthsThatAgreeAreNotSpokenOf) {
  issue(33);
  expect_one_answer(32.5, "ok");
  EXPECT_EQ(notes_.find("m of water"), std::string::npos) << notes_;
}

}  // namespace
}  // namespace slackwater::tests::bed_at_every_door_test
