#include "api/log/account_log.h"

#include <cmath>
#include <cstdlib>

#include "api/log/account_of_rows.h"
#include "api/log/account_tables.h"
#include "api/log/inspection_log.h"
#include "api/log/manoeuvre_tables.h"
#include "api/log/table_reader.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryFile;
using twin::RunAccount;
using twin::VehicleAccount;

/// The first format with all of an account in its tables.
constexpr int first_with_account = 6;

std::optional<double> maybe(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

void read_fate(const TrajectoryFile& log, RunAccount& account) {
  const ingest::TrajectoryTable* fate = log.find_table("fate");
  const TableReader table(log, "fate");
  if (fate == nullptr || fate->rows() != log.names.size())
    table.refuse(formatted("has {} rows, expected one for each of {} vehicles",
                           fate == nullptr ? 0 : fate->rows(), log.names.size()));
  for (std::size_t i = 0; i < account.vehicles.size(); ++i) {
    VehicleAccount& vehicle = account.vehicles[i];
    for (const AccountColumn& column : account_columns())
      if (column.set)
        if (const auto value = maybe(table.number(column.name, i))) column.set(vehicle, *value);
    vehicle.model = table.word("model", i);
    vehicle.halt = table.named("halt", i, twin::Halt::no_headway);
    vehicle.stopped_by = table.word("stopped_by", i);
  }
  const TableReader befell(log, "befell");
  befell.for_each([&](std::size_t vehicle, std::size_t row) {
    const auto what = twin::fate_named(befell.text("what", row));
    if (!what) befell.refuse_word("what", befell.text("what", row));
    account.vehicles[vehicle].fate.push_back({*what, maybe(befell.number("time", row))});
  });
}

void read_cleaned(const TrajectoryFile& log, RunAccount& account) {
  const TableReader table(log, "cleaned");
  table.for_each([&](std::size_t vehicle, std::size_t row) {
    twin::CleaningOutcome& out = account.vehicles[vehicle].cleaning.emplace();
    out.area_m2 = table.number("area", row);
    out.cleaned_m2 = table.number("cleaned_area", row);
    out.removed_m3 = table.number("growth_removed", row);
    out.left_m3 = table.number("growth_left", row);
    out.density_kg_m3 = table.number("growth_density", row);
    out.done_at = table.number("done_at", row);
    out.worked_s = table.number("tool_time", row);
    out.passes_needed = table.whole("passes_needed", row);
  });
}

}  // namespace

int log_format_of(const TrajectoryFile& log) {
  return std::atoi(log.attribute("log_format").c_str());
}

std::optional<twin::Scenario> scenario_of(const TrajectoryFile& log) {
  const std::string yaml = log.attribute("scenario");
  if (yaml.empty()) return std::nullopt;
  try {
    return twin::parse_scenario(yaml, "scenario of the log");
  } catch (const Error&) {  // of another version: the page does without
    return std::nullopt;
  }
}

twin::VehicleRows rows_of(const TrajectoryFile& log, std::size_t vehicle) {
  return {log.t_s, [&log, vehicle](std::string_view name) -> std::span<const double> {
            const TrajectoryFile::Variable* variable = log.find(name);
            if (variable == nullptr) return {};
            const std::size_t size = log.t_s.size() * variable->per;
            return std::span(variable->values).subspan(vehicle * size, size);
          }};
}

RunAccount account_in(const TrajectoryFile& log, const twin::Scenario* scenario) {
  RunAccount account;
  account.start = log.epoch;
  if (log.t_s.empty()) return account;
  account.ran_s = log.t_s.back();
  account.vehicles.resize(log.names.size());
  for (std::size_t i = 0; i < log.names.size(); ++i) account.vehicles[i].name = log.names[i];
  read_events(log, account);
  if (log_format_of(log) >= first_with_account) {
    read_fate(log, account);
    read_cleaned(log, account);
    read_inspections(log, account);
    read_manoeuvres(log, account);
  } else {
    read_off_rows(log, scenario, account);
  }
  read_bands(log, account);
  for (std::size_t i = 0; i < log.names.size(); ++i) add_rows(rows_of(log, i), account.vehicles[i]);
  return account;
}

}  // namespace slackwater::api
