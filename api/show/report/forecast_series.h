#pragma once
#include <vector>

#include "api/show/report/report.h"
#include "fields/service/snapshot.h"
#include "fields/site/chart_datum.h"

namespace slackwater::api {

struct ForecastTruth;

/// Wind, waves and the level of the sea of a forecast's first column as panels over
/// `Snapshot::time`, each with its band of 10 to 90 %; what the forecast has not is left out.
struct SurfaceSeries {
  std::vector<ReportSeries> panels;
  ReportLine wind;   ///< the central line of the panel; no values: no wind
  ReportLine waves;  ///< the same
  ReportLine level;  ///< the same, of the sea above mean sea level
  std::string note;  ///< what the bands are, or why there is none
};

/// The band of the wind is that of its speed under the spread of the ensemble's winds (isotropic;
/// fields/service/speed_quantiles.h); without an ensemble there is none. That of the waves is the
/// forecast's own (`height_spread_of`).
[[nodiscard]] SurfaceSeries surface_series(const Snapshot& forecast, const ForecastTruth& truth,
                                           const std::optional<ChartDatum>& chart_datum = {});

}  // namespace slackwater::api
