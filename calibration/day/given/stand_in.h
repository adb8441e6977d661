#pragma once
#include <optional>
#include <string>

#include "calibration/day/given/forecast_plan.h"
#include "fields/record/site_data.h"
#include "fields/service/snapshot.h"

namespace slackwater::calibration {

/// A product that speaks for the one that leads at a site.
struct StandIn {
  std::string leading;  ///< product ids
  std::string used;
  /// Root mean square difference of a component between the two over what is known of both up to
  /// the end of D, all levels; nothing where they share no time.
  std::optional<double> difference_m_s;
};

/// What a headline says of it.
[[nodiscard]] std::string text_of(const StandIn& stand_in);

/// Compares the plan's dataset with the one it stands in for, and widens the column by what they
/// are known to differ: sigma^2 += d^2, members in proportion. Where they share no time, d is that
/// of two products that err by 0.10 m/s each (calibration/fuse/fusion_settings.h). Nothing where
/// the plan's dataset stands in for none.
[[nodiscard]] std::optional<StandIn> widen_by_stand_in(ForecastColumn& column,
                                                       const ColumnData& data,
                                                       const ForecastPlan& plan);

}  // namespace slackwater::calibration
