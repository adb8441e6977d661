#include "data/store/database.h"

#include <sqlite3.h>

#include <cerrno>
#include <cstring>

#include "data/store/rows.h"
#include "fields/base/check.h"
#include "fields/base/encode/utf8.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::store {
namespace {

/// Long enough for another process to finish a commit on a slow disk.
constexpr int busy_timeout_ms = 30'000;

constexpr int operations_at_a_time = 1000;

int take_work(void* left_of_all) {
  auto& left = *static_cast<std::uint64_t*>(left_of_all);
  if (left < operations_at_a_time) return 1;  // ends the statement
  left -= operations_at_a_time;
  return 0;
}

Error error_of(int code, const std::filesystem::path& file, const DatabaseWords& words,
               const std::string& text, int system_errno) {
  const std::string found = std::string(words.name) + " " + file.string() + ": ";
  // SQLite keeps the errno of its last failed system call, which belongs to these two codes only.
  const bool from_system = (code & 0xff) == SQLITE_IOERR || (code & 0xff) == SQLITE_CANTOPEN;
  const std::string cause =
      from_system && system_errno != 0 ? text + " (" + std::strerror(system_errno) + ")" : text;
  const auto advised = [&](ErrorKind kind, const std::string& what, std::string_view advice) {
    return Error(kind, found + what + "; " + std::string(advice));
  };
  switch (code & 0xff) {
    case SQLITE_FULL:
      return advised(ErrorKind::unavailable, "no space left on the disk", words.when_full);
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return advised(
          ErrorKind::unavailable,
          "another process kept it locked for " + std::to_string(busy_timeout_ms / 1000) + " s",
          words.when_locked);
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_AUTH:
      return advised(ErrorKind::unavailable, "cannot be written: " + cause,
                     words.when_not_writable);
    case SQLITE_CANTOPEN:
      return advised(ErrorKind::unavailable, "cannot be opened: " + cause,
                     "check that the folder is there, that you may read and write in it, and that "
                     "its disk is not full");
    case SQLITE_IOERR:
      if (system_errno == ENOSPC || system_errno == EDQUOT)
        return advised(ErrorKind::unavailable, "no space left on the disk", words.when_full);
      return advised(ErrorKind::unavailable, "reading or writing failed: " + cause,
                     words.when_failing);
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT:
    // A table or column that is gone, a value that its own rules forbid.
    case SQLITE_ERROR:
    case SQLITE_CONSTRAINT:
    case SQLITE_MISMATCH:
    case SQLITE_TOOBIG:
      return advised(ErrorKind::invalid_input, "is damaged: " + cause, words.when_damaged);
    case SQLITE_INTERRUPT:
      return advised(ErrorKind::invalid_input,
                     "is damaged: reading it takes more work than a file of its size can ask for",
                     words.when_damaged);
    case SQLITE_NOMEM:
      return Error(ErrorKind::unavailable, found + "out of memory");
    default:
      return Error(ErrorKind::internal, found + text);
  }
}

sqlite3* open_connection(const std::filesystem::path& file, int flags, const char* vfs,
                         const DatabaseWords& words) {
  sqlite3* connection = nullptr;
  // Extended codes and no mutex: a Database belongs to one thread at a time.
  const int code = sqlite3_open_v2(file.c_str(), &connection,
                                   flags | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_EXRESCODE, vfs);
  if (code != SQLITE_OK) {
    const std::string text =
        connection != nullptr ? sqlite3_errmsg(connection) : sqlite3_errstr(code);
    const int system_errno = connection != nullptr ? sqlite3_system_errno(connection) : 0;
    sqlite3_close(connection);
    throw error_of(code, file, words, text, system_errno);
  }
  sqlite3_busy_timeout(connection, busy_timeout_ms);
  return connection;
}

}  // namespace

void Statement::Finalise::operator()(sqlite3_stmt* statement) const noexcept {
  sqlite3_finalize(statement);
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) database_->fail(code);
}

