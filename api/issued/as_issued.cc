#include "api/issued/as_issued.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "api/issued/in_force.h"

namespace slackwater::api {
namespace {

bool is_forecast(const store::ForecastRow& row) { return row.origin == ForecastOrigin::forecast; }

/// The latest issue time of the forecasts filed before each one, by its number.
std::map<std::int64_t, UtcTime> latest_issue_before(
    const std::vector<store::ForecastRow>& of_site) {
  std::map<std::int64_t, UtcTime> issued;
  for (const store::ForecastRow& row : of_site)
    if (is_forecast(row)) issued[row.id] = row.issued;
  UtcTime latest = UtcTime::min();
  for (auto& [id, time] : issued) {
    const UtcTime own = time;
    time = latest;
    latest = std::max(latest, own);
  }
  return issued;
}

}  // namespace

std::vector<store::ForecastRow> as_issued_first(std::vector<store::ForecastRow> rows,
                                                const std::vector<store::ForecastRow>& of_site) {
  const std::map<std::int64_t, UtcTime> before = latest_issue_before(of_site);
  const auto is_replay = [&](const store::ForecastRow& row) {
    const auto found = before.find(row.id);
    return found != before.end() && found->second > row.issued;
  };
  // The first that was filed, replays only where there is nothing else.
  const store::ForecastRow* first = nullptr;
  const auto filing = [&](const store::ForecastRow& row) {
    return std::tuple(!is_forecast(row), is_replay(row), row.id);
  };
  for (const store::ForecastRow& row : rows)
    if (first == nullptr || filing(row) < filing(*first)) first = &row;
  if (first == nullptr || !is_forecast(*first)) {
    std::sort(rows.begin(), rows.end(), has_more_force);
    return rows;
  }
  const UtcTime first_issue = first->issued;
  const bool only_replays = is_replay(*first);
  enum class Standing { morning, later, replay, hindcast };
  const auto standing_of = [&](const store::ForecastRow& row) {
    if (!is_forecast(row)) return Standing::hindcast;
    if (is_replay(row) && !only_replays) return Standing::replay;
    return row.issued >= first_issue && row.issued <= first_issue + same_morning ? Standing::morning
                                                                                 : Standing::later;
  };
  const auto key = [&](const store::ForecastRow& row) {
    const Standing standing = standing_of(row);
    const Duration since = row.issued - first_issue;
    const bool newest_first = standing == Standing::morning || standing == Standing::hindcast;
    const std::int64_t id = standing == Standing::hindcast ? -row.id : row.id;
    return std::tuple(standing, newest_first ? -since : since, id);
  };
  std::sort(rows.begin(), rows.end(),
            [&](const auto& a, const auto& b) { return key(a) < key(b); });
  return rows;
}

ForecastOrigin origin_of_run(UtcDay day, UtcTime issued, bool day_was_named, bool hindsight,
                             const std::vector<store::ForecastRow>& of_site) {
  if (hindsight) return ForecastOrigin::hindcast;
  if (!day_was_named) return ForecastOrigin::forecast;
  const bool is_past = std::any_of(of_site.begin(), of_site.end(), [&](const auto& row) {
    if (!is_forecast(row)) return false;
    return row.day == day ? issued > row.issued + same_morning
                          : row.day > day && row.issued <= issued;
  });
  return is_past ? ForecastOrigin::hindcast : ForecastOrigin::forecast;
}

}  // namespace slackwater::api
