#include "data/store/store.h"

#include <algorithm>

#include "data/store/content_files.h"
#include "data/store/database.h"
#include "data/store/decision_table.h"
#include "data/store/forecast_table.h"
#include "data/store/granule_table.h"
#include "data/store/layout.h"
#include "data/store/open_catalogue.h"
#include "data/store/proven_content.h"
#include "data/store/session_table.h"
#include "data/store/staging.h"
#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::store {

struct Store::State {
  std::filesystem::path folder;
  Database database;
  OpenMode mode;
  std::optional<StagingFolder> staging;

  void expect_writable() const {
    expects(mode == OpenMode::create_or_write, "the store was opened for reading only");
  }
};

namespace {

template <typename New>
std::vector<SealedFile> seal_all(std::span<const New> items) {
  std::vector<SealedFile> sealed;
  sealed.reserve(items.size());
  for (const New& item : items) sealed.push_back(seal(item.content_file));
  return sealed;
}

void discard(std::span<const NewGranule> granules) {
  std::error_code ignored;
  for (const NewGranule& granule : granules) std::filesystem::remove(granule.content_file, ignored);
}

bool has_all_content(Database& database, const std::filesystem::path& folder, std::int64_t source) {
  return std::ranges::all_of(contents_of_source(database, source),
                             [&](const NamedContent& content) {
                               return is_intact(folder, content.sha256, content.bytes);
                             });
}

/// Whether the files at hand are all that the stored source names: then they take the places of the
/// lost ones.
bool replaces_content(Database& database, std::int64_t source, std::span<const SealedFile> sealed) {
  return std::ranges::all_of(
      contents_of_source(database, source), [&](const NamedContent& content) {
        return std::ranges::any_of(
            sealed, [&](const SealedFile& file) { return file.sha256 == content.sha256; });
      });
}

}  // namespace

