#include "api/issued/in_force.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "api/issued/as_issued.h"
#include "fields/base/error.h"
#include "fields/base/turn.h"

namespace slackwater::api {
namespace {

/// (0.1 m in degrees of latitude) squared: columns of two forecasts of one grid point are as near.
constexpr double as_near_deg2 = 1e-12;

/// The square of the distance to the nearest column, in degrees of latitude.
double nearest_column_deg2(const Field& field, double longitude_deg, double latitude_deg) noexcept {
  double nearest = std::numeric_limits<double>::infinity();
  for (const ForecastColumn& column : field.snapshot().columns) {
    const double east = short_way_deg(longitude_deg - column.point.longitude_deg()) *
                        std::cos(column.point.latitude.radians());
    const double north = latitude_deg - column.point.latitude_deg();
    nearest = std::min(nearest, east * east + north * north);
  }
  return nearest;
}

using Rows = std::vector<store::ForecastRow>;

/// Forecasts of one site, origin and day: those in force at the time, where one is asked about,
/// then the others as issued.
void order_within_day(Rows::iterator first, Rows::iterator last, std::optional<UtcTime> valid_at,
                      const Rows& all) {
  const auto late = !valid_at ? first : std::stable_partition(first, last, [&](const auto& row) {
    return row.issued <= *valid_at;
  });
  if (late == last) return;
  Rows of_site = all;
  std::erase_if(of_site, [&](const auto& row) { return row.site_id != first->site_id; });
  Rows ordered = as_issued_first(Rows(late, last), of_site);
  std::move(ordered.begin(), ordered.end(), late);
}

}  // namespace

bool has_more_force(const store::ForecastRow& a, const store::ForecastRow& b) noexcept {
  const auto rank = [](const store::ForecastRow& row) {
    return std::tuple(row.origin == ForecastOrigin::forecast, row.day, row.issued < row.valid_to,
                      row.issued, row.id);
  };
  return rank(a) > rank(b);
}

std::vector<store::ForecastRow> by_force(store::Store& store, const WantedForecast& wanted) {
  store::ForecastQuery query;
  query.site_id = wanted.site_id;
  query.from_day = wanted.day;
  const std::vector<store::ForecastRow> all = store.find_forecasts(query);
  std::vector<store::ForecastRow> rows = all;
  std::erase_if(rows, [&](const store::ForecastRow& row) {
    if (wanted.day && row.day != *wanted.day) return true;
    return wanted.valid_at &&
           (*wanted.valid_at < row.valid_from || *wanted.valid_at > row.valid_to);
  });
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
    return a.site_id != b.site_id ? a.site_id < b.site_id : has_more_force(a, b);
  });
  if (!wanted.day && !wanted.valid_at) return rows;
  for (auto first = rows.begin(); first != rows.end();) {
    const auto last = std::find_if(first, rows.end(), [&](const store::ForecastRow& row) {
      return row.site_id != first->site_id || row.origin != first->origin || row.day != first->day;
    });
    if (std::distance(first, last) > 1) order_within_day(first, last, wanted.valid_at, all);
    first = last;
  }
  return rows;
}

std::optional<std::string> damage_of(const store::Store& store, const store::ForecastRow& row) {
  const auto fault = store.content_fault(row.content_sha256);
  if (!fault) return std::nullopt;
  return "forecast " + std::to_string(row.id) + " of site " + row.site_id + ", issued " +
         format_utc(row.issued) + ", is damaged (its file " +
         store.content_path(row.content_sha256).string() + " " + *fault +
         "); run `slackwater store check`";
}

InForce forecast_in_force(store::Store& store, const WantedForecast& wanted) {
  std::vector<store::ForecastRow> rows = by_force(store, wanted);
  InForce in_force;
  for (store::ForecastRow& row : rows) {
    if (auto damage = damage_of(store, row)) {
      in_force.passed_over.push_back(std::move(*damage));
      continue;
    }
    in_force.row = std::move(row);
    return in_force;
  }
  if (!in_force.passed_over.empty())
    throw Error(ErrorKind::invalid_input, in_force.passed_over.front());
  const std::string of_site =
      wanted.site_id.empty() ? std::string() : " for site " + wanted.site_id;
  const std::string of_day = wanted.day ? " of day " + format_day(*wanted.day) : std::string();
  if (wanted.valid_at) {
    const std::vector<store::ForecastRow> others =
        by_force(store, {wanted.site_id, wanted.day, {}});
    if (!others.empty()) {
      throw Error(ErrorKind::not_found,
                  "no forecast" + of_site + of_day + " covers " + format_utc(*wanted.valid_at) +
                      "; the newest one is valid from " + format_utc(others.front().valid_from) +
                      " to " + format_utc(others.front().valid_to));
    }
  }
  throw Error(ErrorKind::not_found,
              "found no issued forecast" + of_site + of_day + "; run `slackwater forecast` first" +
                  (wanted.day ? ", or name another day (`slackwater store list`)" : ""));
}

std::shared_ptr<const Field> read_field(const store::Store& store, const store::ForecastRow& row,
                                        ingest::Members members) {
  if (const auto damage = damage_of(store, row)) throw Error(ErrorKind::invalid_input, *damage);
  return std::make_shared<const Field>(std::make_shared<const Snapshot>(
      ingest::read_forecast(store.content_path(row.content_sha256), members)));
}

std::optional<std::size_t> nearest_reaching(std::span<const std::shared_ptr<const Field>> fields,
                                            double longitude_deg, double latitude_deg) noexcept {
  std::optional<std::size_t> nearest;
  double nearest_deg2 = 0;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i] == nullptr) continue;
    const Place place{longitude_deg, latitude_deg, 0, {}};
    BedSample bed;
    fields[i]->sample_bed({&place, 1}, {&bed, 1});
    if (bed.status == SampleStatus::outside_area) continue;
    const double deg2 = nearest_column_deg2(*fields[i], longitude_deg, latitude_deg);
    const auto columns = [&](std::size_t field) {
      return fields[field]->snapshot().columns.size();
    };
    const bool is_nearer = !nearest || deg2 < nearest_deg2 - as_near_deg2 ||
                           (deg2 <= nearest_deg2 + as_near_deg2 && columns(i) > columns(*nearest));
    if (!is_nearer) continue;
    nearest = i;
    nearest_deg2 = deg2;
  }
  return nearest;
}

}  // namespace slackwater::api
