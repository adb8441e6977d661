#include "data/store/open_catalogue.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include "data/store/durable.h"
#include "data/store/layout.h"
#include "data/store/migrations.h"
#include "fields/base/error.h"

namespace slackwater::store {
namespace {

std::uintmax_t size_of(const std::filesystem::path& file) {
  std::error_code problem;
  const std::uintmax_t size = std::filesystem::file_size(file, problem);
  return problem ? 0 : size;
}

/// 0: there is none, or it is empty. @throws Error(unavailable) where nobody may tell us
std::uintmax_t size_of_catalogue(const std::filesystem::path& folder) {
  const std::filesystem::path file = catalogue_file(folder);
  std::error_code problem;
  const std::uintmax_t size = std::filesystem::file_size(file, problem);
  if (!problem) return size;
  if (problem == std::errc::no_such_file_or_directory || problem == std::errc::not_a_directory)
    return 0;
  throw Error(ErrorKind::unavailable, "the catalogue " + file.string() +
                                          " cannot be looked at: " + problem.message() +
                                          "; check the path and its permissions");
}

bool holds_content(const std::filesystem::path& folder) {
  std::error_code problem;
  const std::filesystem::directory_iterator first(files_folder(folder), problem);
  return !problem && first != std::filesystem::directory_iterator();
}

Error lost_catalogue(const std::filesystem::path& folder) {
  return Error(
      ErrorKind::invalid_input,
      "the catalogue " + catalogue_file(folder).string() +
          " is missing or empty though the store holds content files; restore it from a copy, or "
          "move the folder aside and ingest again; `slackwater store check` says more");
}

std::filesystem::path wal_of(const std::filesystem::path& folder) {
  return catalogue_file(folder).string() + "-wal";
}

/// A WAL with nothing in it but (part of) its 32-byte header holds no transaction.
bool has_wal(const std::filesystem::path& folder) { return size_of(wal_of(folder)) > 32; }

/// A rollback journal exists only while a new catalogue is turned to WAL; rolling it back takes a
/// writer.
bool was_being_made(const std::filesystem::path& folder) {
  std::error_code ignored;
  return std::filesystem::exists(catalogue_file(folder).string() + "-journal", ignored);
}

/// Whether this process cannot make a file here.
bool is_closed_to_us(const std::filesystem::path& folder) {
  return ::faccessat(AT_FDCWD, folder.c_str(), W_OK, AT_EACCESS) != 0;
}

/// No room for the index (32 KiB) that readers and writers of a WAL share.
bool is_full(const std::filesystem::path& folder) {
  std::error_code problem;
  const auto disk = std::filesystem::space(folder, problem);
  return !problem && disk.available < (std::uintmax_t{64} << 10);
}

bool is_current(Database& database) {
  expect_known_schema(database);
  return schema_version(database) == newest_schema_version();
}

/// The bytes of the catalogue with no writer in between: no WAL and the same file before and after.
Database open_copy(const std::filesystem::path& folder) {
  const std::filesystem::path file = catalogue_file(folder);
  for (int attempt = 0; attempt < 10; ++attempt) {
    std::error_code problem;
    const auto before = std::filesystem::last_write_time(file, problem);
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    if (!stream.eof() && !stream.good()) break;
    if (!has_wal(folder) && bytes.size() == size_of(file) &&
        before == std::filesystem::last_write_time(file, problem)) {
      return Database::open_copy(file, bytes);
    }
  }
  throw Error(ErrorKind::unavailable,
              "the catalogue " + file.string() +
                  " is being written while this process may not share it; try again, or give write "
                  "permission on the store's folder");
}

Database open_shared(const std::filesystem::path& folder) {
  Database database = Database::open(catalogue_file(folder), Database::Access::read);
  static_cast<void>(
      schema_version(database));  // the first look at the file finds what is wrong with it
  return database;
}

Database open_readable(const std::filesystem::path& folder) {
  try {
    return open_shared(folder);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::unavailable) throw;
    if (!is_closed_to_us(folder)) {
      if (is_full(folder) && !has_wal(folder) && !was_being_made(folder)) return open_copy(folder);
      if (!was_being_made(folder)) throw;
      static_cast<void>(open_catalogue_for_writing(folder));
      return open_shared(folder);
    }
  }
  if (!has_wal(folder)) return open_copy(folder);
  return Database::open(catalogue_file(folder), Database::Access::read_orphaned_wal);
}

}  // namespace

Database open_catalogue_for_writing(const std::filesystem::path& folder) {
  const std::filesystem::path file = catalogue_file(folder);
  std::error_code ignored;
  if (std::filesystem::is_directory(folder, ignored) && is_closed_to_us(folder)) {
    const int reason = errno;
    throw Error(ErrorKind::unavailable,
                "the store " + folder.string() + " cannot be written: " + std::strerror(reason) +
                    "; give write permission on its folder, or choose another --store");
  }
  if (size_of_catalogue(folder) > 0) {
    Database database = Database::open(file, Database::Access::write);
    if (is_current(database)) return database;
  }
  // Rare: a new or an old store. One process at a time, by a lock on the folder itself.
  make_folder(folder);
  const Descriptor lock(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!lock.is_open() || ::flock(lock.value(), LOCK_EX) != 0) {
    throw Error(ErrorKind::unavailable,
                "cannot lock the folder " + folder.string() +
                    "; its file system must support flock: choose another --store");
  }
  if (size_of(file) == 0 && holds_content(folder)) throw lost_catalogue(folder);
  make_folder(files_folder(folder));
  make_folder(staging_root(folder));
  Database database = Database::open(file, Database::Access::write);
  expect_known_schema(database);
  database.execute("PRAGMA journal_mode = WAL");
  // Before the schema: a store with a schema has names that survive a power cut.
  sync_folder(folder);
  migrate(database);
  return database;
}

Database open_catalogue_for_reading(const std::filesystem::path& folder) {
  if (size_of_catalogue(folder) == 0) {
    if (holds_content(folder)) throw lost_catalogue(folder);
    throw Error(ErrorKind::not_found, "there is no store in " + folder.string() +
                                          "; run `slackwater ingest PATH... --store " +
                                          folder.string() + "` first, or name another --store");
  }
  Database database = open_readable(folder);
  if (is_current(database)) return database;
  { const Database updated = open_catalogue_for_writing(folder); }
  return open_readable(folder);
}

}  // namespace slackwater::store
