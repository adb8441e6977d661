#include "ingest/history/beyond_belief.h"

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/cf/units.h"

namespace slackwater::ingest {

std::string reject_beyond_belief(HistorySeries& series, const Vocabulary& vocabulary) {
  const Quantity* quantity = vocabulary.by_standard_name(series.standard_name);
  if (quantity == nullptr) return {};
  const UnitConversion unit = unit_conversion(
      series.unit, quantity->unit, "column '" + series.name + "' (" + series.standard_name + ")");
  std::size_t values = 0;
  std::size_t rejected = 0;
  double example = 0;
  UtcTime when{};
  for (std::size_t t = 0; t < series.value.size(); ++t) {
    double& value = series.value[t];
    if (std::isnan(value)) continue;
    ++values;
    const double canonical = unit.scale * value + unit.offset;
    if (canonical >= quantity->gross.low && canonical <= quantity->gross.high) continue;
    if (rejected++ == 0) {
      example = value;
      when = series.time[t];
    }
    value = constants::nan;
  }
  if (rejected == 0) return {};
  const std::string found = formatted(
      "{} of {} values of '{}' are impossible for {} in {}, the first is {:g} at {}", rejected,
      values, series.name, series.standard_name, series.unit, example, format_utc(when));
  if (10 * rejected > values)
    throw Error(ErrorKind::invalid_input,
                found + formatted("; expected {:g} to {:g} {}: correct the unit",
                                  quantity->gross.low, quantity->gross.high, quantity->unit));
  return found + "; they count as missing";
}

}  // namespace slackwater::ingest
