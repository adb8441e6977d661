#include "api/made_up/demo/demo_page.h"

#include <cmath>
#include <memory>

#include "api/show/morning/morning_page.h"
#include "api/show/report/forecast_page.h"
#include "api/show/report/verdict_text.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

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

/// What the ocean knows at the site.
ForecastTruth truth_of(const DemoResult& result) {
  const SyntheticOcean& ocean = result.ocean;
  const GeoPoint point = result.last.columns.front().point;
  return {.current = [&ocean, point](
                         double depth_m,
                         UtcTime time) { return ocean.current_truth(point, depth_m, time); },
          .wind_speed_m_s = [&ocean, point](UtcTime time) -> std::optional<double> {
            return std::abs(ocean.wind_truth(point, time));
          },
          .significant_height_m = [&ocean, point](UtcTime time) -> std::optional<double> {
            const auto sea = ocean.sea_truth(point, time);
            if (!sea) return std::nullopt;
            return sea->significant_height_m;
          }};
}

}  // namespace

ReportInput demo_page(const DemoResult& result, const Morning& morning,
                      const std::string& generated) {
  ForecastPage page;
  page.forecast = std::make_shared<const Snapshot>(result.last);
  page.making = result.last_making;
  page.skill = result.skill;
  page.skill_note = "Root mean square vector error over " + std::to_string(result.days.size()) +
                    " consecutive daily forecasts, all levels, against the analysed product; days "
                    "weigh the same. A baseline \"in part\" has fewer days or values than the "
                    "forecast, whose error over the same ones stands beside it. " +
                    verdict_lines(result.skill);
  page.generated = generated;
  page.truth = truth_of(result);
  ReportInput report = morning_page(morning, page);
  report.tables.push_back(truth_table(result));
  return report;
}

}  // namespace slackwater::api
