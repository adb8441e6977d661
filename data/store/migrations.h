#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace slackwater::store {

class Database;

/// One file of data/schema, embedded at configure time.
struct EmbeddedSql {
  std::string_view name;  ///< e.g. "002_forecasts"; the number is the `user_version` it leads to
  std::string_view sql;
};

/// All migrations, oldest first, numbered 1, 2, 3, ... without a gap.
[[nodiscard]] std::span<const EmbeddedSql> embedded_schema() noexcept;

/// The schema this program writes.
[[nodiscard]] int newest_schema_version() noexcept;

[[nodiscard]] int schema_version(Database& database);

/// Throws Error(invalid_input) where the store was written by a newer program.
void expect_known_schema(Database& database);

/// What of the schema this program writes is not as it writes it, each in words: a table, index or
/// trigger that is gone, changed, or of nobody. Of a catalogue of the newest version.
[[nodiscard]] std::vector<std::string> schema_faults(Database& database);

/// Brings the catalogue to `target`, one transaction per migration, so that an interruption leaves
/// a whole version. Safe where several processes try at once: each looks again under the write
/// lock.
void migrate(Database& database, int target = newest_schema_version());

}  // namespace slackwater::store
