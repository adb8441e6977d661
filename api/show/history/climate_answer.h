#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "api/ask/history/climate.h"

namespace slackwater::api {

/// For programs: api/docs/json.md has the schema.
[[nodiscard]] nlohmann::json climate_json(const History& history, const ClimateQuestion& question,
                                          const ClimateAnswer& answer);
/// For people: tables, with the methods and their sources beside the numbers.
[[nodiscard]] std::string climate_text(const History& history, const ClimateQuestion& question,
                                       const ClimateAnswer& answer);

// By which methods, in words with their sources.
[[nodiscard]] std::string peaks_method();
[[nodiscard]] std::string gumbel_method();
[[nodiscard]] std::string extreme_value_method();
[[nodiscard]] std::string interval_method(const ClimateQuestion& question);

/// What to know of a part: of which months nothing is known, or little, and where one storm is the
/// maximum of two years.
[[nodiscard]] std::vector<std::string> part_notes(const ClimatePart& part);

/// Why there are no return values of peaks over a threshold; empty where there are.
[[nodiscard]] std::string no_peaks_text(const twin::Extremes& extremes);
/// Why there are no maxima of years, or no shape of theirs; empty where there are.
[[nodiscard]] std::string no_gumbel_text(const twin::Extremes& extremes);
[[nodiscard]] std::string no_shape_text(const twin::Extremes& extremes);

/// The middle of a sector, degrees.
[[nodiscard]] double middle_deg(std::size_t sector, std::size_t sectors) noexcept;

}  // namespace slackwater::api
