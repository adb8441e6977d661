#include "data/store/migrations.h"

#include <charconv>
#include <map>
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

using Schema = std::map<std::string, std::string>;  ///< what makes it, by kind and name

Schema schema_of(Database& database) {
  Statement query = database.prepare(
      "SELECT type || ' ' || name, coalesce(sql, '') FROM sqlite_master "
      "WHERE name NOT LIKE 'sqlite_%'");
  Schema schema;
  while (query.step()) schema[query.name(0)] = query.text(1);
  return schema;
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

std::vector<std::string> schema_faults(Database& database) {
  Database made = Database::in_memory();
  migrate(made);
  const Schema expected = schema_of(made);
  const Schema found = schema_of(database);
  std::vector<std::string> faults;
  for (const auto& [name, sql] : expected) {
    const auto one = found.find(name);
    if (one == found.end())
      faults.push_back("the " + name + " is gone");
    else if (one->second != sql)
      faults.push_back("the " + name + " is not as this program makes it");
  }
  for (const auto& [name, sql] : found)
    if (!expected.contains(name)) faults.push_back("the " + name + " is none of ours");
  return faults;
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
