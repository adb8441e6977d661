#include "calibration/day/given/horizon_input.h"

#include <algorithm>

#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

Knowledge known_by(UtcTime time, UtcTime seen_by) { return {time, time, time, seen_by}; }

/// With `persist` the series ends with D, and so does who speaks.
template <typename T>
void end_with(Chosen<T>& chosen, UtcTime end) {
  chosen.column = slice(chosen.column, UtcTime::min(), end);
  chosen.origin.resize(chosen.column.times());
  std::erase_if(chosen.stretches, [&](const Stretch& stretch) { return stretch.from > end; });
  for (Stretch& stretch : chosen.stretches) stretch.to = std::min(stretch.to, end);
}

template <typename T>
Chosen<T> input_known(const Record<T>& record, const Knowledge& knowledge,
                      const std::vector<Stretch>* like) {
  Choice choice;
  choice.only_grids = true;
  choice.ramp = join_ramp;
  choice.like = like;
  Chosen<T> chosen = choose(record, knowledge, choice);
  if (chosen.empty()) {
    choice.only_grids = false;
    chosen = choose(record, knowledge, choice);
  }
  return chosen;
}

template <typename T>
Chosen<T> input_of(const Record<T>& record, WindPolicy policy, UtcTime end_of_day,
                   const BestInputs& best, const std::vector<Stretch>* like) {
  Chosen<T> chosen = input_known(record, knowledge_of(policy, end_of_day, best), like);
  if (policy == WindPolicy::persist) end_with(chosen, end_of_day);
  return chosen;
}

template <typename T>
bool uses_the_unknown(const Chosen<T>& chosen, const BestInputs& best) {
  const Knowledge known = known_by(best.known_by, UtcTime::max());
  for (std::size_t t = 0; t < chosen.column.times(); ++t) {
    if (!is_known(*chosen.origin[t], chosen.column.time[t], known)) return true;
  }
  return false;
}

}  // namespace

Knowledge knowledge_of(WindPolicy policy, UtcTime end_of_day, const BestInputs& best) {
  switch (policy) {
    case WindPolicy::best:
      return best.hindsight ? Knowledge{} : known_by(best.known_by, best.seen_by);
    case WindPolicy::forecast:
      return known_by(best.issued.value_or(end_of_day), best.seen_by);
    case WindPolicy::persist:
      return {end_of_day, end_of_day, UtcTime::min(), best.seen_by};
  }
  return {};
}

Chosen<Horizontal> choose_input(const VectorRecord& record, WindPolicy policy, UtcTime end_of_day,
                                const BestInputs& best, const std::vector<Stretch>* like) {
  return input_of(record, policy, end_of_day, best, like);
}

Chosen<double> choose_input(const ScalarRecord& record, WindPolicy policy, UtcTime end_of_day,
                            const BestInputs& best, const std::vector<Stretch>* like) {
  return input_of(record, policy, end_of_day, best, like);
}

Chosen<Horizontal> choose_analysed(const VectorRecord& record, UtcTime end_of_day,
                                   const BestInputs& best) {
  const UtcTime issued = best.issued.value_or(end_of_day);
  return input_known(record, {best.analysed_until, issued, issued, best.seen_by}, nullptr);
}

bool looks_ahead(const Chosen<Horizontal>& chosen, const BestInputs& best) {
  return uses_the_unknown(chosen, best);
}

bool looks_ahead(const Chosen<double>& chosen, const BestInputs& best) {
  return uses_the_unknown(chosen, best);
}

}  // namespace slackwater::calibration
