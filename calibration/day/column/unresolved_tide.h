#pragma once
#include <optional>
#include <vector>

#include "calibration/day/given/forecast_plan.h"
#include "fields/record/choose.h"
#include "fields/record/site_data.h"
#include "fields/service/averaged_currents.h"
#include "fields/service/snapshot.h"

namespace slackwater::calibration {

/// What was found of a column of means, and whose values told of the tide.
struct UnresolvedTide {
  AveragedCurrents averaged;
  std::vector<const Origin*> origins;  ///< owned by the data
};

/// Widens a column that was fitted to means over hours by the tide that such means leave out, as
/// far as another record tells of it; nothing where the currents of D are instants or means short
/// enough to hold the tide.
///
/// The tidal record is the longest of the column's other datasets, up to the end of D, that is not
/// such means itself, nor detided, and shows a tide (three days and more, fields/current/tide.h).
/// What it says of the tide beyond what the means' own harmonic tide holds is e(z, t), on the level
/// nearest in depth. The band is widened by the variance of e along its longest axis over the 25
/// hours around a stamp, so that springs are wider than neaps,
///
///   sigma^2 += (<|e|^2> + |<e^2>|)/2,
///
/// and each member runs with e at a phase of its own. The central forecast stays as it is: a mean.
[[nodiscard]] std::optional<UnresolvedTide> widen_by_unresolved_tide(
    ForecastColumn& column, const ColumnData& data, const Chosen<Horizontal>& known,
    const ForecastPlan& plan);

}  // namespace slackwater::calibration
