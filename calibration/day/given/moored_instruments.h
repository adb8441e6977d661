#pragma once
#include <optional>
#include <string>
#include <vector>

#include "calibration/day/given/forecast_plan.h"
#include "calibration/fuse/instrument_check.h"
#include "fields/record/choose.h"
#include "fields/record/site_data.h"

namespace slackwater::calibration {

/// An in-situ series in reach of a column, judged beside the product there.
struct MooredInstrument {
  std::string dataset;
  std::string station;
  double distance_m = 0;
  std::vector<const Origin*> origins;
  std::vector<Stretch> stretches;  ///< when it speaks
  MooredInstrumentVerdict verdict;
  std::optional<double> stated_error_m_s;  ///< of a value of one component, by its files

  [[nodiscard]] bool is_used() const { return verdict.use == MooredInstrumentUse::used; }
  [[nodiscard]] bool is_rejected() const { return verdict.use == MooredInstrumentUse::rejected; }
};

/// Something that an operator should mend: at which station, and a clause.
struct MooredInstrumentTrouble {
  std::string station;
  std::string clause;
};

/// One dataset as known at the end of D; a forecast in it may reach beyond, what is known of the
/// sea ends with D.
[[nodiscard]] Chosen<Horizontal> known_of(const ColumnData& column, const ForecastPlan& plan,
                                          const std::string& dataset);

/// The in-situ series within reach of fusion with a value up to the end of D, nearest first, each
/// judged (calibration/fuse/instrument_check.h) beside the product as known then.
[[nodiscard]] std::vector<MooredInstrument> instruments_beside(const ColumnData& column,
                                                               const ForecastPlan& plan,
                                                               const VectorColumn& product);

/// The same for series that have no product beside them: named, not judged, none is used.
[[nodiscard]] std::vector<MooredInstrument> instruments_without_product(const ColumnData& column,
                                                                        const ForecastPlan& plan);

/// What an operator should know about a record, and which instruments lie, of those that were still
/// sending at the end of D.
struct RecordRemarks {
  /// "fused with station X at 2.1 km", "station Y at 3.4 km is not used: it ended 12.0 days
  /// before", "currents of station X at 0.4 km alone, no product"; empty for a product alone.
  std::vector<std::string> notes;
  std::vector<MooredInstrumentTrouble> troubles;
};

/// Of a record on this dataset with these instruments about it.
/// @param has_product  there is one beside the series that leads
[[nodiscard]] RecordRemarks remarks_on(const std::vector<MooredInstrument>& instruments,
                                       const std::string& dataset, bool has_product);

}  // namespace slackwater::calibration
