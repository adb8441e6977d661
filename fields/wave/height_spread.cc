#include "fields/wave/height_spread.h"

#include "fields/wave/height_error.h"

namespace slackwater {

std::vector<double> height_spread_of(const Snapshot& snapshot, const ForecastColumn& column) {
  if (!column.height_spread.empty()) return column.height_spread;
  std::vector<double> spread;
  for (std::size_t t = 0; t < column.sea.size(); ++t)
    spread.push_back(
        height_error::of_product(column.sea[t].significant_height_m,
                                 hours_between(snapshot.time.front(), snapshot.time[t])));
  return spread;
}

}  // namespace slackwater
