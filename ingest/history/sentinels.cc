#include "ingest/history/sentinels.h"

#include <algorithm>
#include <cmath>

#include "fields/base/text.h"
#include "ingest/quality/sentinel.h"

namespace slackwater::ingest {

std::vector<std::string> take_as_missing(HistorySeries& series, std::span<const double> missing,
                                         const std::string& who) {
  std::vector<std::string> told;
  const auto values = static_cast<std::size_t>(std::count_if(
      series.value.begin(), series.value.end(), [](double value) { return !std::isnan(value); }));
  for (const double number : missing) {
    if (const std::size_t taken = take_number(series.value, number); taken > 0)
      told.push_back(formatted("{} of {} values ({:.1f} %) of '{}' are {:g}, missing by {}", taken,
                               values,
                               100.0 * static_cast<double>(taken) / static_cast<double>(values),
                               series.name, number, who));
  }
  return told;
}

std::vector<std::string> reject_sentinels(HistorySeries& series) {
  std::vector<std::string> told;
  for (const FoundSentinel& found : take_sentinels(series.value))
    told.push_back(found.words(series.name, series.unit));
  return told;
}

}  // namespace slackwater::ingest
