#pragma once
#include <optional>
#include <string>
#include <vector>

#include "api/ask/history/history.h"
#include "twin/climate/extremes.h"
#include "twin/climate/known_months.h"
#include "twin/climate/rose.h"
#include "twin/climate/scatter.h"

namespace slackwater::api {

/// What has classes; `period` (of the peak of the waves) in scatter tables alone.
enum class ClimateOf { wind, waves, current, period };

/// What one of them is in files, and how it is divided where nobody says.
struct ClimateKind {
  ClimateOf of;
  std::string word;            ///< as users write it: "wind"
  std::string size_name;       ///< CF: of its speed, height or period
  std::string direction_name;  ///< CF; empty: it has none
  std::string way;             ///< "from", or "to"
  std::string unit;            ///< canonical, of the size
  double calm = 0;
  std::vector<double> edges;  ///< of the classes of its rose
};
[[nodiscard]] const ClimateKind& kind_of(ClimateOf of);

/// Numbers that a user states of one of them.
struct ClimateNumbers {
  ClimateOf of = ClimateOf::wind;
  std::vector<double> values;
  std::string unit;  ///< the canonical one where nobody says
};
/// Reads "wind=4,8,12 kt": numbers that ascend from 0 on, the unit perhaps left out.
/// @throws Error(invalid_input) for anything else
[[nodiscard]] ClimateNumbers parse_climate_numbers(const std::string& text);
/// The same with one number alone: "waves=4 m".
[[nodiscard]] ClimateNumbers parse_climate_number(const std::string& text);
/// Reads "wind", "waves", "current". @throws Error(invalid_input) for others
[[nodiscard]] ClimateOf parse_climate_of(const std::string& text);

/// What is asked of the climate of a place.
struct ClimateQuestion {
  bool roses = true;
  bool scatter = true;
  bool extremes = true;
  std::vector<ClimateOf> of{ClimateOf::wind, ClimateOf::waves, ClimateOf::current};
  std::size_t sectors = 12;
  std::vector<ClimateNumbers> classes;
  std::vector<ClimateNumbers> calms;
  std::vector<ClimateNumbers> thresholds;
  Duration separation = std::chrono::hours(48);
  twin::ExtremesQuestion storms;  ///< thresholds, separation and steps are those above
};

// Return periods that may be asked for, years.
inline constexpr double least_return_years = 0.1;
inline constexpr double most_return_years = 10000;
/// Ascending, each once.
[[nodiscard]] std::vector<double> return_periods(std::vector<double> years);

/// The variables that it takes, each if it is there.
[[nodiscard]] WantedSeries wanted_by(const ClimateQuestion& question);

/// Edges as they were asked for, in their unit.
struct ClimateEdges {
  std::vector<double> values;
  std::string unit;
};

struct ClimateRose {
  std::size_t direction = 0;  ///< in the history's series
  ClimateEdges edges;
  ClimateEdges calm;  ///< one number
  twin::Rose counts;
};

/// How a size is spread.
struct ClimateSpread {
  double mean = 0;
  double p50 = 0;
  double p90 = 0;
  double p99 = 0;
  double greatest = 0;
  std::size_t greatest_step = 0;
};

/// The climate of wind, waves or current.
struct ClimatePart {
  ClimateOf of = ClimateOf::wind;
  std::size_t series = 0;   ///< of its size, in the history's
  twin::KnownMonths known;  ///< steps whose size is known
  ClimateSpread spread;     ///< in the canonical unit, as the extremes
  std::optional<ClimateRose> rose;
  std::optional<twin::Extremes> extremes;
};

/// Heights of waves by peak period, or by the sector they come from.
struct ClimateScatter {
  ClimateEdges heights;
  ClimateEdges periods;  ///< of no value where it is by sector
  std::size_t sectors = 0;
  twin::Scatter counts;
};

struct ClimateAnswer {
  std::vector<ClimatePart> parts;
  std::optional<ClimateScatter> by_period;
  std::optional<ClimateScatter> by_sector;
  std::vector<std::string> notes;  ///< what a reader should know beside the history's
};

/// @throws Error(invalid_input) for units that do not convert, and classes that begin within calms;
///         Error(not_found) where the history has nothing of what is asked
[[nodiscard]] ClimateAnswer answer_of(const History& history, const ClimateQuestion& question,
                                      const ingest::Vocabulary& vocabulary);

}  // namespace slackwater::api
