#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "api/pipeline/fetch/wanted_files.h"

namespace slackwater::api {

/// What is known of a file that was fetched: the note beside it.
struct FetchNote {
  std::string asked;  ///< what was asked for, as one text
  std::string from;   ///< its first time, "2025-03-06T00:00:00Z"; empty: it has none
  UtcTime fetched_at{};
  std::uintmax_t bytes = 0;
  std::string lacks;  ///< what it had less than was asked for
  bool operator==(const FetchNote&) const = default;
};

/// The same for the same dataset, place, variables and times.
[[nodiscard]] std::string asked_text(const WantedFile& wanted);

/// Nothing where there is none, it cannot be read, or the file is another one by now.
[[nodiscard]] std::optional<FetchNote> note_of(const std::filesystem::path& file);
void write_note(const std::filesystem::path& file, const FetchNote& note);

/// When a product's next run is expected to be out: by its descriptor (`published_after`, every
/// day), of the GFS by its runs. Nothing: nobody says.
[[nodiscard]] std::optional<UtcTime> next_out(const WantedFile& wanted,
                                              const ingest::ProductCatalogue& products,
                                              UtcTime now);

}  // namespace slackwater::api
