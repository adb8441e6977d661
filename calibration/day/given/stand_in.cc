#include "calibration/day/given/stand_in.h"

#include <cmath>
#include <numbers>

#include "calibration/fuse/fusion_settings.h"
#include "fields/base/text.h"
#include "fields/interpolate/column_levels.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

Chosen<Horizontal> record_of(const ColumnData& data, const ForecastPlan& plan,
                             const std::string& dataset) {
  Choice choice;
  choice.dataset = dataset;
  Chosen<Horizontal> chosen = choose(data.current, plan.knowledge(), choice);
  chosen.column = slice(chosen.column, UtcTime::min(), plan.end_of_day());
  if (chosen.column.levels_m.empty()) chosen.column.levels_m = {0.0};
  return chosen;
}

std::string product_of(const Chosen<Horizontal>& chosen, const std::string& dataset) {
  return chosen.origin.empty() ? dataset : chosen.origin.front()->product_id;
}

/// Of a component, over all that both hold.
std::optional<double> rms_difference(const VectorColumn& leading, const VectorColumn& used) {
  if (leading.times() == 0 || used.times() == 0) return std::nullopt;
  const VectorColumn there =
      at_times(at_depths(used, leading.levels_m), leading.time, std::chrono::hours(3));
  double squares = 0;
  double count = 0;
  for (std::size_t i = 0; i < leading.value.size(); ++i) {
    if (!has_value(leading.status[i]) || !has_value(there.status[i])) continue;
    squares += std::norm(leading.value[i] - there.value[i]);
    count += 2;
  }
  if (count == 0) return std::nullopt;
  return std::sqrt(squares / count);
}

}  // namespace

std::string text_of(const StandIn& stand_in) {
  const std::string apart =
      stand_in.difference_m_s
          ? formatted("the two differed by {:.2f} m/s in the past", *stand_in.difference_m_s)
          : "their difference is not known";
  return "the leading product " + stand_in.leading + " has no whole day that is recent enough; " +
         stand_in.used + " is used instead: " + apart;
}

std::optional<StandIn> widen_by_stand_in(ForecastColumn& column, const ColumnData& data,
                                         const ForecastPlan& plan) {
  if (plan.stands_in_for.empty()) return std::nullopt;
  const Chosen<Horizontal> leading = record_of(data, plan, plan.stands_in_for);
  const Chosen<Horizontal> used = record_of(data, plan, plan.dataset);
  StandIn found{product_of(leading, plan.stands_in_for), product_of(used, plan.dataset),
                rms_difference(leading.column, used.column)};
  const double apart =
      found.difference_m_s.value_or(std::numbers::sqrt2 * FusionSettings{}.product_error_m_s);
  const std::size_t size = column.current_m_s.size();
  std::vector<double> wider(size, 1.0);
  for (std::size_t o = 0; o < size; ++o) {
    double& sigma = column.current_sigma_m_s[o];
    if (!has_value(column.current_status[o]) || !(sigma > 0)) continue;
    wider[o] = std::hypot(sigma, apart) / sigma;
    sigma *= wider[o];
  }
  for (std::size_t i = 0; i < column.member_m_s.size(); ++i) {
    const Horizontal centre = column.current_m_s[i % size];
    column.member_m_s[i] = centre + wider[i % size] * (column.member_m_s[i] - centre);
  }
  return found;
}

}  // namespace slackwater::calibration
