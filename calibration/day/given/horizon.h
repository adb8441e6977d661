#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibration/day/given/forecast_plan.h"
#include "calibration/day/given/wind_ensemble.h"
#include "calibration/day/given/wind_fill.h"
#include "fields/record/site_data.h"
#include "fields/service/snapshot.h"
#include "fields/service/wind_policy.h"

namespace slackwater::calibration {

/// The wind of a column: what is known up to the end of D as stored, then hourly over the horizon.
struct HorizonWind {
  std::optional<VectorColumn>
      series;  ///< for calibration and propagation; nothing where no wind is stored
  std::vector<Horizontal> wind_m_s;  ///< at the stamps; empty where no wind is stored
  std::vector<DataStatus> source;    ///< per stamp
  /// Standard deviation of a component per stamp for standing in a gap, or for having been brought
  /// from another height, beside the error of its source; 0 where it is neither.
  std::vector<double> extra_sigma_m_s;
  std::vector<WindGap> gaps;           ///< too long for a line, with values after them
  std::vector<Stretch> stretches;      ///< who speaks when
  std::vector<const Origin*> origins;  ///< whose values were used
  bool hindsight = false;              ///< some of them were not known by `BestInputs::known_by`
  bool simulated = false;  ///< after D an analysis with an error drawn (simulated_run.h)
  /// Of the newest ensemble run that is known, at the stamps; empty where there is none, and under
  /// `persist`.
  std::vector<WindMember> members;
  WindEnsembleRun member_run;  ///< whose they are
};
[[nodiscard]] HorizonWind horizon_wind(const VectorRecord& wind, WindPolicy policy,
                                       UtcTime end_of_day, std::span<const UtcTime> stamps,
                                       const BestInputs& best = {});

/// The sea state of a column over the horizon: stored waves by the same policy, else the growth law
/// of fields/wave driven by the wind over the site's fetch, from the last known state. Where none
/// is known, from what the known wind of the two days before has raised on calm water: of swell
/// from elsewhere it knows nothing. Empty where there are neither waves nor wind.
struct HorizonSea {
  std::vector<SeaState> sea;
  std::vector<DataStatus> source;
  std::vector<Stretch> stretches;      ///< who speaks when, of stored waves
  std::vector<const Origin*> origins;  ///< of stored waves; empty: the wind alone
  bool hindsight = false;  ///< stored waves were used that were not known; the wind says so itself
  /// When the sea was last known that the first stamps were carried on from; nothing where they are
  /// stored, or the wind alone raised them.
  std::optional<UtcTime> carried_from{};
};
[[nodiscard]] HorizonSea horizon_sea(const ColumnData& column, const Site& site, WindPolicy policy,
                                     UtcTime end_of_day, std::span<const UtcTime> stamps,
                                     const HorizonWind& wind, const BestInputs& best = {});

}  // namespace slackwater::calibration
