#include "api/show/report/forecast_series.h"

#include <algorithm>
#include <cmath>

#include "api/show/report/forecast_page.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "fields/base/turn.h"
#include "fields/service/speed_quantiles.h"
#include "fields/wave/height_error.h"
#include "fields/wave/height_spread.h"

namespace slackwater::api {
namespace {

using constants::nan;

/// Standard deviation of a component of the wind over the members; NaN without an ensemble.
double wind_sigma_m_s(const ForecastColumn& column, std::size_t t) {
  const std::size_t times = column.wind_m_s.size();
  const std::size_t members = times == 0 ? 0 : column.wind_member_m_s.size() / times;
  if (members < 2) return nan;
  double sum = 0;
  for (std::size_t m = 0; m < members; ++m)
    sum += std::norm(column.wind_member_m_s[m * times + t] - column.wind_m_s[t]);
  return std::sqrt(sum / (2 * static_cast<double>(members)));
}

ReportLine truth_line(const std::vector<UtcTime>& times,
                      const std::function<std::optional<double>(UtcTime)>& truth) {
  ReportLine line{"truth", {}, {}, {}, true};
  for (const UtcTime time : times) line.values.push_back(truth(time).value_or(nan));
  return line;
}

ReportSeries wind_panel(const Snapshot& s, const ForecastColumn& column) {
  ReportSeries panel{"Wind at 10 m", "speed (m/s)", {}, {}};
  ReportLine line{"forecast", {}, {}, {}, false};
  bool has_band = true;
  for (std::size_t t = 0; t < s.time.size(); ++t) {
    const double speed_m_s = std::abs(column.wind_m_s[t]);
    line.values.push_back(speed_m_s);
    panel.towards_deg.push_back(to_direction_deg(column.wind_m_s[t]));
    const double sigma_m_s = wind_sigma_m_s(column, t);
    has_band = has_band && std::isfinite(sigma_m_s) && std::isfinite(speed_m_s);
    if (!has_band) continue;
    const SpeedQuantiles band = speed_quantiles(speed_m_s, sigma_m_s);
    // A calm centre lies below what is likely; the band holds the line that it belongs to.
    line.low.push_back(std::min(band.p10_m_s, speed_m_s));
    line.high.push_back(band.p90_m_s);
  }
  if (!has_band) line.low = line.high = {};
  panel.lines = {std::move(line)};
  return panel;
}

bool has_waves_of(const ForecastColumn& column, DataStatus source) {
  return std::find(column.sea_source.begin(), column.sea_source.end(), source) !=
         column.sea_source.end();
}

ReportSeries wave_panel(const Snapshot& s, const ForecastColumn& column) {
  ReportSeries panel{"Significant wave height", "height (m)", {}, {}};
  ReportLine line{"forecast", {}, {}, {}, false};
  const std::vector<double> spread = height_spread_of(s, column);
  for (std::size_t t = 0; t < s.time.size(); ++t) {
    const double height_m = column.sea[t].significant_height_m;
    line.values.push_back(height_m);
    panel.towards_deg.push_back(compass_deg(column.sea[t].from_direction_deg + 180));
    line.low.push_back(height_error::height_at(height_m, spread[t], -constants::normal_p90));
    line.high.push_back(height_error::height_at(height_m, spread[t], constants::normal_p90));
  }
  panel.lines = {std::move(line)};
  return panel;
}

/// What the band of the waves is.
std::string wave_note(const ForecastColumn& column) {
  std::string note =
      column.height_spread.empty()
          ? " The waves' band is the usual error of forecast wave heights (a published North Sea "
            "record), not this day's own."
          : " The waves' band is how far such heights were off: a published record, and the past "
            "days of this site as far as they are known.";
  if (has_waves_of(column, DataStatus::modelled))
    note +=
        " Where no wave product is stored, the waves are computed from the wind: the band holds "
        "the error of that wind.";
  if (has_waves_of(column, DataStatus::persisted))
    note +=
        " Where there is no wind either, the last known waves are kept: the band is how far a sea "
        "changes in that time.";
  return note;
}

/// "product forecast, then harmonic tide": in the order of the hours.
std::string level_sources(const SeaLevel& level) {
  std::vector<std::string> sources;
  for (const DataStatus source : level.source) {
    const std::string text(text_of_level_source(source));
    if (sources.empty() || sources.back() != text) sources.push_back(text);
  }
  return joined(sources, ", then ");
}

ReportSeries level_panel(const SeaLevel& level) {
  ReportSeries panel{"Level of the sea", "above mean sea level (m)", {}, {}};
  ReportLine line{"forecast", {}, {}, {}, false};
  for (std::size_t t = 0; t < level.level_m.size(); ++t) {
    const SeaLevelQuantiles band =
        quantiles_of(SeaLevelSample{level.level_m[t], level.sigma_m[t], SampleStatus::ok});
    line.values.push_back(band.p50_m);
    line.low.push_back(band.p10_m);
    line.high.push_back(band.p90_m);
  }
  panel.lines = {std::move(line)};
  return panel;
}

}  // namespace

SurfaceSeries surface_series(const Snapshot& forecast, const ForecastTruth& truth,
                             const std::optional<ChartDatum>& chart_datum) {
  SurfaceSeries result;
  const ForecastColumn& column = forecast.columns.front();
  result.note = "Lines: central forecast; bands: 10 to 90 %.";
  if (column.wind_m_s.size() == forecast.time.size()) {
    ReportSeries panel = wind_panel(forecast, column);
    result.wind = panel.lines.front();
    result.note += result.wind.low.empty() ? " The wind has no band: there is no ensemble of it."
                                           : " The wind's band is the spread of the ensemble.";
    if (truth.wind_speed_m_s)
      panel.lines.push_back(truth_line(forecast.time, truth.wind_speed_m_s));
    result.panels.push_back(std::move(panel));
  } else {
    result.note += " This forecast has no wind.";
  }
  if (column.sea.size() == forecast.time.size()) {
    ReportSeries panel = wave_panel(forecast, column);
    result.waves = panel.lines.front();
    result.note += wave_note(column);
    if (truth.significant_height_m)
      panel.lines.push_back(truth_line(forecast.time, truth.significant_height_m));
    result.panels.push_back(std::move(panel));
  } else {
    result.note += " This forecast has no waves.";
  }
  // Most forecasts have none, and say nothing of it.
  if (!column.sea_level.empty()) {
    ReportSeries panel = level_panel(column.sea_level);
    result.level = panel.lines.front();
    result.panels.push_back(std::move(panel));
    result.note += " The level of the sea is of " + level_sources(column.sea_level) + ". It is " +
                   datum_words(chart_datum) + ".";
  }
  if (truth.current) result.note += " Dashed: the truth.";
  return result;
}

}  // namespace slackwater::api
