#include "calibration/tide/fitted_tide.h"

namespace slackwater::calibration {

FittedTide fit_column_tide(const VectorColumn& known, Angle latitude) {
  FittedTide tide;
  bool any = false;
  std::vector<Horizontal> value(known.times());
  std::vector<SampleStatus> status(known.times());
  for (std::size_t k = 0; k < known.levels(); ++k) {
    for (std::size_t t = 0; t < known.times(); ++t) {
      value[t] = known.value[known.offset(t, k)];
      status[t] = known.status[known.offset(t, k)];
    }
    tide.levels.push_back(fit_tide(known.time, value, status, latitude));
    any = any || !tide.levels.back().terms.empty();
  }
  if (!any) {
    tide.levels.clear();
    return tide;
  }
  tide.notes = tide.levels.front().notes;
  return tide;
}

}  // namespace slackwater::calibration