Statement& Statement::bind(int position, std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), position, value));
  return *this;
}
Statement& Statement::bind(int position, double value) {
  check(sqlite3_bind_double(statement_.get(), position, value));
  return *this;
}
Statement& Statement::bind(int position, std::string_view value) {
  // An empty view may have no data, which SQLite would take for NULL.
  check(sqlite3_bind_text64(statement_.get(), position, value.empty() ? "" : value.data(),
                            value.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
  return *this;
}
Statement& Statement::bind(int position, UtcTime value) {
  return bind(position, static_cast<std::int64_t>(value.time_since_epoch().count()));
}
Statement& Statement::bind_bytes(int position, std::span<const std::uint8_t> value) {
  // No data would be NULL.
  const void* data = value.empty() ? static_cast<const void*>("") : value.data();
  check(sqlite3_bind_blob64(statement_.get(), position, data, value.size(), SQLITE_STATIC));
  return *this;
}
Statement& Statement::bind_null(int position) {
  check(sqlite3_bind_null(statement_.get(), position));
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) database_->fail(code);
  return false;
}
void Statement::run() {
  while (step()) {
  }
  reset();
}
void Statement::reset() {
  sqlite3_reset(statement_.get());
  sqlite3_clear_bindings(statement_.get());
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}
std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}
double Statement::real(int column) const { return sqlite3_column_double(statement_.get(), column); }
std::string Statement::text(int column) const {
  const unsigned char* text = sqlite3_column_text(statement_.get(), column);
  const int bytes = sqlite3_column_bytes(statement_.get(), column);
  if (text == nullptr) return {};
  return as_utf8({reinterpret_cast<const char*>(text), static_cast<std::size_t>(bytes)});
}
std::string Statement::name(int column) const {
  // Before it is made UTF-8, as it was measured when it was stored.
  const std::string found = text(column);
  const auto bytes = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  if (bytes > longest_name_bytes)
    refuse(column, std::to_string(bytes) + " bytes",
           formatted("a name has at most {}", longest_name_bytes));
  return found;
}
std::string Statement::checksum(int column) const {
  std::string found = text(column);
  const bool is_one =
      found.size() == 64 && found.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!is_one) refuse(column, "'" + found.substr(0, 80) + "'", "expected a checksum (SHA-256)");
  return found;
}
void Statement::refuse(int column, std::string_view found, std::string_view expected) const {
  const char* const name = sqlite3_column_name(statement_.get(), column);
  database_->refuse(
      formatted("the column {} holds {}: {}", name == nullptr ? "" : name, found, expected));
}
std::span<const std::uint8_t> Statement::bytes(int column) const {
  const void* data = sqlite3_column_blob(statement_.get(), column);
  const int size = sqlite3_column_bytes(statement_.get(), column);
  // A value that could not be had for want of memory has no data and may claim a size.
  if (data == nullptr) return {};
  return {static_cast<const std::uint8_t*>(data), static_cast<std::size_t>(size)};
}
UtcTime Statement::time(int column) const { return UtcTime(Duration(integer(column))); }
std::optional<std::int64_t> Statement::optional_integer(int column) const {
  return is_null(column) ? std::nullopt : std::optional(integer(column));
}
std::optional<double> Statement::optional_real(int column) const {
  return is_null(column) ? std::nullopt : std::optional(real(column));
}
std::optional<UtcTime> Statement::optional_time(int column) const {
  return is_null(column) ? std::nullopt : std::optional(time(column));
}

void Database::Close::operator()(sqlite3* connection) const noexcept { sqlite3_close(connection); }

Database::Database(std::filesystem::path file, sqlite3* connection, const DatabaseWords& words)
    : file_(std::move(file)), words_(words), connection_(connection) {}

Database Database::open(const std::filesystem::path& file, Access access,
                        const DatabaseWords& words) {
  if (access == Access::write) {
    Database database(
        file, open_connection(file, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr, words),
        words);
    database.execute("PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON;");
    return database;
  }
  if (access == Access::read)
    return {file, open_connection(file, SQLITE_OPEN_READONLY, nullptr, words), words};
  // Without locks and in exclusive mode SQLite keeps the index of the WAL on its own heap.
  Database database(file, open_connection(file, SQLITE_OPEN_READONLY, "unix-none", words), words);
  database.execute("PRAGMA locking_mode = EXCLUSIVE");
  return database;
}

Database Database::open_copy(const std::filesystem::path& file, std::string_view bytes) {
  Database database(file, open_connection(":memory:", SQLITE_OPEN_READWRITE, nullptr, {}), {});
  auto* copy = static_cast<unsigned char*>(sqlite3_malloc64(bytes.size() + 1));
  if (copy == nullptr) database.fail(SQLITE_NOMEM);
  std::memcpy(copy, bytes.data(), bytes.size());
  // Bytes 18 and 19 of the header say WAL (2); a copy in memory has none, so it says rollback (1).
  // SQLite file format, section 1.3.3.
  if (bytes.size() >= 20) copy[18] = copy[19] = 1;
  const int code = sqlite3_deserialize(
      database.connection_.get(), "main", copy, static_cast<sqlite3_int64>(bytes.size()),
      static_cast<sqlite3_int64>(bytes.size()),
      SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_READONLY);
  if (code != SQLITE_OK) database.fail(code);
  return database;
}

Database Database::in_memory() {
  return {":memory:", open_connection(":memory:", SQLITE_OPEN_READWRITE, nullptr, {}), {}};
}

void Database::bound_work(std::uint64_t operations) {
  if (!work_left_) work_left_ = std::make_unique<std::uint64_t>();
  *work_left_ = operations;
  sqlite3_progress_handler(connection_.get(), operations_at_a_time, take_work, work_left_.get());
}

void Database::leave_log() noexcept {
  // Where it cannot be had, closing takes longer and does no harm.
  sqlite3_db_config(connection_.get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
}

Statement Database::prepare(std::string_view sql) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(connection_.get(), sql.data(), static_cast<int>(sql.size()),
                                      &statement, nullptr);
  if (code != SQLITE_OK) fail(code);
  return {*this, statement};
}

void Database::execute(const std::string& sql) {
  const int code = sqlite3_exec(connection_.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(code);
}

std::int64_t Database::last_inserted_id() const {
  return sqlite3_last_insert_rowid(connection_.get());
}

void Database::fail(int code) const {
  throw error_of(code, file_, words_, sqlite3_errmsg(connection_.get()),
                 sqlite3_system_errno(connection_.get()));
}

void Database::refuse(const std::string& found) const {
  throw error_of(SQLITE_CORRUPT, file_, words_, found, 0);
}

Transaction::Transaction(Database& database, Kind kind) : database_(&database) {
  database.execute(kind == Kind::write ? "BEGIN IMMEDIATE" : "BEGIN");
}

Transaction::~Transaction() {
  sqlite3* connection = database_->connection_.get();
  // After some failures SQLite has rolled back by itself.
  if (sqlite3_get_autocommit(connection) == 0) {
    sqlite3_exec(connection, "ROLLBACK", nullptr, nullptr, nullptr);
  }
}

void Transaction::commit() { database_->execute("COMMIT"); }

}  // namespace slackwater::store
