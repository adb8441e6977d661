#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "data/store/check.h"
#include "data/store/decision.h"
#include "data/store/prune.h"
#include "data/store/rows.h"
#include "data/store/session_action.h"

namespace slackwater::store {

enum class OpenMode {
  create_or_write,  ///< makes the store, or brings it to this program's schema, where needed
  read_only,        ///< for queries; also on a read-only file system
};

/// What Slackwater knows, at rest: a catalogue (SQLite) and immutable content files named by their
/// sha256.
///
///   STORE/catalogue.sqlite          rows: sources, granules, forecasts as issued, decisions,
///                                   sessions
///   STORE/files/ab/abcdef….nc       content; never changed, only added and pruned
///   STORE/staging/<pid>-<random>/   files being written, one folder per process, swept once that
///                                   process is gone
///
/// Every commit is all or nothing and durable when it returns: content is fsynced, renamed into
/// place, its folder fsynced, and only then does one transaction name it. So a row never lacks its
/// file, whenever the machine stops; the reverse, a file without a row, is harmless and `prune`
/// removes it.
///
/// Any number of processes may read and write at once (writers take turns). One thread at a time
/// per Store object. Errors: not_found (no store), unavailable (disk, permission, lock),
/// invalid_input (damaged or newer catalogue).
class Store {
 public:
  [[nodiscard]] static Store open(const std::filesystem::path& folder, OpenMode mode);
  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;
  ~Store();

  /// For one of many short-lived writers, one after the other: closing leaves SQLite's log beside
  /// the catalogue, as a killed process does, instead of bringing it in with four fsyncs. What was
  /// committed is as durable; the last to close without this brings it in.
  void leave_log() noexcept;

  [[nodiscard]] const std::filesystem::path& folder() const noexcept;
  /// This process's folder for content files being written, made on first use; gone with the Store.
  [[nodiscard]] std::filesystem::path staging_folder();
  /// Where a content file lies, whatever became of it: `proven_content` and `content_fault` say
  /// whether it may be opened.
  [[nodiscard]] std::filesystem::path content_path(const std::string& content_sha256) const;
  /// data/store/proven_content.h
  [[nodiscard]] std::filesystem::path proven_content(const std::string& content_sha256) const;
  [[nodiscard]] std::optional<std::string> content_fault(const std::string& content_sha256) const;

  /// The source, if it is stored and its content files are whole (their checksums: reads them); a
  /// source with a lost or damaged file counts as absent, so that ingesting it again repairs the
  /// store.
  [[nodiscard]] std::optional<SourceFile> find_source(const std::string& sha256,
                                                      const std::string& cut_key);
  /// Whether the catalogue names the source, whatever became of its content files.
  [[nodiscard]] bool names_source(const std::string& sha256, const std::string& cut_key);
  /// Takes over the content files and stores the source with all its granules. False: it was there
  /// already (perhaps another process was faster); then the staged files are removed and nothing
  /// changes. After an Error the content files may be gone: decode again before another try.
  bool commit_ingest(const SourceFile& source, std::span<const NewGranule> granules);
  /// In order of (first time, status, reference time, member, id); static fields first.
  [[nodiscard]] std::vector<GranuleRow> find_granules(const GranuleQuery& query);
  /// Throws Error(not_found).
  [[nodiscard]] GranuleRow granule(std::int64_t id);
  [[nodiscard]] std::vector<SourceFile> list_sources();  ///< in order of ingestion

  FiledForecast commit_forecast(const ForecastRow& row, const std::filesystem::path& content_file);
  /// All or none; in the order given. A forecast that is stored already, the same row with the same
  /// content, keeps its id and adds nothing (its content file is mended where it was damaged).
  std::vector<FiledForecast> commit_forecasts(std::span<const NewForecast> forecasts);
  /// In order of (day, issued, id).
  [[nodiscard]] std::vector<ForecastRow> find_forecasts(const ForecastQuery& query);
  [[nodiscard]] std::vector<ForecastRow> list_forecasts() { return find_forecasts({}); }

  /// Adds a decision; none is ever changed or removed. @return its id
  /// Throws Error(not_found) where its forecast is not in the store.
  std::int64_t record_decision(const DecisionRow& row);
  /// In order of (start, id).
  [[nodiscard]] std::vector<DecisionRow> find_decisions(const DecisionQuery& query);

  /// A live run with people begins. @return its id
  std::int64_t begin_session(const std::string& name, UtcTime begun);
  /// What was done in it, all or none; never changed or removed.
  void record_actions(std::int64_t session, std::span<const SessionAction> actions);
  [[nodiscard]] std::vector<SessionRow> list_sessions();
  /// In order. Throws Error(not_found).
  [[nodiscard]] std::vector<SessionAction> find_actions(std::int64_t session);

  /// See `check_store`, which also looks at a store that cannot be opened.
  [[nodiscard]] CheckReport check(bool deep) { return check_store(folder(), deep); }
  PruneReport prune(const PruneOptions& options);

 private:
  struct State;
  explicit Store(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace slackwater::store
