#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "calibration/verify/method_tallies.h"
#include "calibration/verify/skill_entry.h"
#include "fields/record/site_data.h"
#include "fields/service/snapshot.h"

namespace slackwater::calibration {

/// What a page draws of one forecast beside its scores.
struct ForecastTrace {
  UtcDay day{};
  UtcTime issued{};
  ForecastOrigin origin = ForecastOrigin::forecast;
  WindPolicy wind = WindPolicy::best;
  std::string truth;
  GeoPoint point;               ///< of the column that is drawn
  double water_depth_m = 0;     ///< the deepest of its columns
  std::vector<UtcTime> time;    ///< centres of the truth's cells after D
  std::vector<double> depth_m;  ///< the truth's levels
  /// Of that column, time x depth, depth fastest, m/s; NaN where there is no value.
  std::vector<Horizontal> forecast_m_s;
  std::vector<Horizontal> truth_m_s;
  /// Squared vector errors of the forecast over all columns, by time and depth (m).
  std::map<std::pair<UtcTime, double>, BlockSum> misfit;
};

/// Whose currents a forecast was made from.
struct CurrentSource {
  std::string dataset;  ///< empty: from none, there is nothing to score
  /// The dataset that leads at the site, where the other only stood in for it: then it is the
  /// truth.
  std::string stands_in_for{};
};

/// The scores of one forecast, and what a page draws of it where the options ask for it.
struct ForecastSkill {
  std::vector<SkillEntry> entries;
  std::optional<ForecastTrace> trace;
};

/// Scores the currents of one forecast at every column against the truth that the data hold now.
/// Columns are worked on in parallel; the result does not depend on the number of threads.
///
/// @param blank    what all entries of this forecast share
[[nodiscard]] ForecastSkill score_currents(const SiteData& data, const Snapshot& snapshot,
                                           const CurrentSource& currents,
                                           const VerifyOptions& options, const SkillEntry& blank);

/// "station Cabo de Gata", or the product's id.
[[nodiscard]] std::string truth_name(const Origin& origin);

}  // namespace slackwater::calibration
