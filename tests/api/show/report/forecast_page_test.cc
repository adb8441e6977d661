#include "api/show/report/forecast_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "api/show/report/plot_data.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/made_up_forecast.h"

namespace slackwater::api::forecast_page_test {
namespace {

using calibration::ForecastMaking;
using nlohmann::json;
using tests::contains;

ForecastPage page_of(Snapshot snapshot) {
  ForecastPage page;
  page.forecast = std::make_shared<const Snapshot>(std::move(snapshot));
  return page;
}

Snapshot made_up() { return tests::made_up_forecast({}); }

std::string answer(const ReportInput& page, const std::string& label) {
  for (const auto& [name, text] : page.answer)
    if (name == label) return text;
  return {};
}

TEST(ForecastPage, SpeaksOfTheFirstWholeDayAfterTheIssue) {
  const ReportInput page = forecast_page(page_of(made_up()));  // issued Mon 10 March, 05:00
  EXPECT_EQ(page.answer_title, "At 10 m on Tue 11 Mar, 00:00 to 24:00 UTC");
  Snapshot brief = tests::made_up_forecast({.hours = 24});  // ends before that day does
  EXPECT_TRUE(contains(forecast_page(page_of(brief)).answer_title, "from Mon 10 Mar 00:00"));
}

TEST(ForecastPage, HasABandAroundEveryLineThatTheCaptionSpeaksOf) {
  const ReportInput page = forecast_page(page_of(made_up()));
  ASSERT_EQ(page.series.size(), 2U);
  for (const ReportSeries& panel : page.series) {
    const ReportLine& line = panel.lines.front();
    ASSERT_EQ(line.low.size(), line.values.size()) << panel.title;
    for (std::size_t t = 0; t < line.values.size(); ++t) {
      EXPECT_LE(line.low[t], line.values[t]);
      EXPECT_LT(line.values[t], line.high[t]);
    }
  }
  const ReportSpeedAtDepth& at = page.speed->depths[page.speed->first];
  for (std::size_t t = 0; t < at.likely_m_s.size(); ++t) {
    EXPECT_LT(at.low_m_s[t], at.likely_m_s[t]);
    EXPECT_LT(at.likely_m_s[t], at.high_m_s[t]);
  }
}

TEST(ForecastPage, SaysNothingOfSlackAndTideWhereTheyAreAveragedAway) {
  Snapshot s = made_up();
  s.averaged = AveragedCurrents{std::chrono::hours(24), false, 0.3, ""};
  const ReportInput page = forecast_page(page_of(s));
  std::string slack;
  for (const auto& [label, text] : page.answer) {
    if (label == "Slack") slack = text;
    EXPECT_NE(label, "Tidal stream strongest");
  }
  EXPECT_TRUE(contains(slack, "not known: the currents are daily means")) << slack;
  for (const ReportSpeedAtDepth& at : page.speed->depths) EXPECT_TRUE(at.slack.empty());
  for (const ReportTable& table : page.tables)
    EXPECT_FALSE(contains(table.title, "stream is strongest")) << table.title;
}

TEST(ForecastPage, ACurrentThatDoesNotChangeHasNoTide) {
  Snapshot s = made_up();
  ForecastColumn& column = s.columns.front();
  for (std::size_t i = 0; i < column.current_m_s.size(); ++i) {
    column.current_m_s[i] = {0.6, 0.1};
    column.current_sigma_m_s[i] = 0.05;
  }
  for (const auto& [label, text] : forecast_page(page_of(s)).answer)
    EXPECT_NE(label, "Tidal stream strongest") << text;
}

TEST(ForecastPage, WindWithoutAnEnsembleHasNoBandAndSaysSo) {
  const ReportInput page = forecast_page(page_of(tests::made_up_forecast({.members = 1})));
  EXPECT_TRUE(page.series.front().lines.front().low.empty());
  EXPECT_TRUE(contains(page.series_note, "The wind has no band"));
}

TEST(ForecastPage, TheBandOfTheWavesIsTheForecastsOwnAndSaysWhereTheyAreFrom) {
  Snapshot s = made_up();  // its waves are modelled
  const auto page_with = [&](double spread, DataStatus source) {
    ForecastColumn& column = s.columns.front();
    column.height_spread.assign(spread > 0 ? column.sea.size() : 0, spread);
    for (DataStatus& of : column.sea_source) of = source;
    return forecast_page(page_of(s));
  };
  const ReportInput computed = page_with(0.5, DataStatus::modelled);
  EXPECT_TRUE(contains(computed.series_note, "computed from the wind")) << computed.series_note;
  const ReportLine& wide = computed.series[1].lines.front();
  for (std::size_t t = 0; t < wide.values.size(); ++t) {
    EXPECT_NEAR(wide.high[t], (wide.values[t] + 0.3) * std::exp(0.5 * 1.2815515655) - 0.3, 1e-9);
    EXPECT_LT(wide.low[t], wide.values[t]);
  }
  EXPECT_TRUE(
      contains(page_with(0.5, DataStatus::persisted).series_note, "the last known waves are kept"));
  const ReportInput product = page_with(0.2, DataStatus::forecast);
  EXPECT_FALSE(contains(product.series_note, "computed from the wind"));
  EXPECT_LT(product.series[1].lines.front().high.front(), wide.high.front());
  EXPECT_TRUE(contains(page_with(0, DataStatus::forecast).series_note, "a published North Sea"))
      << "forecasts from before they said so";
}

TEST(ForecastPage, ShowsTheLevelOfTheSeaWithItsBandWhereTheForecastHasOne) {
  Snapshot s = made_up();
  const std::size_t times = s.time.size();
  for (std::size_t t = 0; t < times; ++t) {
    SeaLevel& level = s.columns.front().sea_level;
    level.level_m.push_back(3 * std::cos(0.5 * static_cast<double>(t)));
    level.sigma_m.push_back(0.2);
    level.source.push_back(t < 30 ? DataStatus::forecast : DataStatus::modelled);
  }
  const ReportInput page = forecast_page(page_of(s));
  ASSERT_EQ(page.series.size(), 3U);
  EXPECT_EQ(page.series[2].title, "Level of the sea");
  const ReportLine& line = page.series[2].lines.front();
  for (std::size_t t = 0; t < times; ++t) {
    EXPECT_DOUBLE_EQ(line.values[t], 3 * std::cos(0.5 * static_cast<double>(t)));
    EXPECT_NEAR(line.high[t] - line.low[t], 2 * constants::normal_p90 * 0.2, 1e-12);
  }
  EXPECT_TRUE(contains(page.series_note,
                       "The level of the sea is of product forecast, then harmonic tide."))
      << page.series_note;
  EXPECT_FALSE(contains(forecast_page(page_of(made_up())).series_note, "level of the sea"));
  EXPECT_TRUE(contains(page.series_note, "the site states no chart datum."));
  ForecastPage stated = page_of(std::move(s));
  stated.chart_datum = ChartDatum{"LAT", 5.93, "chart 7128"};
  EXPECT_TRUE(contains(forecast_page(stated).series_note, "chart datum (LAT) is 5.93 m below it."));
}

TEST(ForecastPage, BandOfTheWindIsTheSpreadOfItsMembers) {
  // Members of the made-up wind stand one m/s a component from a wind of about 8.5 m/s.
  const ReportInput page = forecast_page(page_of(tests::made_up_forecast({.members = 401})));
  const ReportLine& wind = page.series.front().lines.front();
  double width = 0;
  for (std::size_t t = 0; t < wind.values.size(); ++t) width += wind.high[t] - wind.low[t];
  width /= static_cast<double>(wind.values.size());
  EXPECT_NEAR(width, 2 * constants::normal_p90, 0.1);
}

TEST(ForecastPage, SlackIsWhereTheSpeedStaysBelowTheThresholdThatIsAsked) {
  ForecastPage what = page_of(made_up());
  what.slack_below_m_s = 0.3;
  const ReportInput page = forecast_page(what);
  const ReportSpeedAtDepth& at = page.speed->depths[page.speed->first];
  ASSERT_FALSE(at.slack.empty());
  for (std::size_t t = 0; t < page.speed->time.size(); ++t) {
    const bool is_slack = std::any_of(at.slack.begin(), at.slack.end(), [&](const SlackWindow& w) {
      return page.speed->time[t] >= w.from && page.speed->time[t] <= w.to;
    });
    EXPECT_EQ(is_slack, at.likely_m_s[t] < 0.3) << t;
  }
  EXPECT_TRUE(contains(answer(page, "Slack"), "0.3 m/s")) << answer(page, "Slack");
  what.slack_below_m_s = 5;
  EXPECT_TRUE(contains(answer(forecast_page(what), "Slack"), "throughout"));
  what.slack_below_m_s = 0.01;
  EXPECT_TRUE(contains(answer(forecast_page(what), "Slack"), "never"));
}

TEST(ForecastPage, OpensWithTheDepthThatIsAskedAndRefusesOneOutsideTheWater) {
  ForecastPage what = page_of(made_up());
  what.depth_m = 7.5;
  const ReportInput page = forecast_page(what);
  EXPECT_EQ(page.speed->depths[page.speed->first].label, "7.5 m");
  for (const double outside : {-1.0, 50.5, std::nan("")}) {
    what.depth_m = outside;
    try {
      static_cast<void>(forecast_page(what));
      FAIL() << outside;
    } catch (const Error& problem) {
      EXPECT_EQ(problem.kind(), ErrorKind::usage);
      EXPECT_TRUE(contains(problem.message(), "50.0 m")) << problem.message();
    }
  }
}

TEST(ForecastPage, StrongestStreamsOfASemidiurnalTideAreSixHoursApart) {
  const ReportInput page = forecast_page(page_of(made_up()));
  const auto table = std::find_if(page.tables.begin(), page.tables.end(), [](const ReportTable& t) {
    return contains(t.title, "strongest");
  });
  ASSERT_NE(table, page.tables.end());
  // 72 h less three at each end hold ten or eleven halves of 12.42 h.
  EXPECT_GE(table->rows.size(), 10U);
  EXPECT_LE(table->rows.size(), 11U);
}

TEST(ForecastPage, WithoutCurrentsWindOrWavesItSaysWhatIsMissing) {
  Snapshot s = made_up();
  ForecastColumn& column = s.columns.front();
  std::fill(column.current_status.begin(), column.current_status.end(), SampleStatus::missing);
  column.wind_m_s.clear();
  column.wind_member_m_s.clear();
  column.sea.clear();
  s.degraded = true;
  s.headline = "No whole day of currents is stored.";
  const ReportInput page = forecast_page(page_of(s));
  EXPECT_FALSE(page.speed || page.profile);
  EXPECT_TRUE(contains(answer(page, "Current"), "not in this forecast"));
  EXPECT_TRUE(contains(answer(page, "Wind at 10 m"), "not in this forecast"));
  EXPECT_TRUE(contains(answer(page, "Waves (Hs)"), "not in this forecast"));
  const std::string html = report_html(page, "/* library */");
  EXPECT_TRUE(contains(html, "Degraded forecast."));
  EXPECT_TRUE(contains(html, "No whole day of currents is stored."));
  EXPECT_FALSE(contains(html, "nan"));
}

TEST(ForecastPage, FoldsTheCalibrationAway) {
  ForecastPage what = page_of(made_up());
  what.making.emplace();
  what.making->notes = {"no tide: the record is short"};
  what.making->fit = {
      {{"eddy viscosity", "m2 s-1", 0.02, 0.01, false, true}}, 0.02, 120, "Converged."};
  const std::string html = report_html(forecast_page(what), "/* library */");
  const auto details = html.find("<details>");
  ASSERT_NE(details, std::string::npos);
  EXPECT_GT(html.find("eddy viscosity"), details);
  EXPECT_GT(html.find("no tide: the record is short"), details);
  EXPECT_LT(html.find("id=\"answer\""), details);
  what.making.reset();
  EXPECT_FALSE(contains(report_html(forecast_page(what), "x"), "<details>"));
}

TEST(ForecastPage, WithoutPlotsTheAnswerAndTheNumbersAreThere) {
  const std::string html = report_html(forecast_page(page_of(made_up())), "");
  for (const char* words : {"id=\"answer\"", "Slack", "Every three hours", "Tue 11 Mar 03:00"})
    EXPECT_TRUE(contains(html, words)) << words;
}

TEST(ForecastPage, CarriesTheSlackOfEveryDepthForItsSelector) {
  const ReportInput page = forecast_page(page_of(made_up()));
  const json speed = json::parse(plot_data_json(page))["speed"];
  ASSERT_EQ(speed["depths"].size(), page.speed->depths.size());
  for (const json& at : speed["depths"]) {
    EXPECT_EQ(at["likely"].size(), speed["time"].size());
    EXPECT_GE(at["rows"].size(), 1U);
  }
}

TEST(ForecastPage, ShowsLocalTimeBesideUtcWhereTheSiteStatesItsZone) {
  ForecastPage what = page_of(made_up());
  EXPECT_FALSE(json::parse(plot_data_json(forecast_page(what))).contains("local"));
  what.time_zone = TimeZone::named("Europe/Paris");
  const ReportInput page = forecast_page(what);
  const json local = json::parse(plot_data_json(page))["local"];
  EXPECT_EQ(local["zone"], "Europe/Paris");
  EXPECT_EQ(local["changes"][0][1], 60);
  EXPECT_EQ(local["changes"][0][2], "CET");
  EXPECT_TRUE(contains(answer(page, "Strongest current"), " CET)"))
      << answer(page, "Strongest current");
  EXPECT_TRUE(contains(report_html(page, ""), "Mon 10 Mar 03:00 (04:00 CET)"));
}

}  // namespace
}  // namespace slackwater::api::forecast_page_test
