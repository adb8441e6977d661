#include "fields/site/chart_datum.h"

#include "fields/base/text.h"

namespace slackwater {

std::string datum_words(const std::optional<ChartDatum>& datum) {
  if (!datum) return "over mean sea level; the site states no chart datum";
  return formatted("over mean sea level; chart datum ({}) is {:.2f} m below it", datum->name,
                   datum->below_mean_sea_level_m);
}

}  // namespace slackwater
