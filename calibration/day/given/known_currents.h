#pragma once
#include <optional>
#include <string>
#include <vector>

#include "calibration/day/given/forecast_plan.h"
#include "calibration/day/given/moored_instruments.h"
#include "fields/record/choose.h"
#include "fields/record/site_data.h"

namespace slackwater::calibration {

/// The currents of a column as known at the end of D, with what was thought of their instruments.
struct KnownCurrents {
  Chosen<Horizontal> record;
  RecordRemarks remarks;
  bool is_contradicted = false;  ///< a series leads, and the product beside it rejects it
};

/// The currents of a column up to the end of D as known then, on the levels and times of the plan's
/// dataset: what a day is calibrated on. Instruments are judged once, for the record and for the
/// remarks on it.
///
/// Where in-situ series stand near a product (within 10 km), it is fused with them by their errors
/// (calibration/fuse/fusion.h), the nearest first, the next by what error is left then; so the day
/// and the history that calibration sees are those of the site. A series that lies, or that ended
/// long before, is left out (calibration/fuse/instrument_check.h). Where the plan's dataset is a
/// series itself and a coarser product covers D too, that product is the background; without one
/// the series stands alone. What the instruments' noise makes of each value is said beside it
/// (`Chosen::noise_m_s`): of a series that stands alone where its files state an error.
[[nodiscard]] KnownCurrents known_currents(const ColumnData& column, const ForecastPlan& plan);

/// The currents up to the end of a day of the dataset that leads on it (`leading_dataset`); a
/// series that contradicts the product beside it does not lead.
struct TrustedCurrents {
  std::string dataset;
  Chosen<Horizontal> record;
};
/// Nothing where no dataset leads.
[[nodiscard]] std::optional<TrustedCurrents> trusted_currents(const ColumnData& column, UtcDay day,
                                                              UtcTime issued,
                                                              UtcTime seen_by = UtcTime::max());

/// Whether the record took most of a part of it from a provider's run: nothing to fit without a
/// word, and no truth of a forecast.
[[nodiscard]] bool is_of_a_forecast(const Chosen<Horizontal>& record, const VectorColumn& part);

}  // namespace slackwater::calibration
