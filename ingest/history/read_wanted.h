#pragma once
#include "ingest/history/beyond_belief.h"
#include "ingest/history/offer.h"
#include "ingest/history/read_history.h"

namespace slackwater::ingest {

/// What a file offers, by the names that it may be asked for.
[[nodiscard]] inline std::vector<std::string> names_offered(const std::vector<Offer>& offers,
                                                            const HistoryOptions& options) {
  std::vector<std::string> names;
  names.reserve(offers.size() + options.columns.size());
  for (const Offer& offer : offers) names.push_back(offer.standard_name);
  for (const NamedColumn& named : options.columns) names.push_back(named.column);
  return names;
}

/// Reads what is wanted, one quantity after the other, of a file that can be read so.
/// @param read  of a `Making`, with warnings to add to, the series
template <typename Read>
void read_wanted(const std::vector<std::string>& wanted, const std::vector<Offer>& offers,
                 const Vocabulary& vocabulary, const Read& read, HistoryOfFile& answer) {
  answer.warnings = made_apart(wanted, offers, vocabulary);
  for (const std::string& name : wanted) {
    const auto making = making_of(name, offers, vocabulary);
    if (!making) {
      answer.series.emplace_back();
      continue;
    }
    HistorySeries series = read(*making, answer.warnings);
    const std::string told = reject_beyond_belief(series, vocabulary);
    if (!told.empty()) answer.warnings.push_back(told);
    answer.series.push_back(std::move(series));
  }
}

}  // namespace slackwater::ingest
