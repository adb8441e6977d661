#pragma once
#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "api/pipeline/fetch/fetcher.h"

namespace slackwater::api {

/// How a file stands after a fetch.
enum class FetchState {
  here,     ///< it was there already: fetched within three hours, or of the same run
  fetched,  ///< it came
  late,     ///< it came, or an older one is there, and its newest times are not out yet
  failed,
  none,  ///< nothing is to be fetched
};
/// "fetched": the word of tables and JSON.
[[nodiscard]] const char* name_of(FetchState state) noexcept;

/// What became of one file.
struct FetchOutcome {
  WantedFile wanted;
  FetchState state = FetchState::failed;
  std::filesystem::path file;  ///< where it lies; of one that failed an older one, or empty
  std::string by;              ///< the fetcher that it came by, or that was tried last
  int tries = 0;
  std::optional<Trouble> trouble;
  std::string why;                  ///< in words, for `late` and `failed`
  std::optional<UtcTime> next_out;  ///< when its provider is expected to have more
};

struct FetchChoice {
  std::filesystem::path folder;  ///< of the files; made where it is missing
  bool is_dry = false;           ///< says what would be done, and runs nothing
  const std::atomic<bool>* is_stop_asked = nullptr;
  /// For how long it tries in all; then what has not come has failed.
  std::chrono::seconds patience{1200};
  /// Told before each request, in words: "currents by copernicusmarine, try 2".
  std::function<void(const std::string&)> on_step{};
};

/// Fetches what a forecast at a site wants and looks into all that comes. Every file is tried once
/// before any is tried again. A file that fails leaves
/// the others alone, and an older one of its name in its place. What was fetched of the newest
/// issue is not fetched again: each file has a note beside it (`NAME.fetched.json`) of what was
/// asked for and when.
///
/// One at a time in a folder: another one that fetches into it is refused.
/// No thread may be alive and no store open (ingest/apart/decode_apart.h).
/// @throws Error(unavailable) where the folder cannot be written or another one fetches into it
[[nodiscard]] std::vector<FetchOutcome> fetch_site(const std::vector<WantedFile>& wanted,
                                                   const std::vector<Fetcher>& fetchers,
                                                   const ingest::ProductCatalogue& products,
                                                   const Site& site, UtcTime now,
                                                   const FetchChoice& choice);

}  // namespace slackwater::api
