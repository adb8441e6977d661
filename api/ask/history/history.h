#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "api/ask/history/series_limit.h"
#include "fields/base/local_time.h"
#include "fields/geo/geo_point.h"
#include "fields/record/regular_history.h"
#include "ingest/history/read_history.h"
#include "twin/risk/workability/workability.h"

namespace slackwater::api {

/// Where the past of a place comes from.
struct HistorySource {
  std::vector<std::filesystem::path> files;  ///< or a site of the store:
  std::string site;
  std::filesystem::path store_folder;
  ingest::HistoryOptions options;
  std::optional<GeoPoint> place;  ///< absent: the site's, or nobody's
  std::optional<UtcDay> from;     ///< this day and later ones
  std::optional<UtcDay> to;       ///< this day and earlier ones
};

/// The past of a place, as far as limits ask for it, on regular steps.
struct History {
  std::optional<GeoPoint> place;      ///< where it is, as far as anybody said
  std::string source;                 ///< in words: files, or the site
  std::vector<std::string> wanted;    ///< the variables of the limits, each once
  std::vector<HistorySeries> series;  ///< one for each; their times and values are laid out
  RegularHistory regular;             ///< in `regular`, and left empty in `series`
  std::vector<std::string> notes;     ///< what a reader should know
};

/// Which variables are read: standard names, or names of columns.
struct WantedSeries {
  std::vector<std::string> needed;
  std::vector<std::string> if_there;  ///< in the history where somebody has them
};

/// Reads variables. Several files are joined: other variables beside each other, other times of one
/// variable one after the other. Files are read in processes of their own, since NetCDF's library
/// may crash on a damaged one.
/// @throws Error(not_found) where no file, or not the store, has a variable that is needed, or any
///         at all, naming those that there are; what `read_history` throws; Error(invalid_input)
///         for times that two files both have, and for variables that share no steps
[[nodiscard]] History load_history(const HistorySource& source, const WantedSeries& wanted,
                                   const ingest::Vocabulary& vocabulary);

/// The place of a variable in `wanted` and `series`; nothing where the history has none.
[[nodiscard]] std::optional<std::size_t> place_of(const std::string& name, const History& history);

/// Values of a variable in a unit, one a step; empty where the history has none.
[[nodiscard]] std::vector<double> values_in(const std::string& unit, const std::string& name,
                                            const History& history);

/// Reads the variables of some limits.
/// @throws what `load_history` of variables does
[[nodiscard]] History load_history(const HistorySource& source,
                                   const std::vector<SeriesLimit>& limits,
                                   const ingest::Vocabulary& vocabulary);

/// How one limit fares over a history.
struct LimitShare {
  std::size_t holds = 0;        ///< steps at which it holds
  std::size_t stops_alone = 0;  ///< known steps at which it alone does not
};

/// A history as limits leave it.
struct LimitedHistory {
  twin::AccessHistory access;
  std::vector<LimitShare> shares;  ///< one a limit
};

/// Holds limits against a history that was loaded for them (perhaps for further ones too).
/// @param zone  whose months and years are told apart; absent: UTC
[[nodiscard]] LimitedHistory limited(const History& history, const std::vector<SeriesLimit>& limits,
                                     const ingest::Vocabulary& vocabulary,
                                     const std::optional<TimeZone>& zone);

}  // namespace slackwater::api
