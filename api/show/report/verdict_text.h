#pragma once
#include <string>
#include <vector>

#include "calibration/verify/skill_entry.h"
#include "calibration/verify/verdict.h"

namespace slackwater::api {

/// "Wind best, lead 0-24 h, 6 pairs of days: forecast 0.048 m/s [0.040, 0.060], best baseline
/// reference-slab 0.050 m/s; 81 % of the truth inside the 80 % band [78, 84]." Of hindcasts:
/// "6 pairs of days of hindcasts"; of few pairs: "2 pairs of days (few: no interval)".
[[nodiscard]] std::string verdict_text(const calibration::Verdict& verdict);

/// "0.048 m/s", and what it is not: "0.037 m/s against daily means, not instants: …".
[[nodiscard]] std::string error_text(const calibration::Verdict& verdict);

/// "6 pairs of days", "1 pair of days of hindcasts (few: no interval)": what a verdict rests on.
[[nodiscard]] std::string pairs_text(const calibration::Verdict& verdict);

/// "NWSHELF_ANALYSISFORECAST_PHY_004_013 (daily means, not instants)": the truth of an entry.
[[nodiscard]] std::string truth_text(const calibration::SkillEntry& entry);

/// "best", "best (in hindsight)", "forecast (simulated)": the wind of an entry.
[[nodiscard]] std::string wind_text(const calibration::SkillEntry& entry);

/// "best baseline reference-slab 0.050 m/s". Where it has some of the forecast's pairs, or some of
/// their values, only: "best baseline provider 0.050 m/s (over 4 of these pairs, there the forecast
/// has 0.047 m/s)", "(over the values that both have, there the forecast has 0.047 m/s)".
[[nodiscard]] std::string baseline_text(const calibration::Verdict& verdict);

/// Who won, in a sentence: "The forecast is better.", "A tie: the difference is within noise.",
/// "THE FORECAST DOES NOT BEAT IT."; empty where there is no baseline.
[[nodiscard]] std::string outcome_text(const calibration::Verdict& verdict);

/// The verdict under each wind policy with its outcome, a line each.
[[nodiscard]] std::string verdict_lines(const std::vector<calibration::SkillEntry>& entries);

}  // namespace slackwater::api