Store::Store(std::unique_ptr<State> state) : state_(std::move(state)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

Store Store::open(const std::filesystem::path& folder, OpenMode mode) {
  expects(!folder.empty(), "a store has a folder");
  Database database = mode == OpenMode::create_or_write ? open_catalogue_for_writing(folder)
                                                        : open_catalogue_for_reading(folder);
  return Store(std::make_unique<State>(State{folder, std::move(database), mode, std::nullopt}));
}

void Store::leave_log() noexcept { state_->database.leave_log(); }

const std::filesystem::path& Store::folder() const noexcept { return state_->folder; }

std::filesystem::path Store::staging_folder() {
  state_->expect_writable();
  if (!state_->staging) {
    sweep_staging(state_->folder);
    state_->staging = StagingFolder::make(state_->folder);
  }
  return state_->staging->path();
}

std::filesystem::path Store::content_path(const std::string& content_sha256) const {
  expects(content_sha256.size() == 64, "a content file is named by 64 hexadecimal digits");
  return content_file(state_->folder, content_sha256);
}

std::filesystem::path Store::proven_content(const std::string& content_sha256) const {
  return store::proven_content(state_->folder, content_sha256);
}

std::optional<std::string> Store::content_fault(const std::string& content_sha256) const {
  return store::content_fault(state_->folder, content_sha256);
}

bool Store::names_source(const std::string& sha256, const std::string& cut_key) {
  const Transaction transaction(state_->database, Transaction::Kind::read);
  return source_id(state_->database, sha256, cut_key).has_value();
}

std::optional<SourceFile> Store::find_source(const std::string& sha256,
                                             const std::string& cut_key) {
  const Transaction transaction(state_->database, Transaction::Kind::read);
  const auto id = source_id(state_->database, sha256, cut_key);
  if (!id || !has_all_content(state_->database, state_->folder, *id)) return std::nullopt;
  return read_source(state_->database, *id);
}

bool Store::commit_ingest(const SourceFile& source, std::span<const NewGranule> granules) {
  state_->expect_writable();
  expects(source.sha256.size() == 64, "a source is named by its sha256");
  Database& database = state_->database;
  const std::vector<SealedFile> sealed = seal_all(granules);

  Transaction transaction(database, Transaction::Kind::write);
  Adoption adoption(state_->folder);
  bool insert = true;
  if (const auto id = source_id(database, source.sha256, source.cut_key)) {
    if (has_all_content(database, state_->folder, *id)) {
      discard(granules);
      return false;
    }
    // Content was lost or damaged. The same bytes mend it in place; other bytes (a newer decoder)
    // make it a new source.
    insert = !replaces_content(database, *id, sealed);
    if (insert && is_input_of_a_forecast(database, *id)) {
      throw Error(
          ErrorKind::unavailable,
          source.name +
              ": content of this source is lost or damaged, and this program decodes it to other "
              "bytes than those an issued forecast was made from; restore the files from a copy "
              "(`slackwater store check` names them), or prune those forecasts first");
    }
    if (insert) delete_source(database, *id);
  }
  for (const SealedFile& file : sealed) adoption.place(file);
  adoption.sync();
  if (insert) insert_source(database, source, granules, sealed);
  adoption.keep();
  transaction.commit();
  return true;
}

std::vector<GranuleRow> Store::find_granules(const GranuleQuery& query) {
  const Transaction transaction(state_->database, Transaction::Kind::read);
  return select_granules(state_->database, query);
}

GranuleRow Store::granule(std::int64_t id) {
  const Transaction transaction(state_->database, Transaction::Kind::read);
  if (auto row = select_granule(state_->database, id)) return *row;
  throw Error(ErrorKind::not_found, "there is no granule " + std::to_string(id) + " in the store " +
                                        state_->folder.string() + "; see `slackwater store list`");
}

std::vector<SourceFile> Store::list_sources() {
  const Transaction transaction(state_->database, Transaction::Kind::read);
  return read_sources(state_->database);
}

FiledForecast Store::commit_forecast(const ForecastRow& row,
                                     const std::filesystem::path& content_file) {
  const NewForecast forecast{row, content_file};
  return commit_forecasts(std::span(&forecast, 1)).front();
}

std::vector<FiledForecast> Store::commit_forecasts(std::span<const NewForecast> forecasts) {
  state_->expect_writable();
  const std::vector<SealedFile> sealed = seal_all(forecasts);
  Transaction transaction(state_->database, Transaction::Kind::write);
  Adoption adoption(state_->folder);
  for (const SealedFile& file : sealed) adoption.place(file);
  adoption.sync();
  std::vector<FiledForecast> filed;
  for (std::size_t i = 0; i < forecasts.size(); ++i) {
    const ForecastRow& row = forecasts[i].row;
    if (const auto known = same_forecast(state_->database, row, sealed[i].sha256)) {
      filed.push_back({*known, false, sealed[i].sha256});
    } else {
      filed.push_back({insert_forecast(state_->database, row, sealed[i]), true, sealed[i].sha256});
    }
  }
  adoption.keep();
  transaction.commit();
  return filed;
}

std::vector<ForecastRow> Store::find_forecasts(const ForecastQuery& query) {
  const Transaction transaction(state_->database, Transaction::Kind::read);
  return select_forecasts(state_->database, query);
}

std::int64_t Store::record_decision(const DecisionRow& row) {
  state_->expect_writable();
  Transaction transaction(state_->database, Transaction::Kind::write);
  const std::int64_t id = insert_decision(state_->database, row);
  transaction.commit();
  return id;
}

std::vector<DecisionRow> Store::find_decisions(const DecisionQuery& query) {
  const Transaction transaction(state_->database, Transaction::Kind::read);
  return select_decisions(state_->database, query);
}

std::int64_t Store::begin_session(const std::string& name, UtcTime begun) {
  state_->expect_writable();
  Transaction transaction(state_->database, Transaction::Kind::write);
  const std::int64_t id = insert_session(state_->database, name, begun);
  transaction.commit();
  return id;
}

void Store::record_actions(std::int64_t session, std::span<const SessionAction> actions) {
  state_->expect_writable();
  Transaction transaction(state_->database, Transaction::Kind::write);
  insert_actions(state_->database, session, actions);
  transaction.commit();
}

std::vector<SessionRow> Store::list_sessions() {
  const Transaction transaction(state_->database, Transaction::Kind::read);
  return select_sessions(state_->database);
}

std::vector<SessionAction> Store::find_actions(std::int64_t session) {
  const Transaction transaction(state_->database, Transaction::Kind::read);
  return select_actions(state_->database, session);
}

PruneReport Store::prune(const PruneOptions& options) {
  state_->expect_writable();
  return prune_store(state_->database, state_->folder, options);
}

}  // namespace slackwater::store
