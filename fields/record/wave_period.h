#pragma once
#include <string>

#include "fields/record/site_data.h"

namespace slackwater {

/// The peak periods at a column, and a word on them where they are not as a product gave them.
struct WavePeriod {
  ScalarRecord peak_period;
  std::string note;  ///< empty: as given
};

/// The stored peak periods; of a dataset that has none that of its energy period (VTM10), else of
/// its zero-crossing period (VTM02, VTZA), by the relation of fields/wave/peak_period.h.
/// With wave heights and no period at all the note says that.
[[nodiscard]] WavePeriod wave_period_at(const SitePieces& pieces, const GeoPoint& point,
                                        bool has_heights);

}  // namespace slackwater
