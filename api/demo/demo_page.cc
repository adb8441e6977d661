#include "api/demo/demo_page.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <tuple>

#include "api/report/verdict_text.h"
#include "calibration/verify/skill_set.h"
#include "fields/base/text.h"
#include "fields/service/field.h"

namespace slackwater::api {
namespace {

using std::chrono::hours;
using std::chrono::minutes;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Half-hourly, metre by metre: smooth to look at.
ReportProfile profile_of(const DemoResult& result) {
  const Snapshot& s = result.last;
  const ForecastColumn& column = s.columns.front();
  ReportProfile profile;
  profile.water_depth_m = column.water_depth_m;
  for (double depth = 0; depth < column.water_depth_m; depth += 1) profile.depth_m.push_back(depth);
  for (UtcTime time = s.time.front(); time <= s.time.back(); time += minutes(30))
    profile.time.push_back(time);
  const Field field(std::make_shared<const Snapshot>(s));
  std::vector<CurrentSample> samples(profile.depth_m.size());
  for (const UtcTime time : profile.time) {
    field.sample_profile(column.point.longitude_deg(), column.point.latitude_deg(), time,
                         profile.depth_m, samples);
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const bool there = has_value(samples[k].status);
      profile.current_m_s.push_back(there ? samples[k].velocity_m_s : Horizontal(nan, nan));
      profile.sigma_m_s.push_back(there ? samples[k].sigma_m_s : nan);
      const auto truth = result.ocean.current_truth(column.point, profile.depth_m[k], time);
      profile.truth_m_s.push_back(truth.value_or(Horizontal(nan, nan)));
    }
  }
  profile.hodograph_time = s.time.front() + hours(12);
  return profile;
}

std::vector<ReportSkill> skill_of(const DemoResult& result) {
  std::vector<calibration::SkillSet> sets =
      calibration::sets_of(calibration::whole_current(result.skill, WindPolicy::best)).sets;
  std::stable_sort(sets.begin(), sets.end(), [](const auto& a, const auto& b) {
    return std::tuple(a.of.lead.from_h, a.of.method) < std::tuple(b.of.lead.from_h, b.of.method);
  });
  std::vector<ReportSkill> rows;
  for (const calibration::SkillSet& set : sets) {
    ReportSkill row;
    row.method = name_of(set.of.method);
    row.lead = formatted("{:.0f}–{:.0f} h", set.of.lead.from_h, set.of.lead.to_h);
    row.rmse_m_s = set.score.rmse;
    rows.push_back(row);
  }
  return rows;
}

void add_wind_and_waves(ReportInput& page, const DemoResult& result) {
  const Snapshot& s = result.last;
  const ForecastColumn& column = s.columns.front();
  page.series_time = s.time;
  ReportSeries wind{"Wind at 10 m", "speed (m/s)", {}, {}};
  ReportLine forecast{"forecast", {}, {}, {}, false};
  ReportLine truth{"truth", {}, {}, {}, true};
  for (std::size_t t = 0; t < s.time.size() && t < column.wind_m_s.size(); ++t) {
    forecast.values.push_back(std::abs(column.wind_m_s[t]));
    wind.towards_deg.push_back(to_direction_deg(column.wind_m_s[t]));
    truth.values.push_back(std::abs(result.ocean.wind_truth(column.point, s.time[t])));
  }
  wind.lines = {forecast, truth};
  ReportSeries sea{"Significant wave height", "height (m)", {}, {}};
  ReportLine height{"forecast", {}, {}, {}, false};
  ReportLine true_height{"truth", {}, {}, {}, true};
  for (std::size_t t = 0; t < s.time.size() && t < column.sea.size(); ++t) {
    height.values.push_back(column.sea[t].significant_height_m);
    sea.towards_deg.push_back(std::fmod(column.sea[t].from_direction_deg + 180, 360));
    const auto found = result.ocean.sea_truth(column.point, s.time[t]);
    true_height.values.push_back(found ? found->significant_height_m : nan);
  }
  sea.lines = {height, true_height};
  if (!wind.lines[0].values.empty()) page.series.push_back(std::move(wind));
  if (!sea.lines[0].values.empty()) page.series.push_back(std::move(sea));
}

ReportTable truth_table(const DemoResult& result) {
  ReportTable table;
  table.title = "Each day against the known truth, lead 0–24 h";
  table.note =
      "Root mean square vector error over all levels and hours, m/s. The truth is the synthetic "
      "ocean itself, "
      "without the noise of its products.";
  table.columns = {"day D", "forecast", "persistence", "day mean", "same hour", "inside 80 % band"};
  for (const DemoDay& day : result.days) {
    table.rows.push_back({format_day(day.day), formatted("{:.3f}", day.forecast_rmse_m_s),
                          formatted("{:.3f}", day.persistence_rmse_m_s),
                          formatted("{:.3f}", day.day_mean_rmse_m_s),
                          formatted("{:.3f}", day.same_hour_rmse_m_s),
                          formatted("{:.0f} %", 100 * day.coverage_80)});
  }
  return table;
}

ReportTable calibration_table(const DemoResult& result) {
  ReportTable table;
  table.title = "Calibration of the last day";
  table.columns = {"parameter", "value", "unit", "prior", "note"};
  const auto summary = nlohmann::json::parse(result.last_summary_json, nullptr, false);
  if (summary.is_discarded() || summary["columns"].empty() ||
      summary["columns"][0]["calibration"].is_null()) {
    return table;
  }
  const auto& calibration = summary["columns"][0]["calibration"];
  for (const auto& p : calibration["parameters"]) {
    std::string note = p["at_bound"].get<bool>() ? "at its bound" : "";
    if (p["weakly_determined"].get<bool>())
      note += note.empty() ? "weakly determined" : ", weakly determined";
    table.rows.push_back(
        {p["name"].get<std::string>(), formatted("{:.4g}", p["value"].get<double>()),
         p["unit"].get<std::string>(), formatted("{:.4g}", p["prior"].get<double>()), note});
  }
  table.note = calibration["termination"].get<std::string>();
  return table;
}

}  // namespace

ReportInput demo_page(const DemoResult& result, const std::string& generated) {
  const Snapshot& s = result.last;
  const ForecastColumn& column = s.columns.front();
  ReportInput page;
  page.title = "Current forecast for " + s.site_name;
  page.site = formatted("{:.3f} N {:.3f} E, {:.0f} m of water", column.point.latitude_deg(),
                        column.point.longitude_deg(), column.water_depth_m);
  page.headline = s.headline;
  page.degraded = s.degraded;
  page.issued = s.issued;
  page.facts = {{"Issued", format_utc(s.issued)},
                {"Valid", format_utc(s.time.front()) + " to " + format_utc(s.time.back())},
                {"Calibrated on", format_day(s.day)},
                {"Wind", std::string(name_of(s.wind_policy.value()))}};
  page.profile = profile_of(result);
  page.skill = skill_of(result);
  page.skill_note = "Root mean square vector error over " + std::to_string(result.days.size()) +
                    " consecutive daily forecasts, all levels, against the analysed product; days "
                    "weigh the same. " +
                    verdict_lines(result.skill);
  add_wind_and_waves(page, result);
  page.tables = {truth_table(result), calibration_table(result)};
  page.attributions = s.attributions;
  page.generated = generated;
  return page;
}

}  // namespace slackwater::api
