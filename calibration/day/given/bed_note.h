#pragma once
#include <optional>
#include <string>

#include "fields/record/site_data.h"

namespace slackwater::calibration {

/// Where the bed of a column and the deepest level of its currents differ by more than a depth may
/// (`depth_tolerance_m`), what that means for whoever asks: "the site says 8 m of water, the
/// currents reach 30 m there: below 8 m nothing is served", "the site says 60 m of water, the
/// currents end at 30 m there: from there to the bed those of 30 m are carried". Nothing where they
/// agree, where the currents have no levels, and where nobody but they says how deep the water is.
[[nodiscard]] std::optional<std::string> note_on_bed(const ColumnData& column,
                                                     const std::string& dataset);

}  // namespace slackwater::calibration
