#include "api/ask/decisions/decided_forecast.h"

#include <algorithm>
#include <tuple>

#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::api {
namespace {

using store::ForecastRow;

const ForecastRow* latest(const std::vector<const ForecastRow*>& rows) {
  const auto found = std::max_element(rows.begin(), rows.end(), [](const auto* a, const auto* b) {
    return std::tuple(a->issued, a->id) < std::tuple(b->issued, b->id);
  });
  return found == rows.end() ? nullptr : *found;
}

std::string named(const ForecastRow& row) {
  return "forecast " + std::to_string(row.id) + ", issued " + format_utc(row.issued) +
         ", holds from " + format_utc(row.valid_from) + " to " + format_utc(row.valid_to);
}

}  // namespace

ForecastRow decided_forecast(const std::vector<ForecastRow>& of_site, UtcTime start,
                             UtcTime recorded_at, const std::string& before_names) {
  expects(!of_site.empty(), "there is a forecast to choose from");
  const std::string& site = of_site.front().site_id;
  std::vector<const ForecastRow*> issued, by_then, covering;
  for (const ForecastRow& row : of_site) {
    if (row.origin != ForecastOrigin::forecast) continue;
    issued.push_back(&row);
    if (row.issued > std::min(recorded_at, start)) continue;
    by_then.push_back(&row);
    if (row.valid_from <= start && start < row.valid_to) covering.push_back(&row);
  }
  if (const ForecastRow* found = latest(covering)) return *found;
  const std::string none = "no forecast of site " + site + " that was issued by " +
                           format_utc(std::min(recorded_at, start)) + " covers the start " +
                           format_utc(start) + ": ";
  if (issued.empty())
    throw Error(ErrorKind::not_found,
                none +
                    "the store holds hindcasts alone, which nobody had when it was decided; "
                    "record a decision that was made on a forecast");
  if (const ForecastRow* before = latest(by_then))
    throw Error(ErrorKind::not_found,
                none + named(*before) +
                    "; name a start within it, or issue a newer forecast first "
                    "(`slackwater forecast`)");
  const ForecastRow* first =
      *std::min_element(issued.begin(), issued.end(),
                        [](const auto* a, const auto* b) { return a->issued < b->issued; });
  throw Error(ErrorKind::not_found,
              none + "the first was issued later (" + named(*first) + "); correct " + before_names +
                  "start or " + before_names +
                  "at, or use the store that holds the forecast of that morning");
}

}  // namespace slackwater::api
