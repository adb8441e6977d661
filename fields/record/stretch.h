#pragma once
#include <cstddef>
#include <optional>
#include <string>

#include "fields/record/origin.h"

namespace slackwater {

/// The part of a chosen series for which one run of one product speaks.
struct Stretch {
  const Origin* origin = nullptr;  ///< of its first value; names the run
  UtcTime from{};                  ///< centre of its first value
  UtcTime to{};                    ///< and of its last
  std::size_t members = 0;         ///< of the ensemble whose mean it is; 0: it is no mean
  double distance_m = 0;           ///< of an instrument from the place asked about
  /// The height above the sea that a wind was brought to 10 m from.
  std::optional<double> from_height_m;
  std::string why;                ///< what put it before the others, as a clause
  std::size_t revised_times = 0;  ///< at which more than one edition is stored
  /// Some of its values were published, or came in, after the moment of knowledge, and nothing
  /// earlier is stored: what stood there then is not known.
  bool may_be_revised = false;
};

}  // namespace slackwater
