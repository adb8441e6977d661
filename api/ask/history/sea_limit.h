#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "api/ask/history/history.h"

namespace slackwater::api {

/// Whether a limit is written as the path of a file.
[[nodiscard]] bool is_limit_file(const std::string& text);

/// A limit as a user writes it: "NAME<=VALUE UNIT" (`parse_series_limit`), or the path of a file,
/// FILE.yaml, with an upper bound on the height of waves that goes by their period and direction:
///
///     limits:
///       - significant_wave_height_m: {peak_period_s: [4, 8], at_most: [1.5, 1.1]}
///         heading_deg: 210              # of the bow, where the bounds go by the angle off it
///
/// as in the sheets of tasks (`twin::read_limits`). A history has no vessel: without a heading the
/// worst one counts.
/// @param folder  that a path is relative to
/// @throws Error(invalid_input), Error(not_found)
[[nodiscard]] SeriesLimit read_series_limit(const std::string& text,
                                            const std::filesystem::path& folder);

/// The series beside its height that such a limit goes by, of those that a history may lack.
[[nodiscard]] std::vector<std::string> sea_variables_of(const SeriesLimit& limit);

/// What a history does not tell such a limit, in words; empty: nothing.
[[nodiscard]] std::string unknown_sea_of(const SeriesLimit& limit, const History& history);

/// For each step the share of the bound then that the height takes up: within where it is 1 or
/// less. NaN where the height is not known.
[[nodiscard]] std::vector<double> shares_of(const SeriesLimit& limit, const History& history);

}  // namespace slackwater::api
