#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "fields/base/error.h"
#include "fields/base/time.h"

struct sqlite3;
struct sqlite3_stmt;

namespace slackwater::store {

/// How errors speak of a database, and what they advise. The texts are literals.
struct DatabaseWords {
  std::string_view name = "the catalogue";
  std::string_view when_full = "nothing was stored; free some space and run the command again";
  std::string_view when_locked = "wait until that process is done and run the command again";
  std::string_view when_not_writable =
      "give write permission on the store's folder, or choose another --store";
  std::string_view when_failing = "check the disk, then run `slackwater store check`";
  std::string_view when_damaged = "run `slackwater store check` to see what can be saved";
};

/// A prepared statement: bind (positions from 1), step, read columns (from 0). Errors of SQLite are
/// `Error`s that carry the file's path, SQLite's own text and what to do. Must not outlive its
/// Database.
class Statement {
 public:
  Statement& bind(int position, std::int64_t value);
  Statement& bind(int position, double value);
  Statement& bind(int position, std::string_view value);
  Statement& bind(int position, UtcTime value);  ///< as milliseconds since 1970
  /// Not copied: the bytes stay where they are until the statement was run or reset.
  Statement& bind_bytes(int position, std::span<const std::uint8_t> value);
  Statement& bind_null(int position);
  template <typename T>
  Statement& bind(int position, const std::optional<T>& value) {
    return value ? bind(position, *value) : bind_null(position);
  }
  /// Binds positions 1, 2, 3, ...
  template <typename... T>
  Statement& bind_all(const T&... values) {
    int position = 0;
    (bind(++position, values), ...);
    return *this;
  }

  /// Advances; false where there is no further row.
  bool step();
  /// Steps to the end and makes ready for the next bindings.
  void run();
  void reset();

  [[nodiscard]] bool is_null(int column) const;
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] double real(int column) const;
  /// Each byte that is no UTF-8 is U+FFFD.
  [[nodiscard]] std::string text(int column) const;
  /// A text of at most `longest_name_bytes` (rows.h).
  [[nodiscard]] std::string name(int column) const;
  /// A SHA-256, as the names of content files have it: 64 hexadecimal digits in lower case.
  [[nodiscard]] std::string checksum(int column) const;
  /// A name that `parse` makes something of, and that is damaged where it throws an Error.
  template <typename Parse>
  [[nodiscard]] auto parsed(int column, const Parse& parse) const {
    const std::string found = name(column);
    try {
      return parse(found);
    } catch (const Error& problem) {
      refuse(column, "'" + found.substr(0, 80) + "'", problem.message());
    }
  }
  [[nodiscard]] UtcTime time(int column) const;
  /// Good until the next step.
  [[nodiscard]] std::span<const std::uint8_t> bytes(int column) const;
  [[nodiscard]] std::optional<std::int64_t> optional_integer(int column) const;
  [[nodiscard]] std::optional<double> optional_real(int column) const;
  [[nodiscard]] std::optional<UtcTime> optional_time(int column) const;

 private:
  friend class Database;
  struct Finalise {
    void operator()(sqlite3_stmt* statement) const noexcept;
  };
  Statement(class Database& database, sqlite3_stmt* statement)
      : database_(&database), statement_(statement) {}
  void check(int code) const;
  /// The value of a column is not what this program writes.
  [[noreturn]] void refuse(int column, std::string_view found, std::string_view expected) const;

  class Database* database_;
  std::unique_ptr<sqlite3_stmt, Finalise> statement_;
};

/// The one door to SQLite: a connection to a database. One thread at a time.
class Database {
 public:
  enum class Access {
    write,              ///< made where absent; WAL is switched on by the caller
    read,               ///< shares with writers; may need to make the -shm file
    read_orphaned_wal,  ///< nobody can write and the -shm is gone: the WAL is read without shared
                        ///< memory
  };
  [[nodiscard]] static Database open(const std::filesystem::path& file, Access access,
                                     const DatabaseWords& words = {});
  /// A private copy in memory of a catalogue without WAL, for file systems where readers cannot
  /// share memory.
  [[nodiscard]] static Database open_copy(const std::filesystem::path& file,
                                          std::string_view bytes);

  [[nodiscard]] Statement prepare(std::string_view sql);
  /// One in memory, empty.
  [[nodiscard]] static Database in_memory();

  /// Runs one or several statements that return nothing of interest.
  void execute(const std::string& sql);
  [[nodiscard]] std::int64_t last_inserted_id() const;
  /// From now on the connection's statements do no more than so many operations of SQLite's machine
  /// together: whoever asks for more has a file whose pages go round in circles.
  /// @throws Error(invalid_input), from the statement that goes on
  void bound_work(std::uint64_t operations);
  /// Closing this connection leaves the write-ahead log where it is.
  void leave_log() noexcept;
  [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }
  /// Throws the `Error` that belongs to a result code of SQLite.
  [[noreturn]] void fail(int code) const;
  /// Its bytes can be read, and say what this program does not write. @throws Error(invalid_input)
  [[noreturn]] void refuse(const std::string& found) const;

 private:
  friend class Transaction;
  struct Close {
    void operator()(sqlite3* connection) const noexcept;
  };
  Database(std::filesystem::path file, sqlite3* connection, const DatabaseWords& words);

  std::filesystem::path file_;
  DatabaseWords words_;
  /// What is left of the work allowed; at a place of its own, as SQLite is told where it is.
  std::unique_ptr<std::uint64_t> work_left_;
  std::unique_ptr<sqlite3, Close> connection_;
};

/// Rolls back unless committed.
class Transaction {
 public:
  enum class Kind {
    read,   ///< one consistent state for several queries
    write,  ///< takes the write lock at once (BEGIN IMMEDIATE), waiting up to the busy timeout
  };
  Transaction(Database& database, Kind kind);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database* database_;
};

}  // namespace slackwater::store
