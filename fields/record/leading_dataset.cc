#include "fields/record/leading_dataset.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace slackwater {
namespace {

constexpr Duration longest_leading_step = std::chrono::hours(3);
constexpr Duration shortest_leading_span = std::chrono::hours(20);  // of a day

/// What a dataset has in a span of time.
struct Presence {
  std::size_t values = 0;
  std::size_t levels = 0;
  bool in_situ = false;
  double distance_m = 0;
  std::vector<TimeCell> cells;

  [[nodiscard]] Duration span() const {
    return cells.empty() ? Duration(0) : cells.back().end - cells.front().start;
  }
  [[nodiscard]] Duration step() const {
    if (cells.size() < 2) return Duration::max();
    return (cells.back().centre() - cells.front().centre()) /
           static_cast<Duration::rep>(cells.size() - 1);
  }
};

std::map<std::string, Presence> presence_in(const VectorRecord& record, UtcTime from, UtcTime to) {
  std::map<std::string, Presence> found;
  for (const auto& piece : record.pieces) {
    Presence& presence = found[piece.origin->dataset];
    presence.levels = std::max(presence.levels, piece.column.levels());
    presence.in_situ = is_in_situ(*piece.origin);
    presence.distance_m = piece.distance_m;
    for (std::size_t t = 0; t < piece.column.times(); ++t) {
      const TimeCell& cell = piece.column.time[t];
      if (cell.end < from || cell.start > to) continue;
      const std::size_t before = presence.values;
      for (std::size_t k = 0; k < piece.column.levels(); ++k)
        presence.values += piece.column.has(t, k) ? 1 : 0;
      if (presence.values > before) presence.cells.push_back(cell);
    }
  }
  for (auto& [name, presence] : found) {
    std::vector<TimeCell>& cells = presence.cells;
    std::sort(cells.begin(), cells.end(),
              [](const TimeCell& a, const TimeCell& b) { return a.centre() < b.centre(); });
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  }
  return found;
}

using Candidate = std::pair<const std::string, Presence>;

/// Larger leads. Of instruments that span the day the nearest.
auto rank_of(const Presence& presence) {
  const bool spans = presence.in_situ && presence.span() >= shortest_leading_span;
  return std::tuple(spans, spans ? -presence.distance_m : 0.0, presence.values, presence.levels);
}

const Candidate* leading_of(const std::map<std::string, Presence>& found, bool in_situ) {
  const Candidate* best = nullptr;
  for (const Candidate& candidate : found) {
    if (candidate.second.values == 0 || candidate.second.in_situ != in_situ) continue;
    if (best == nullptr || rank_of(candidate.second) > rank_of(best->second)) best = &candidate;
  }
  return best;
}

}  // namespace

std::optional<std::string> leading_dataset(const VectorRecord& record, UtcTime from, UtcTime to) {
  const std::map<std::string, Presence> found = presence_in(record, from, to);
  const Candidate* product = leading_of(found, false);
  const Candidate* series = leading_of(found, true);
  if (product == nullptr && series == nullptr) return std::nullopt;
  if (series == nullptr) return product->first;
  if (product == nullptr) return series->first;
  const bool product_leads = product->second.step() <= longest_leading_step &&
                             product->second.span() >= shortest_leading_span;
  const bool series_leads = series->second.span() >= shortest_leading_span;
  if (product_leads) return product->first;
  if (series_leads) return series->first;
  return product->second.values >= series->second.values ? product->first : series->first;
}

}  // namespace slackwater
