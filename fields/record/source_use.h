#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/record/stretch.h"

namespace slackwater {

/// What a reader is told of where a stretch of one quantity comes from.
struct SourceUse {
  std::string quantity;     ///< "current", "wind", "waves", "mixed layer"
  std::string product;      ///< its id, or "station X"
  std::string run;          ///< "analysis", "observation", "forecast of 2024-06-11T00:00:00Z"
  std::size_t members = 0;  ///< of the ensemble whose mean it is; 0: none
  std::optional<double> from_height_m;  ///< of a wind that was brought to 10 m from there
  double distance_m = 0;                ///< of an instrument; 0 for grids
  UtcTime from{};
  UtcTime to{};
  std::string why;
  std::size_t revised_times = 0;  ///< Stretch::revised_times, of the whole stretch
  bool may_be_revised = false;    ///< Stretch::may_be_revised
};

/// The stretches that reach into [from, to], told of one quantity.
[[nodiscard]] std::vector<SourceUse> uses_of(const std::string& quantity,
                                             const std::vector<Stretch>& stretches, UtcTime from,
                                             UtcTime to);

/// "wind: ECMWF, forecast of …, mean of 50 members, brought from 100 m, FROM to TO: why".
[[nodiscard]] std::string text_of(const SourceUse& use);

}  // namespace slackwater
