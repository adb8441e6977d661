#pragma once
#include <optional>
#include <string>
#include <vector>

#include "calibration/day/forecast_plan.h"
#include "calibration/day/instruments.h"
#include "fields/record/choose.h"
#include "fields/record/site_data.h"

namespace slackwater::calibration {

/// The currents of a column up to the end of D as known then, on the levels and times of the plan's
/// dataset: what a day is calibrated on.
///
/// Where in-situ series stand near a product (within 10 km), it is fused with them by their errors
/// (calibration/fuse/fusion.h), the nearest first, the next by what error is left then; so the day
/// and the history that calibration sees are those of the site. A series that lies, or that ended
/// long before, is left out (calibration/fuse/instrument_check.h). Where the plan's dataset is a
/// series itself and a coarser product covers D too, that product is the background; without one
/// the series stands alone. What the instruments' noise makes of each value is said beside it
/// (`Chosen::noise_m_s`): of a series that stands alone where its files state an error.
[[nodiscard]] Chosen<Horizontal> known_currents(const ColumnData& column, const ForecastPlan& plan);

/// What an operator should know about a record, and which instruments lie, of those that were still
/// sending at the end of D.
struct RecordRemarks {
  std::vector<std::string> notes;
  std::vector<InstrumentTrouble> troubles;
};

/// Of that record: "fused with station X at 2.1 km", "station Y at
/// 3.4 km is not used: it ended 12.0 days before", "currents of station X at 0.4 km alone, no
/// product"; empty for a product alone. Instruments are judged for it, nothing is fused.
[[nodiscard]] RecordRemarks remarks_on_record(const ColumnData& column, const ForecastPlan& plan);

/// The dataset that leads on a day: `leading_dataset`, but a series that contradicts the product
/// beside it does not lead.
[[nodiscard]] std::optional<std::string> trusted_dataset(const ColumnData& column, UtcDay day,
                                                         UtcTime issued,
                                                         UtcTime seen_by = UtcTime::max());

}  // namespace slackwater::calibration
