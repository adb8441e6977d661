#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/show/report/report.h"
#include "calibration/day/forecast_making.h"
#include "calibration/verify/skill_entry.h"
#include "fields/base/local_time.h"
#include "fields/service/snapshot.h"
#include "fields/site/chart_datum.h"

namespace slackwater::api {

/// The truth beside a forecast, where it is known (the demonstration). Functions that are not set
/// know nothing.
struct ForecastTruth {
  std::function<std::optional<Horizontal>(double depth_m, UtcTime time)> current;  ///< towards
  std::function<std::optional<double>(UtcTime time)> wind_speed_m_s;               ///< at 10 m
  std::function<std::optional<double>(UtcTime time)> significant_height_m;
};

/// What the page of a forecast is made from.
struct ForecastPage {
  std::shared_ptr<const Snapshot> forecast;
  std::optional<calibration::ForecastMaking> making;  ///< absent: nobody knows
  std::optional<double>
      depth_m;  ///< shown first; else 10 m, or half of a water less deep than 20 m
  double slack_below_m_s = 0.5;
  std::optional<UtcDay> about;            ///< the day that it answers for; else the first whole one
  std::optional<TimeZone> time_zone;      ///< of the site: local time beside UTC
  std::optional<ChartDatum> chart_datum;  ///< as the site states it
  std::string verified;                   ///< a sentence: how past forecasts did; may be empty
  std::vector<calibration::SkillEntry> skill;  ///< of past forecasts; may be empty
  std::string skill_note;                      ///< what was scored against what
  std::string generated;                       ///< when and by what
  ForecastTruth truth;
};

/// The page of one forecast, at its first column: the answer in words for the first whole UTC day
/// after the issue, the speed at a depth with its band and its slack times, wind and waves with
/// theirs, when the stream is strongest, what degrades the forecast, then the whole profile, the
/// skill, and the calibration folded away. One builder for `forecast --html` and `demo`.
[[nodiscard]] ReportInput forecast_page(const ForecastPage& what);

/// The depth that the page opens with. Error(usage) for one that is not in the water.
[[nodiscard]] double page_depth_m(const Snapshot& forecast, std::optional<double> asked_m);

}  // namespace slackwater::api
