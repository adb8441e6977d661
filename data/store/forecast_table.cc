#include "data/store/forecast_table.h"

#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::store {
namespace {

bool exists(Database& database, std::string_view sql, std::int64_t id) {
  Statement query = database.prepare(sql);
  query.bind(1, id);
  return query.step();
}

ForecastRow forecast_from(const Statement& row) {
  ForecastRow forecast;
  int column = 0;
  forecast.id = row.integer(column++);
  forecast.site_id = row.name(column++);
  forecast.day = row.parsed(column++, parse_day);
  forecast.issued = row.time(column++);
  forecast.valid_from = row.time(column++);
  forecast.valid_to = row.time(column++);
  forecast.wind_policy = row.parsed(column++, wind_policy_from);
  forecast.origin = row.parsed(column++, forecast_origin_from);
  forecast.degraded = row.integer(column++) != 0;
  forecast.headline = row.text(column++);
  forecast.content_sha256 = row.checksum(column++);
  forecast.summary_json = row.text(column++);
  forecast.code_version = row.name(column++);
  return forecast;
}

std::vector<std::int64_t> inputs_of(Database& database, std::int64_t forecast) {
  Statement query = database.prepare(
      "SELECT granule_id FROM forecast_input WHERE forecast_id = ? ORDER BY position");
  query.bind(1, forecast);
  std::vector<std::int64_t> inputs;
  while (query.step()) inputs.push_back(query.integer(0));
  return inputs;
}

}  // namespace

std::optional<std::int64_t> same_forecast(Database& database, const ForecastRow& row,
                                          const std::string& content_sha256) {
  Statement query = database.prepare(
      "SELECT id FROM forecast WHERE site_id = ? AND day = ? AND issued_ms = ? AND "
      "content_sha256 = ? AND valid_from_ms = ? AND valid_to_ms = ? AND wind_policy = ? AND "
      "origin = ? AND degraded = ? AND headline = ? AND summary_json = ? AND code_version = ? "
      "ORDER BY id");
  query.bind_all(row.site_id, format_day(row.day), row.issued, content_sha256, row.valid_from,
                 row.valid_to, name_of(row.wind_policy), name_of(row.origin),
                 std::int64_t{row.degraded}, row.headline, row.summary_json, row.code_version);
  while (query.step()) {
    const std::int64_t id = query.integer(0);
    if (inputs_of(database, id) == row.input_granules) return id;
  }
  return std::nullopt;
}

std::int64_t insert_forecast(Database& database, const ForecastRow& row,
                             const SealedFile& content) {
  expects(row.valid_from <= row.valid_to, "a forecast is valid from an instant to a later one");
  Statement insert = database.prepare(
      "INSERT INTO forecast (site_id, day, issued_ms, valid_from_ms, valid_to_ms, wind_policy, "
      "origin, degraded, "
      "headline, content_sha256, content_bytes, summary_json, code_version) VALUES "
      "(?,?,?,?,?,?,?,?,?,?,?,?,?)");
  insert.bind_all(row.site_id, format_day(row.day), row.issued, row.valid_from, row.valid_to,
                  name_of(row.wind_policy), name_of(row.origin), std::int64_t{row.degraded},
                  row.headline, content.sha256, static_cast<std::int64_t>(content.bytes),
                  row.summary_json, row.code_version);
  insert.run();
  const std::int64_t id = database.last_inserted_id();
  Statement input = database.prepare(
      "INSERT INTO forecast_input (forecast_id, position, granule_id) VALUES (?,?,?)");
  for (std::size_t i = 0; i < row.input_granules.size(); ++i) {
    const std::int64_t granule = row.input_granules[i];
    if (!exists(database, "SELECT 1 FROM granule WHERE id = ?", granule)) {
      throw Error(ErrorKind::not_found, "granule " + std::to_string(granule) +
                                            ", an input of this forecast, is no longer in the "
                                            "store; it was pruned meanwhile: run "
                                            "the forecast again");
    }
    input.bind_all(id, static_cast<std::int64_t>(i), granule).run();
  }
  return id;
}

std::vector<ForecastRow> select_forecasts(Database& database, const ForecastQuery& query) {
  std::string sql =
      "SELECT id, site_id, day, issued_ms, valid_from_ms, valid_to_ms, wind_policy, origin, "
      "degraded, headline, "
      "content_sha256, summary_json, code_version FROM forecast WHERE 1";
  std::vector<std::string> bound;
  const auto restrict_to = [&](std::string_view condition, const std::string& value) {
    sql += condition;
    bound.push_back(value);
  };
  if (!query.site_id.empty()) restrict_to(" AND site_id = ?", query.site_id);
  if (query.from_day) restrict_to(" AND day >= ?", format_day(*query.from_day));
  if (query.to_day) restrict_to(" AND day <= ?", format_day(*query.to_day));
  if (query.origin) restrict_to(" AND origin = ?", std::string(name_of(*query.origin)));
  if (query.wind_policy)
    restrict_to(" AND wind_policy = ?", std::string(name_of(*query.wind_policy)));
  sql += " ORDER BY day, issued_ms, id";
  Statement select = database.prepare(sql);
  for (std::size_t i = 0; i < bound.size(); ++i) select.bind(static_cast<int>(i) + 1, bound[i]);
  Statement inputs = database.prepare(
      "SELECT granule_id FROM forecast_input WHERE forecast_id = ? ORDER BY position");
  std::vector<ForecastRow> forecasts;
  while (select.step()) {
    ForecastRow forecast = forecast_from(select);
    inputs.bind(1, forecast.id);
    while (inputs.step()) forecast.input_granules.push_back(inputs.integer(0));
    inputs.reset();
    forecasts.push_back(std::move(forecast));
  }
  return forecasts;
}

}  // namespace slackwater::store
