#pragma once
#include <vector>

#include "api/show/report/report.h"
#include "fields/service/snapshot.h"

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

/// What another fetch would make of waves that are computed from the wind, as a share of their
/// height; 1: the site's file gives the fetch, or a product the waves.
struct FetchDoubt {
  double half = 1;   ///< with half of the assumed fetch
  double twice = 1;  ///< with twice of it
};

/// The band of the wind is that of its speed under the spread of the ensemble's winds (isotropic;
/// fields/service/speed_quantiles.h); without an ensemble there is none. The band of the waves is
/// the published error e of forecast heights at their lead after the end of D
/// (fields/wave/height_error.h): products of waves have no spread. Where the waves H are computed
/// from the wind over a fetch that is assumed, each edge takes in that doubt too, the two as
/// independent:
///
///   H - sqrt(e^2 + (H - H_half)^2)  to  H + sqrt(e^2 + (H_twice - H)^2)
[[nodiscard]] SurfaceSeries surface_series(const Snapshot& forecast, const ForecastTruth& truth,
                                           const FetchDoubt& doubt = {});

}  // namespace slackwater::api
