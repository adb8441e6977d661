// Currents that are means over hours never pass as instants: every door says what they are.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "ingest/cf/forecast/forecast_file.h"
#include "tests/support/contains.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_means_test {
namespace {

using namespace std::chrono;
using nlohmann::json;

constexpr UtcDay first = sys_days{2025y / March / 1};
const std::string no_tide = "they do not hold the tide";

class Means : public ::testing::Test {
 protected:
  /// Means over `averaging_h` for ten days, with wind and waves for them and for what comes.
  void ingest(int averaging_h) const {
    store_.ingest(
        write_product(store_.file("means.nc"), mean_current_product(first, 10, averaging_h)));
    store_.ingest(write_product(store_.file("wind.nc"), wind_product(first, 240)));
    for (ProductForTests ahead :
         {wind_product(first + days(10), 96), wave_product(first + days(10), 96)}) {
      ahead.reference_time = UtcTime(first + days(10));
      store_.ingest(write_product(store_.file(ahead.quantities[0].name + "-ahead.nc"), ahead));
    }
  }
  void ingest_hourly_of_before() const {
    store_.ingest(write_product(store_.file("hourly.nc"), current_product(first - days(30), 720)));
  }
  [[nodiscard]] ProgramResult run(const std::vector<std::string>& arguments) const {
    const ProgramResult result = store_.run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result;
  }
  [[nodiscard]] json forecast(const std::string& at = "2025-03-11T05:00:00Z") const {
    const ProgramResult result = run({"forecast", "--site", store_.site(), "--at", at, "--out",
                                      store_.file("issued.nc").string(), "--json"});
    return result.exit_code == 0 ? json::parse(result.out) : json();
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(store_.file(name)) << text;
    return store_.file(name).string();
  }

