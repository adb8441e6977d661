#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "api/made_up/demo/demo_run.h"
#include "data/store/store.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

// Day D to forecast on an ocean whose truth is known: what comes out of the files, the store, the
// calibration and the propagation must be that truth, within the errors that are stated.

namespace slackwater::tests::twin_test {
namespace {

class SyntheticTwin : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    result_ = new api::DemoResult(
        api::run_demo({folder_->path(), 2025, 3}, [](double, const std::string&) {}));
  }
  static void TearDownTestSuite() {
    delete result_;
    delete folder_;
  }
  static TemporaryFolder* folder_;
  static api::DemoResult* result_;
};
TemporaryFolder* SyntheticTwin::folder_ = nullptr;
api::DemoResult* SyntheticTwin::result_ = nullptr;

TEST_F(SyntheticTwin, CalibrationFindsTheMixingThatTheOceanWasMadeWith) {
  store::Store store = store::Store::open(*folder_ / "store", store::OpenMode::read_only);
  const auto summary = nlohmann::json::parse(store.list_forecasts().back().summary_json);
  const auto& calibration = summary["columns"][0]["calibration"];
  ASSERT_FALSE(calibration.is_null());
  EXPECT_EQ(calibration["form"], "finite_depth");
  EXPECT_TRUE(calibration["wind_used"].get<bool>());
  const api::ColumnMixing truth = result_->ocean.mixing_truth(result_->site.point);
  const std::map<std::string, double> known{{"eddy_viscosity", truth.eddy_viscosity_m2_s},
                                            {"bottom_friction", truth.bottom_friction_m_s},
                                            {"stress_factor", 1.0}};
  std::size_t found = 0;
  for (const auto& p : calibration["parameters"]) {
    const auto truth_of = known.find(p["name"].get<std::string>());
    if (truth_of == known.end()) continue;
    ++found;
    const double departure = std::log(p["value"].get<double>() / truth_of->second);
    EXPECT_LT(std::abs(departure), 2.5 * p["sigma"].get<double>()) << p.dump();
    EXPECT_FALSE(p["at_bound"].get<bool>()) << p.dump();
  }
  EXPECT_EQ(found, 3U);
}

TEST_F(SyntheticTwin, TheLevelOfTheSeaBeatsTheSameHourOfTheDayBeforeAndTheMean) {
  const Snapshot& made = result_->last;
  const SeaLevel& level = made.columns.at(0).sea_level;
  ASSERT_EQ(level.level_m.size(), made.time.size());
  const auto truth_m = [&](UtcTime time) {
    return result_->ocean.elevation_truth_m(made.columns[0].point, time).value();
  };
  double ours = 0, same_hour = 0, mean = 0, scaled = 0;
  int hours = 0;
  for (std::size_t t = 1; t < made.time.size() && t <= 24; ++t) {
    if (made.time[t] > result_->ocean.end()) break;
    const double truth = truth_m(made.time[t]);
    const double error = level.level_m[t] - truth;
    ours += error * error;
    same_hour += std::pow(truth_m(made.time[t] - std::chrono::hours(24)) - truth, 2);
    mean += truth * truth;  // that of the ocean is 0
    scaled += std::pow(error / level.sigma_m[t], 2);
    EXPECT_EQ(level.source[t], DataStatus::modelled);
    ++hours;
  }
  ASSERT_EQ(hours, 24);
  const auto rms = [&](double sum) { return std::sqrt(sum / hours); };
  std::printf(
      "level, day ahead: ours %.3f m, same hour of the day before %.3f m, mean %.3f m; "
      "error in standard deviations %.2f\n",
      rms(ours), rms(same_hour), rms(mean), rms(scaled));
  // Of a few days S2 and N2 are inferred with M2's own phase lag; here they lag by 48 degrees more
  // and 18 less, a metre of S2. What is known of the tide then is not much, and the band says so.
  EXPECT_LT(rms(ours), rms(same_hour));
  EXPECT_LT(rms(ours), 0.6 * rms(mean));
  EXPECT_GT(rms(scaled), 0.4);
  EXPECT_LT(rms(scaled), 1.5);
}

TEST_F(SyntheticTwin, ThePageOnHttpAsksForATimeThatTheDemonstrationForecasts) {
  std::stringstream page;
  page << std::ifstream(source_folder() / "api/docs/http.md").rdbuf();
  const std::string text = page.str();
  const std::size_t at = text.find(" T=");
  ASSERT_NE(at, std::string::npos);
  const UtcTime asked = parse_utc(text.substr(at + 3, std::string("2025-03-13T06:00:00Z").size()));
  // The newest forecast of the command without options, whose days go on from these.
  const auto more = std::chrono::days(api::DemoOptions{}.days - 3);
  EXPECT_GE(asked, result_->last.time.front() + more);
  EXPECT_LE(asked, result_->last.time.back() + more);
}

TEST_F(SyntheticTwin, TheForecastBeatsPersistenceAndDayMeanEveryDay) {
  ASSERT_EQ(result_->days.size(), 3U);
  for (const api::DemoDay& day : result_->days) {
    EXPECT_LT(day.forecast_rmse_m_s, day.persistence_rmse_m_s) << format_day(day.day);
    EXPECT_LT(day.forecast_rmse_m_s, day.day_mean_rmse_m_s) << format_day(day.day);
  }
}

TEST_F(SyntheticTwin, TheEightyPercentBandHoldsAboutEightyPercent) {
  double share = 0;
  for (const api::DemoDay& day : result_->days) share += day.coverage_80 / 3;
  // Three days of a tidal sea hold few independent errors: a band that is honest covers well over
  // half and not all.
  EXPECT_GT(share, 0.6);
  EXPECT_LT(share, 0.995);
}

TEST_F(SyntheticTwin, WindAndWavesOfTheForecastFollowTheirRuns) {
  const ForecastColumn& column = result_->last.columns.front();
  ASSERT_EQ(column.wind_m_s.size(), result_->last.time.size());
  ASSERT_EQ(column.sea.size(), result_->last.time.size());
  double miss = 0;
  for (std::size_t t = 0; t < 24; ++t) {
    EXPECT_EQ(column.wind_source[t + 1], DataStatus::forecast);
    miss += std::norm(column.wind_m_s[t] -
                      result_->ocean.wind_truth(column.point, result_->last.time[t])) /
            24;
    const auto sea = result_->ocean.sea_truth(column.point, result_->last.time[t]);
    ASSERT_TRUE(sea);
    EXPECT_NEAR(column.sea[t].significant_height_m, sea->significant_height_m,
                0.25 * sea->significant_height_m + 0.1);
  }
  // The weather model's own error in its first day is some 1 m/s a component.
  EXPECT_LT(std::sqrt(miss), 3.0);
}

TEST_F(SyntheticTwin, TheSameSeedGivesTheSameForecast) {
  const TemporaryFolder again;
  const api::DemoResult second =
      api::run_demo({again.path(), 2025, 1}, [](double, const std::string&) {});
  const TemporaryFolder third;
  const api::DemoResult same =
      api::run_demo({third.path(), 2025, 1}, [](double, const std::string&) {});
  ASSERT_FALSE(second.last.columns[0].current_m_s.empty());
  EXPECT_EQ(second.last.columns[0].current_m_s, same.last.columns[0].current_m_s);
}

}  // namespace
}  // namespace slackwater::tests::twin_test
