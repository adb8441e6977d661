#include "calibration/day/issued_blend.h"

#include <algorithm>

#include "calibration/day/column/merge.h"
#include "calibration/day/column/methods.h"
#include "fields/base/constants.h"

namespace slackwater::calibration {
namespace {

/// A column of the plan's stamps and the record's levels to evaluate candidates on; its values mean
/// nothing.
Chosen<Horizontal> places_of(const ForecastColumn& column, const ForecastPlan& plan,
                             const Chosen<Horizontal>& known) {
  Chosen<Horizontal> places;
  VectorColumn& c = places.column;
  c.point = column.point;
  c.vertical = VerticalKind::depth_m;
  c.levels_m = known.column.levels_m;
  for (const UtcTime stamp : plan.stamps) c.time.push_back(TimeCell::instant(stamp));
  c.value.assign(c.time.size() * c.levels(), Horizontal{});
  c.status.assign(c.value.size(), SampleStatus::ok);
  c.source.assign(c.time.size(), DataStatus::analysis);
  places.origin = known.origin;
  return places;
}

std::vector<MethodForecast> methods_at(const ForecastColumn& column, const ColumnData& data,
                                       const ForecastPlan& plan, const Chosen<Horizontal>& places,
                                       const KnownColumn& known) {
  Snapshot snapshot;
  snapshot.day = plan.day;
  snapshot.time = plan.stamps;
  snapshot.depth_m = plan.depth_m;
  snapshot.columns.push_back(column);
  return current_methods(data, plan, snapshot, 0, places, known.currents, known.provider,
                         &known.tide);
}

const MethodForecast* find_method(const std::vector<MethodForecast>& methods, Method candidate) {
  const auto found = std::find_if(methods.begin(), methods.end(),
                                  [&](const MethodForecast& m) { return m.method == candidate; });
  return found == methods.end() ? nullptr : &*found;
}

/// A candidate at the places of a column, and how much of its weight counts there.
struct Voice {
  const MethodForecast* method = nullptr;
  std::vector<double> presence;
};

bool is_own_alone(const Earned& earned) {
  const auto is_ours = [](const Blend& blend) {
    return std::all_of(blend.share.begin(), blend.share.end(), [](const CandidateShare& s) {
      return s.method == Method::forecast || s.weight <= 0;
    });
  };
  return is_ours(earned.blend) && std::all_of(earned.later.begin(), earned.later.end(), is_ours);
}

/// Puts the blend in place of our own at every stamp and level, and its spread in place of ours.
void blend_values(ForecastColumn& column, const ForecastPlan& plan,
                  const std::vector<MethodForecast>& methods, const VectorColumn& places,
                  const Earned& earned) {
  using constants::nan;
  std::vector<Voice> voices;
  for (const CandidateShare& share : earned.blend.share) {
    const MethodForecast* method = find_method(methods, share.method);
    voices.push_back({method, {}});
    if (method != nullptr) voices.back().presence = presence_of(method->made, places);
  }
  const std::size_t levels = plan.depth_m.size();
  for (std::size_t t = 0; t < plan.stamps.size(); ++t) {
    const std::vector<double> weights =
        weights_at(earned, hours_between(plan.end_of_day(), plan.stamps[t]));
    for (std::size_t k = 0; k < std::min(levels, places.levels()); ++k) {
      const std::size_t o = t * levels + k;
      if (!has_value(column.current_status[o])) continue;
      const std::size_t at = places.offset(t, k);
      Horizontal sum{};
      double weight = 0;
      double merged_sigma = nan;
      for (std::size_t c = 0; c < voices.size(); ++c) {
        if (voices[c].method == nullptr || voices[c].presence[at] <= 0) continue;
        const double w = weights[c] * voices[c].presence[at];
        if (w <= 0) continue;
        sum += w * voices[c].method->made.value[at];
        weight += w;
        if (voices[c].method->method == Method::merged)
          merged_sigma = voices[c].method->sigma_m_s[at];
      }
      if (weight <= 0) continue;
      column.current_m_s[o] = sum / weight;
      column.current_sigma_m_s[o] =
          sigma_of_blend(earned.blend, weights, column.current_sigma_m_s[o], merged_sigma);
    }
  }
}

}  // namespace

std::vector<bool> available_candidates(const ForecastColumn& column, const ColumnData& data,
                                       const KnownColumn& known, const ForecastPlan& plan) {
  const auto methods =
      methods_at(column, data, plan, places_of(column, plan, known.currents), known);
  std::vector<bool> available;
  for (const Method candidate : candidate_methods())
    available.push_back(find_method(methods, candidate) != nullptr);
  return available;
}

void issue_blend(ForecastColumn& column, const ColumnData& data, const KnownColumn& known,
                 const ForecastPlan& plan, const Earned& earned) {
  const std::size_t size = column.current_m_s.size();
  const std::vector<Horizontal> own = column.current_m_s;
  const std::vector<double> own_sigma = column.current_sigma_m_s;
  if (!is_own_alone(earned)) {
    const Chosen<Horizontal> places = places_of(column, plan, known.currents);
    blend_values(column, plan, methods_at(column, data, plan, places, known), places.column,
                 earned);
  }
  std::vector<double> scale;  // per stamp
  for (const UtcTime stamp : plan.stamps)
    scale.push_back(earned.spread.scale_at(hours_between(plan.end_of_day(), stamp)));
  const auto scale_of = [&](std::size_t o) { return scale[o / plan.depth_m.size()]; };
  for (std::size_t o = 0; o < size; ++o) column.current_sigma_m_s[o] *= scale_of(o);
  // Members hold absolute currents: their departures are scaled and set upon the new centre.
  for (std::size_t i = 0; i < column.member_m_s.size(); ++i) {
    const std::size_t o = i % size;
    const double factor =
        own_sigma[o] > 0 ? column.current_sigma_m_s[o] / own_sigma[o] : scale_of(o);
    column.member_m_s[i] = column.current_m_s[o] + factor * (column.member_m_s[i] - own[o]);
  }
}

}  // namespace slackwater::calibration
