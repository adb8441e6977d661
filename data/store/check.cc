#include "data/store/check.h"

#include <map>
#include <optional>
#include <string_view>

#include "data/store/content_files.h"
#include "data/store/content_scan.h"
#include "data/store/database.h"
#include "data/store/decision_table.h"
#include "data/store/forecast_table.h"
#include "data/store/granule_table.h"
#include "data/store/layout.h"
#include "data/store/migrations.h"
#include "data/store/open_catalogue.h"
#include "data/store/session_table.h"
#include "data/store/staging.h"
#include "fields/base/encode/utf8.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::store {
namespace {

void harm(CheckReport& report, std::string found, std::string advice) {
  report.sound = false;
  report.findings.push_back({true, std::move(found), std::move(advice)});
}

void note(CheckReport& report, std::string found, std::string advice) {
  report.findings.push_back({false, std::move(found), std::move(advice)});
}

const std::string advice_for_catalogue =
    "restore catalogue.sqlite from a copy; without one, move the store's folder aside and ingest "
    "the product "
    "files again (its content files are not harmed by that, but nothing names them)";

std::size_t count(Database& database, std::string_view table) {
  Statement query = database.prepare("SELECT count(*) FROM " + std::string(table));
  query.step();
  return static_cast<std::size_t>(query.integer(0));
}

/// Reads a list as every command reads it.
template <typename Read>
void check_rows(CheckReport& report, const Read& read) {
  try {
    static_cast<void>(read());
  } catch (const Error& error) {
    harm(report, error.message(), advice_for_catalogue);
  }
}

/// Reports of forecasts are kept as JSON. A changed letter that leaves them JSON is not seen.
void check_summaries(Database& database, CheckReport& report) {
  Statement rows =
      database.prepare("SELECT id, summary_json, json_valid(summary_json) FROM forecast");
  while (rows.step()) {
    const auto bytes = rows.bytes(1);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (rows.integer(2) == 0 || as_utf8(text) != text)
      harm(report,
           formatted("catalogue.sqlite: the summary_json of forecast {} is no JSON",
                     rows.integer(0)),
           advice_for_catalogue);
  }
}

void check_catalogue(Database& database, CheckReport& report) {
  for (const std::string& fault : schema_faults(database))
    harm(report, "catalogue.sqlite: " + fault, advice_for_catalogue);
  Statement integrity = database.prepare("PRAGMA integrity_check(20)");
  while (integrity.step()) {
    if (const std::string said = integrity.text(0); said != "ok") {
      harm(report, "catalogue.sqlite: " + said, advice_for_catalogue);
    }
  }
  Statement keys = database.prepare("PRAGMA foreign_key_check");
  while (keys.step()) {
    harm(report,
         "catalogue.sqlite: row " + keys.text(1) + " of table " + keys.text(0) +
             " names a row of table " + keys.text(2) + " that is not there",
         advice_for_catalogue);
  }
  check_rows(report, [&] {
    check_summaries(database, report);
    return 0;
  });
  check_rows(report, [&] { return read_sources(database); });
  check_rows(report, [&] { return select_granules(database, {}); });
  check_rows(report, [&] { return select_forecasts(database, {}); });
  check_rows(report, [&] { return select_decisions(database, {}); });
  check_rows(report, [&] {
    std::size_t actions = 0;
    for (const SessionRow& session : select_sessions(database))
      actions += select_actions(database, session.id).size();
    return actions;
  });
  report.sources = count(database, "source");
  report.granules = count(database, "granule");
  report.forecasts = count(database, "forecast");
  report.decisions = count(database, "decision");
}

/// What names this content, and how it can be had again; nothing if no row names it any more.
std::optional<std::string> repair_advice(Database& database, const std::string& sha256) {
  Statement forecast = database.prepare(
      "SELECT id, site_id, day FROM forecast WHERE content_sha256 = ? ORDER BY id LIMIT 1");
  forecast.bind(1, sha256);
  if (forecast.step()) {
    Statement decided = database.prepare("SELECT 1 FROM decision WHERE forecast_id = ? LIMIT 1");
    const bool is_decided_on = decided.bind(1, forecast.integer(0)).step();
    return "it is forecast " + std::to_string(forecast.integer(0)) + " of site " +
           forecast.text(1) + " as issued with day " + forecast.text(2) +
           ", which cannot be made again; restore the file from a copy" +
           (is_decided_on ? ": it cannot be removed, as decisions were made on it"
                          : ", or remove the forecast with "
                            "`slackwater store prune --forecasts --older-than TIME`");
  }
  Statement source = database.prepare(
      "SELECT s.name, s.sha256, s.cut_key FROM granule g JOIN source s ON s.id = g.source_id "
      "WHERE g.content_sha256 = ? ORDER BY g.id LIMIT 1");
  source.bind(1, sha256);
  if (!source.step()) return std::nullopt;
  const std::string cut = source.text(2);
  return "ingest " + source.text(0) + " again (sha256 " + source.text(1) +
         (cut.empty() ? "" : ", cut " + cut) + "): that puts it back";
}

void check_content(Database& database, const std::filesystem::path& folder, bool deep,
                   const std::map<std::string, std::uint64_t>& named, CheckReport& report) {
  for (const auto& [sha256, bytes] : named) {
    ++report.content_files;
    report.content_bytes += bytes;
    std::string fault;
    if (!is_present(folder, sha256, bytes)) {
      std::error_code problem;
      const auto found = std::filesystem::file_size(content_file(folder, sha256), problem);
      fault = problem ? "is missing"
                      : "has " + std::to_string(found) + " bytes where " + std::to_string(bytes) +
                            " were stored";
    } else if (deep && !is_intact(folder, sha256, bytes)) {
      fault = "no longer holds the bytes that its name promises (sha256 differs)";
    }
    if (fault.empty()) continue;
    // Another process may have pruned it since the names were read: then no row names it now.
    if (const auto advice = repair_advice(database, sha256)) {
      harm(report, "content file " + content_file(folder, sha256).string() + " " + fault, *advice);
    }
  }
}

void note_leftovers(const std::filesystem::path& folder,
                    const std::map<std::string, std::uint64_t>& named, CheckReport& report) {
  std::size_t orphans = 0;
  std::uint64_t orphan_bytes = 0;
  for (const FoundFile& file : scan_files(folder)) {
    if (file.sha256.empty()) {
      note(report, "file " + file.path.string() + " is not one of the store's",
           "harmless; remove it if you do not know it");
    } else if (!named.contains(file.sha256)) {
      ++orphans;
      orphan_bytes += file.bytes;
    }
  }
  if (orphans > 0) {
    note(report,
         std::to_string(orphans) + " content files (" + std::to_string(orphan_bytes) +
             " bytes) are named by no row, as an interrupted command leaves them",
         "harmless; `slackwater store prune --orphans` removes them");
  }
  for (const std::filesystem::path& stale : stale_staging_folders(folder)) {
    note(report, "staging folder " + stale.string() + " was left by a process that is gone",
         "harmless; the next ingest or `slackwater store prune` removes it");
  }
}

}  // namespace

CheckReport check_store(const std::filesystem::path& folder, bool deep) {
  CheckReport report;
  std::map<std::string, std::uint64_t> named;
  try {
    Database database = open_catalogue_for_reading(folder);
    check_catalogue(database, report);
    named = named_contents(database);
    check_content(database, folder, deep, named, report);
  } catch (const Error& error) {
    // No store at all, or one we may not look into, is the caller's trouble; a damaged one is a
    // finding.
    if (error.kind() != ErrorKind::invalid_input) throw;
    harm(report, error.message(), advice_for_catalogue);
    return report;
  }
  note_leftovers(folder, named, report);
  return report;
}

}  // namespace slackwater::store