  StoreForTests store_;
};

TEST_F(Means, EveryDoorSaysThatDailyMeansAreNoInstants) {
  ingest(24);
  const json issued = forecast();
  EXPECT_EQ(issued.at("degraded"), true);
  const auto headline = issued.at("headline").get<std::string>();
  EXPECT_TRUE(contains(headline, "he currents are daily means")) << headline;
  EXPECT_TRUE(contains(headline, no_tide + ", and its size is not known")) << headline;
  EXPECT_EQ(issued.at("averaged").at("mean_h"), 24);
  EXPECT_TRUE(issued.at("averaged").at("unresolved_tide_m_s").is_null());

  const json row = json::parse(store_.listing())["forecasts"].back();
  EXPECT_EQ(row["degraded"], true);
  EXPECT_EQ(row["headline"], headline);

  const std::vector<std::string> asked{"profile", "--site", store_.site(), "--time",
                                       "2025-03-11T14:00:00Z"};
  EXPECT_TRUE(contains(run(asked).out, "DEGRADED: The currents are daily means")) << run(asked).out;
  std::vector<std::string> as_json = asked;
  as_json.emplace_back("--json");
  const json profile = json::parse(run(as_json).out);
  EXPECT_EQ(profile.at("degraded"), true);
  EXPECT_EQ(profile.at("averaged"), issued.at("averaged"));

  const Snapshot read = ingest::read_forecast(store_.file("issued.nc"));
  ASSERT_TRUE(read.averaged) << "the file as issued knows it";
  EXPECT_EQ(read.averaged->averaging, hours(24));
}

TEST_F(Means, AnEarlierHourlyRecordOfTheSameProductTellsHowWideTheTideIs) {
  ingest(24);
  const json without = forecast();
  ingest_hourly_of_before();
  const json with = forecast();
  const json averaged = with.at("averaged");
  EXPECT_EQ(averaged.at("mean_h"), 24) << "the hours of before make no instants of D";
  // 0.6 m/s east, falling to 0.42 at the bed; the standard deviation of a sine.
  EXPECT_NEAR(averaged.at("unresolved_tide_m_s").get<double>(), 0.6 / std::sqrt(2.0), 0.06);
  EXPECT_TRUE(contains(averaged.at("tidal_record").get<std::string>(), "NWSHELF"));
  EXPECT_TRUE(contains(with.at("headline").get<std::string>(), "the band is widened by up to 0.4"))
      << with.at("headline");
  EXPECT_EQ(with.at("degraded"), true);
  EXPECT_TRUE(without.at("averaged").at("unresolved_tide_m_s").is_null());
}

TEST_F(Means, SixHourlyMeansAreMeansAndSixHourlyInstantsAreNot) {
  ingest(6);
  const json means = forecast();
  EXPECT_EQ(means.at("averaged").at("mean_h"), 6);
  EXPECT_EQ(means.at("degraded"), true);
  EXPECT_TRUE(contains(means.at("headline").get<std::string>(), "means over 6 h"))
      << means.at("headline");

  StoreForTests other;
  ProductForTests instants = current_product(first, 0);
  for (int h = 0; h < 240; h += 6) instants.time.push_back(UtcTime(first) + hours(h));
  other.ingest(write_product(other.file("instants.nc"), instants));
  const ProgramResult result =
      other.run({"forecast", "--site", other.site(), "--at", "2025-03-11T05:00:00Z", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(json::parse(result.out).at("averaged").is_null());
}

TEST_F(Means, VerifyAgainstThemSaysThatTheTruthIsAMean) {
  ingest(24);
  const ProgramResult hindcast = run({"hindcast", "--site", store_.site(), "--from", "2025-03-05",
                                      "--to", "2025-03-07", "--wind", "forecast"});
  EXPECT_TRUE(contains(hindcast.out, "against daily means, not instants")) << hindcast.out;
  const ProgramResult verify = run({"verify", "--site", store_.site()});
  EXPECT_TRUE(contains(verify.out, "m/s against daily means, not instants")) << verify.out;
  EXPECT_TRUE(contains(run({"verify", "--site", store_.site(), "--full"}).out,
                       "(daily means, not instants)"))
      << "the tables' headings too";
  for (const json& entry : json::parse(run({"verify", "--site", store_.site(), "--json"}).out)) {
    if (entry.at("variable") != "sea_water_velocity") continue;
    EXPECT_EQ(entry.at("truth_mean_h"), 24);
    EXPECT_EQ(entry.at("set").at("truth_mean_h"), 24);
  }
  const auto page = store_.file("skill.html");
  static_cast<void>(run({"verify", "--site", store_.site(), "--html", page.string()}));
  EXPECT_TRUE(contains(read_bytes(page), "against daily means, not instants"));
  const auto issue = [&](const char* at) {
    return run({"forecast", "--site", store_.site(), "--wind", "forecast", "--at", at});
  };
  static_cast<void>(issue("2025-03-08T05:00:00Z"));
  const ProgramResult issued = issue("2025-03-11T05:00:00Z");
  EXPECT_TRUE(contains(issued.out, "m/s against daily means, not instants")) << issued.out;
}

TEST_F(Means, AreNoWaterToRehearseInUnlessTheScenarioAcceptsThem) {
  ingest(24);
  static_cast<void>(forecast());
  const auto scenario = [&](const std::string& more) {
    return write("run.yaml",
                 "name: in means\nseed: 5\nduration: 1min\nstep_s: 0.05\n"
                 "water: {forecast: {file: issued.nc" +
                     more +
                     "}}\n"
                     "waves: {from: calm}\nvehicles:\n"
                     "  - {name: rov, model: bluerov2_heavy, "
                     "start: {north_m: 0, east_m: 0, depth_m: 8}, tasks: [{do: hold}]}\n");
  };
  const ProgramResult refused = store_.run({"simulate", scenario("")});
  EXPECT_EQ(refused.exit_code, 3) << refused.out;
  EXPECT_TRUE(contains(refused.err, "daily means")) << refused.err;
  EXPECT_TRUE(contains(refused.err, "accept_means: true")) << refused.err;
  const ProgramResult asked = run({"simulate", scenario(", accept_means: true"), "--json"});
  EXPECT_TRUE(contains(json::parse(asked.out).at("warnings").dump(), no_tide)) << asked.out;
}

}  // namespace
}  // namespace slackwater::tests::cli_means_test
