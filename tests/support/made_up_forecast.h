#pragma once
#include <cstddef>
#include <cstdint>

#include "fields/service/snapshot.h"

namespace slackwater::tests {

/// How large a made-up forecast is.
struct MadeUpForecast {
  std::size_t columns = 1;
  std::size_t levels = 6;
  std::size_t hours = 72;
  std::size_t members = 21;  ///< the central one among them
  std::uint64_t seed = 1;
};

/// A forecast as the daily job might issue it, with an ensemble: a tide that falls off to the bed,
/// and members that walk away from it as the lead grows (steps of 2 cm/s in three shapes over
/// depth, remembered for 20 hours), so that its numbers deflate like real ones. The last level of
/// every second column lies below the bed. For tests of containers, not of forecasts.
[[nodiscard]] Snapshot made_up_forecast(const MadeUpForecast& size);

/// Gives each of its columns the level of a semidiurnal tide of 1.5 m, 0.1 m more a column, whose
/// standard deviation grows from 0.05 m by 0.01 m a stamp.
void add_made_up_level(Snapshot& forecast);

}  // namespace slackwater::tests
