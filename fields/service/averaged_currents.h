#pragma once
#include <optional>
#include <string>

#include "fields/base/time.h"

namespace slackwater {

/// What is missing from a forecast whose currents were fitted to means over hours
/// (`shortest_tideless_mean` and more): most of the tide.
struct AveragedCurrents {
  Duration averaging{0};  ///< of the means
  /// Some of the tide passes through means of few hours and is forecast.
  bool holds_part_of_the_tide = false;
  /// Standard deviation of a component, m/s, at its largest, of the tide that is not in the
  /// forecast; its band is widened by it. Nothing: no record of the tide was there, the band knows
  /// nothing of it.
  std::optional<double> unresolved_tide_m_s;
  std::string tidal_record;  ///< the product or station that told of the tide; empty: none
  bool operator==(const AveragedCurrents&) const = default;
};

/// "the currents are daily means: the tide is not in them and nothing here says how large it is".
[[nodiscard]] std::string sentence_of(const AveragedCurrents& averaged);

}  // namespace slackwater
