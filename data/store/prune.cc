#include "data/store/prune.h"

#include "data/store/content_scan.h"
#include "data/store/database.h"
#include "data/store/layout.h"
#include "data/store/staging.h"

namespace slackwater::store {
namespace {

std::size_t count_of(Database& database, std::string_view table) {
  Statement query = database.prepare("SELECT count(*) FROM " + std::string(table));
  query.step();
  return static_cast<std::size_t>(query.integer(0));
}

const std::string old_forecast = "issued_ms < ?1";
const std::string is_decided_on =
    "EXISTS (SELECT 1 FROM decision d WHERE d.forecast_id = forecast.id)";

const std::string old_source =
    "ingested_at_ms < ?1 "
    "AND NOT EXISTS (SELECT 1 FROM granule g WHERE g.source_id = source.id AND "
    "g.first_time_ms IS NULL) "
    "AND NOT EXISTS (SELECT 1 FROM granule g JOIN forecast_input i ON i.granule_id = g.id "
    "                WHERE g.source_id = source.id)";
/// What came is told from the beginning of the forecast on, and values are interpolated over three
/// hours. Where the length of the work is not known, it is a day's.
const std::string tells_what_came =
    "EXISTS (SELECT 1 FROM granule g JOIN decision d JOIN forecast f ON f.id = d.forecast_id "
    "        WHERE g.source_id = source.id AND g.status <> 'forecast' "
    "        AND g.last_time_ms >= f.valid_from_ms - 10800000 "
    "        AND g.first_time_ms <= d.start_ms + coalesce(d.work_ms, 86400000) + 10800000)";

std::size_t count_old(Database& database, const std::string& rows, UtcTime before) {
  Statement query = database.prepare("SELECT count(*) FROM " + rows);
  query.bind(1, before).step();
  return static_cast<std::size_t>(query.integer(0));
}

/// The content that was named before and is named no more is left to the caller to remove.
void delete_rows(Database& database, const PruneOptions& options, PruneReport& report) {
  const std::size_t forecasts = count_of(database, "forecast");
  const std::size_t granules = count_of(database, "granule");
  const std::size_t sources = count_of(database, "source");
  const UtcTime before = *options.older_than;
  if (options.forecasts) {
    report.kept_forecasts =
        count_old(database, "forecast WHERE " + old_forecast + " AND " + is_decided_on, before);
    database.prepare("DELETE FROM forecast WHERE " + old_forecast + " AND NOT " + is_decided_on)
        .bind(1, before)
        .run();
  }
  report.kept_sources =
      count_old(database, "source WHERE " + old_source + " AND " + tells_what_came, before);
  database.prepare("DELETE FROM source WHERE " + old_source + " AND NOT " + tells_what_came)
      .bind(1, before)
      .run();
  report.forecasts = forecasts - count_of(database, "forecast");
  report.granules = granules - count_of(database, "granule");
  report.sources = sources - count_of(database, "source");
}

/// In a dry run, only counted.
void remove_file(const std::filesystem::path& file, std::uint64_t bytes,
                 const PruneOptions& options, PruneReport& report) {
  if (options.dry_run) {
    if (!std::filesystem::exists(file)) return;
    ++report.content_files;
    report.bytes += bytes;
    return;
  }
  std::error_code problem;
  if (std::filesystem::remove(file, problem) && !problem) {
    ++report.content_files;
    report.bytes += bytes;
  }
}

/// Files that no row names any more.
void remove_files(const std::map<std::string, std::uint64_t>& before,
                  const std::map<std::string, std::uint64_t>& named,
                  const std::filesystem::path& folder, const PruneOptions& options,
                  PruneReport& report) {
  for (const auto& [sha256, bytes] : before) {
    if (!named.contains(sha256)) remove_file(content_file(folder, sha256), bytes, options, report);
  }
  if (!options.orphans) return;
  for (const FoundFile& file : scan_files(folder)) {
    const bool is_orphan =
        !file.sha256.empty() && !named.contains(file.sha256) && !before.contains(file.sha256);
    if (is_orphan) remove_file(file.path, file.bytes, options, report);
  }
}

}  // namespace

PruneReport prune_store(Database& database, const std::filesystem::path& folder,
                        const PruneOptions& options) {
  PruneReport report;
  std::map<std::string, std::uint64_t> before;
  if (options.dry_run) {
    const Transaction rolled_back(database, Transaction::Kind::write);
    if (options.older_than) {
      before = named_contents(database);
      delete_rows(database, options, report);
    }
    remove_files(before, named_contents(database), folder, options, report);
    return report;
  }
  if (options.older_than) {
    Transaction transaction(database, Transaction::Kind::write);
    before = named_contents(database);
    delete_rows(database, options, report);
    transaction.commit();
  }
  {
    // The write lock keeps a commit elsewhere from naming a file that is just being removed.
    const Transaction lock(database, Transaction::Kind::write);
    remove_files(before, named_contents(database), folder, options, report);
  }
  report.staging_folders = sweep_staging(folder);
  return report;
}

}  // namespace slackwater::store
