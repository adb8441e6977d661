#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/pipeline/ingest/ingest_files.h"
#include "api/pipeline/ingest/run_apart.h"
#include "fields/base/error.h"

namespace slackwater::api {

/// `ingest_file` in a process of its own, with a connection of its own to the store: a file that
/// crashes the library that reads it, or reads for ever, or wants all memory, is one
/// Error(invalid_input) that names it, and this process reads on. A process that dies leaves the
/// store as sound as a killed command does. SQLite's log is left for the caller to bring in: open
/// and close the store once all files are read.
///
/// No connection to any store may be open here, and no thread alive, when this is called (SQLite's
/// handles do not cross a fork).
///
/// @throws what `ingest_file` throws; Error(unavailable) where the reader was ended from outside
[[nodiscard]] IngestReport ingest_file_apart(const std::filesystem::path& store_folder,
                                             const ingest::ProductCatalogue& products,
                                             const std::filesystem::path& file,
                                             const ingest::IngestOptions& options, UtcTime now,
                                             const ingest::Progress& progress);

/// What the reader of a file may use: ten minutes and a minute for each GiB of it.
[[nodiscard]] Allowance allowance_for(const std::filesystem::path& file);

/// What a reader answers of a file that it refuses: an error, told across processes.
[[nodiscard]] nlohmann::json problem_json(ErrorKind kind, const std::string& message);

/// The error of a reader that did not answer.
[[nodiscard]] Error error_of(const Apart& apart, const std::filesystem::path& file,
                             const Allowance& allowance);

}  // namespace slackwater::api
