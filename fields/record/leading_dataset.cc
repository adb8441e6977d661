#include "fields/record/leading_dataset.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "fields/record/product_run.h"

namespace slackwater {
namespace {

constexpr Duration longest_leading_step = std::chrono::hours(3);
constexpr Duration shortest_leading_span = std::chrono::hours(20);  // of a day

/// What a dataset has in a span of time.
struct Presence {
  const Origin* origin = nullptr;
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

std::map<std::string, Presence> presence_in(const VectorRecord& record, UtcTime from, UtcTime to,
                                            const Knowledge& knowledge) {
  std::map<std::string, Presence> found;
  for (const ProductRun<Horizontal>& run : runs_of(record, knowledge, {.every_series = true})) {
    Presence& presence = found[run.origin().dataset];
    presence.origin = &run.origin();
    presence.levels = std::max(presence.levels, run.first->column.levels());
    presence.in_situ = is_in_situ(run.origin());
    presence.distance_m = run.first->distance_m;
    for (const RunValue<Horizontal>& value : run.values) {
      if (value.cell.end < from || value.cell.start > to) continue;
      for (std::size_t k = 0; k < value.piece->column.levels(); ++k)
        presence.values += value.piece->column.has(value.t, k) ? 1 : 0;
      presence.cells.push_back(value.cell);
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

bool resolves_the_tide(const Presence& presence) {
  return presence.step() <= longest_leading_step && presence.span() >= shortest_leading_span;
}

/// Larger leads. Of instruments that span the day the nearest.
auto rank_of_series(const Presence& presence) {
  const bool spans = presence.span() >= shortest_leading_span;
  return std::tuple(spans, spans ? -presence.distance_m : 0.0, presence.values, presence.levels);
}

bool leads_series(const Candidate& one, const Candidate& other) {
  return rank_of_series(one.second) > rank_of_series(other.second);
}

bool leads_product(const Candidate& one, const Candidate& other) {
  const Presence& a = one.second;
  const Presence& b = other.second;
  if (resolves_the_tide(a) != resolves_the_tide(b)) return resolves_the_tide(a);
  const auto precedence = product_precedence(*a.origin);
  if (precedence != product_precedence(*b.origin))
    return precedence < product_precedence(*b.origin);
  return std::tuple(a.values, a.levels) > std::tuple(b.values, b.levels);
}

const Candidate* leading_of(const std::map<std::string, Presence>& found, bool in_situ,
                            const std::optional<std::string>& product = std::nullopt) {
  const auto leads = in_situ ? leads_series : leads_product;
  const Candidate* best = nullptr;
  for (const Candidate& candidate : found) {
    if (candidate.second.values == 0 || candidate.second.in_situ != in_situ) continue;
    if (product && candidate.second.origin->product_id != *product) continue;
    if (best == nullptr || leads(candidate, *best)) best = &candidate;
  }
  return best;
}

}  // namespace

std::optional<std::string> leading_dataset(const VectorRecord& record, UtcTime from, UtcTime to,
                                           const Knowledge& knowledge) {
  const std::map<std::string, Presence> found = presence_in(record, from, to, knowledge);
  const Candidate* product = leading_of(found, false);
  const Candidate* series = leading_of(found, true);
  if (product == nullptr && series == nullptr) return std::nullopt;
  if (series == nullptr) return product->first;
  if (product == nullptr) return series->first;
  if (resolves_the_tide(product->second)) return product->first;
  if (series->second.span() >= shortest_leading_span) return series->first;
  return product->second.values >= series->second.values ? product->first : series->first;
}

std::optional<std::string> leading_product(const VectorRecord& record, UtcTime from, UtcTime to,
                                           const Knowledge& knowledge,
                                           const std::optional<std::string>& product) {
  const std::map<std::string, Presence> found = presence_in(record, from, to, knowledge);
  const Candidate* leading = product ? leading_of(found, false, product) : nullptr;
  if (leading == nullptr) leading = leading_of(found, false);
  if (leading == nullptr) return std::nullopt;
  return leading->first;
}

}  // namespace slackwater
