#include "data/store/migrations.h"

#include <charconv>
#include <string>

#include "data/store/database.h"
#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::store {
namespace {

int number_of(const EmbeddedSql& migration) {
  int number = 0;
  const auto [end, problem] =
      std::from_chars(migration.name.data(), migration.name.data() + migration.name.size(), number);
  expects(problem == std::errc() && *end == '_', "a migration is named NNN_what_it_brings.sql");
  return number;
}

}  // namespace

int newest_schema_version() noexcept { return static_cast<int>(embedded_schema().size()); }

int schema_version(Database& database) {
  Statement query = database.prepare("PRAGMA user_version");
  query.step();
  return static_cast<int>(query.integer(0));
}

void expect_known_schema(Database& database) {
  const int found = schema_version(database);
  if (found > newest_schema_version() || found < 0) {
    throw Error(ErrorKind::invalid_input,
                "the store " + database.file().parent_path().string() + " has schema version " +
                    std::to_string(found) + ", this program knows versions up to " +
                    std::to_string(newest_schema_version()) +
                    "; use the newer Slackwater that wrote it, or another --store");
  }
}

void migrate(Database& database, int target) {
  expects(target <= newest_schema_version(), "no such schema version");
  for (int version = 1; version <= target; ++version) {
    const EmbeddedSql& migration = embedded_schema()[static_cast<std::size_t>(version - 1)];
    expects(number_of(migration) == version, "migrations are numbered without a gap");
    Transaction transaction(database, Transaction::Kind::write);
    expect_known_schema(database);
    if (schema_version(database) >= version) continue;
    database.execute(std::string(migration.sql));
    database.execute("PRAGMA user_version = " + std::to_string(version));
    transaction.commit();
  }
}

}  // namespace slackwater::store
