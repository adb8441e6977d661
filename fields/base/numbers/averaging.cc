#include "fields/base/numbers/averaging.h"

#include <vector>

#include "fields/base/numbers/statistics.h"
#include "fields/base/text.h"

namespace slackwater {
namespace {

using std::chrono::hours;
constexpr Duration rounding_of_bounds = std::chrono::minutes(1);

}  // namespace

Duration averaging_of(std::span<const TimeCell> cells) {
  if (cells.empty()) return Duration(0);
  std::vector<Duration> width;
  width.reserve(cells.size());
  for (const TimeCell& cell : cells) width.push_back(cell.end - cell.start);
  return upper_median(std::move(width));
}

bool hides_the_tide(Duration averaging) noexcept {
  return averaging + rounding_of_bounds >= shortest_tideless_mean;
}

std::string averaging_text(Duration averaging) {
  if (averaging <= Duration(0)) return "instants";
  // Products that filter the tide out call a mean over 25 hours a daily one.
  if (averaging >= hours(20) && averaging <= hours(28)) return "daily means";
  const double whole_hours = hours_of(averaging);
  return formatted("means over {:.3g} h", whole_hours);
}

}  // namespace slackwater
