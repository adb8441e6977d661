#include "calibration/day/column/layer_of_days.h"

#include <cmath>

#include "fields/base/constants.h"
#include "fields/record/choose.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

using std::chrono::days;

/// The mean over the times, per level; NaN where a level has no value.
std::vector<double> mean_profile(const ScalarColumn& column) {
  std::vector<double> sum(column.levels());
  std::vector<double> count(column.levels());
  for (std::size_t t = 0; t < column.times(); ++t) {
    for (std::size_t k = 0; k < column.levels(); ++k) {
      if (!column.has(t, k)) continue;
      sum[k] += column.value[column.offset(t, k)];
      ++count[k];
    }
  }
  for (std::size_t k = 0; k < sum.size(); ++k)
    sum[k] = count[k] > 0 ? sum[k] / count[k] : constants::nan;
  return sum;
}

std::vector<double> values_of(const ScalarColumn& column) {
  std::vector<double> values;
  for (std::size_t i = 0; i < column.value.size(); ++i) {
    if (has_value(column.status[i])) values.push_back(column.value[i]);
  }
  return values;
}

}  // namespace

LayerRecord layer_record(const ColumnData& column, const ForecastPlan& plan) {
  const bool is_stated = !column.mixed_layer_depth.pieces.empty();
  return {choose(is_stated ? column.mixed_layer_depth : column.temperature, plan.knowledge(), {}),
          is_stated};
}

LayerOfDays layer_of_days(const LayerRecord& record, UtcDay last) {
  LayerOfDays layer;
  const ScalarColumn& known = record.values.column;
  if (known.times() == 0) return layer;
  for (int before = chain_days; before >= 0; --before) {
    const UtcDay day = last - days(before);
    const ScalarColumn part = slice(known, UtcTime(day), UtcTime(day) + days(1));
    const auto figure = record.is_stated ? stated_layer(values_of(part))
                                         : layer_of_profile(part.levels_m, mean_profile(part));
    if (figure) layer.emplace(day, *figure);
  }
  return layer;
}

}  // namespace slackwater::calibration
