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

/// The content that was named before and is named no more is left to the caller to remove.
void delete_rows(Database& database, const PruneOptions& options, PruneReport& report) {
  const std::size_t forecasts = count_of(database, "forecast");
  const std::size_t granules = count_of(database, "granule");
  const std::size_t sources = count_of(database, "source");
  if (options.forecasts) {
    database.prepare("DELETE FROM forecast WHERE issued_ms < ?").bind(1, *options.older_than).run();
  }
  database
      .prepare(
          "DELETE FROM source WHERE ingested_at_ms < ? "
          "AND NOT EXISTS (SELECT 1 FROM granule g WHERE g.source_id = source.id AND "
          "g.first_time_ms IS NULL) "
          "AND NOT EXISTS (SELECT 1 FROM granule g JOIN forecast_input i ON i.granule_id = g.id "
          "                WHERE g.source_id = source.id)")
      .bind(1, *options.older_than)
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
