#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fields/base/attempt.h"

namespace slackwater::calibration {

/// What a day's forecast is made of, in the order of the work. Each may fail by itself; the others
/// go on without it.
enum class Part {
  day,              ///< which day of currents is used
  wind,             ///< of the horizon
  waves,            ///< of the horizon
  wave_errors,      ///< of past days, which correct the heights and their band
  record,           ///< the known currents, fused where an instrument is near
  mixed_layer,      ///< what the product says of it
  tide,             ///< fitted on the record
  calibration,      ///< of day D
  propagation,      ///< of the calibrated day to the horizon
  column,           ///< one column as a whole
  rehearsal,        ///< of past days, which decides the blend and the spread
  blend,            ///< of our own forecast with the others
  unresolved_tide,  ///< that means over hours leave out, in the band
  stand_in,         ///< of another product for the one that leads, in the band
  sea_level,        ///< of the horizon
};

/// A name as in JSON: "waves".
[[nodiscard]] std::string_view name_of(Part part) noexcept;
/// Whether a column without this part has no current; `calibration_problem` then says why.
[[nodiscard]] bool loses_the_current(Part part) noexcept;

struct PartFailure {
  Part part = Part::column;
  Failure failure;
};

/// Runs one part; where it fails it is added to the failures.
/// @return whether it was done
bool attempt_part(Part part, std::vector<PartFailure>& failures, const std::function<void()>& work);

/// What a headline says of a part that failed: "the waves failed at 2 of 3 columns, none are
/// forecast there: WHY".
/// @param columns  at how many it failed; of a part that is made once for all: as many as there are
[[nodiscard]] std::string failure_text(const PartFailure& first, std::size_t columns,
                                       std::size_t of_columns);

}  // namespace slackwater::calibration
