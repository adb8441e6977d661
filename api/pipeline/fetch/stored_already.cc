#include "api/pipeline/fetch/stored_already.h"

#include <algorithm>

namespace slackwater::api {
namespace {

using std::chrono::days;

/// For so long after a day its products still better it.
constexpr days still_bettered{3};

/// Whether times of these granules lie on all of a day, end to end or three hours apart: of those
/// that came when it was settled, for a day of an old forecast is none that is held.
bool hold(const std::vector<store::GranuleRow>& granules, UtcDay day) {
  constexpr std::chrono::hours step{3};
  UtcTime held_to = UtcTime(day);
  for (const store::GranuleRow& granule : granules) {  // in order of their first time
    const UtcTime came = granule.published_at.value_or(granule.ingested_at);
    if (granule.status == DataStatus::forecast || came < UtcTime(day + still_bettered)) continue;
    if (!granule.first_time || *granule.first_time > held_to + step) continue;
    held_to = std::max(held_to, *granule.last_time);
  }
  return held_to + step >= UtcTime(day + days(1));
}

}  // namespace

void leave_out_stored(store::Store& store, const Site& site, UtcDay day,
                      std::vector<WantedFile>& wanted) {
  for (WantedFile& file : wanted) {
    if (file.dataset_id.empty() || !file.from) continue;
    store::GranuleQuery query;
    query.point = site.point;
    query.from = file.from;
    query.to = UtcTime(day);
    std::vector<store::GranuleRow> granules = store.find_granules(query);
    std::erase_if(granules, [&](const store::GranuleRow& row) {
      return row.product_id != file.product_id ||
             (!row.dataset_id.empty() && row.dataset_id != file.dataset_id);
    });
    UtcDay first = day_of(*file.from);
    while (first < day - still_bettered && hold(granules, first)) first += days(1);
    file.from = std::max(*file.from, UtcTime(first));
  }
}

}  // namespace slackwater::api
