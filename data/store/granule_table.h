#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "data/store/content_files.h"
#include "data/store/database.h"
#include "data/store/rows.h"

namespace slackwater::store {

/// Rows of the tables source, granule and their children. No transactions here: the caller holds
/// one.

[[nodiscard]] std::optional<std::int64_t> source_id(Database& database, const std::string& sha256,
                                                    const std::string& cut_key);
[[nodiscard]] SourceFile read_source(Database& database, std::int64_t id);
[[nodiscard]] std::vector<SourceFile> read_sources(Database& database);

/// A content file as a row names it.
struct NamedContent {
  std::string sha256;
  std::uint64_t bytes = 0;
};
[[nodiscard]] std::vector<NamedContent> contents_of_source(Database& database, std::int64_t source);
[[nodiscard]] bool is_input_of_a_forecast(Database& database, std::int64_t source);

/// `sealed[i]` is the content of `granules[i]`.
void insert_source(Database& database, const SourceFile& source,
                   std::span<const NewGranule> granules, std::span<const SealedFile> sealed);
void delete_source(Database& database, std::int64_t id);

[[nodiscard]] std::vector<GranuleRow> select_granules(Database& database,
                                                      const GranuleQuery& query);
[[nodiscard]] std::optional<GranuleRow> select_granule(Database& database, std::int64_t id);

}  // namespace slackwater::store
