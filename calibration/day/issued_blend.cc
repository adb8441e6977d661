#include "calibration/day/issued_blend.h"

#include <algorithm>

#include "calibration/day/methods.h"

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
                                       const Chosen<Horizontal>& known) {
  Snapshot snapshot;
  snapshot.day = plan.day;
  snapshot.time = plan.stamps;
  snapshot.depth_m = plan.depth_m;
  snapshot.columns.push_back(column);
  return current_methods(data, plan, snapshot, 0, places, known);
}

const MethodForecast* find_method(const std::vector<MethodForecast>& methods, Method candidate) {
  const auto found = std::find_if(methods.begin(), methods.end(),
                                  [&](const MethodForecast& m) { return m.method == candidate; });
  return found == methods.end() ? nullptr : &*found;
}

}  // namespace

std::vector<bool> available_candidates(const ForecastColumn& column, const ColumnData& data,
                                       const Chosen<Horizontal>& known, const ForecastPlan& plan) {
  const auto methods = methods_at(column, data, plan, places_of(column, plan, known), known);
  std::vector<bool> available;
  for (const Method candidate : candidate_methods())
    available.push_back(find_method(methods, candidate) != nullptr);
  return available;
}

void issue_blend(ForecastColumn& column, const ColumnData& data, const Chosen<Horizontal>& known,
                 const ForecastPlan& plan, const Earned& earned) {
  for (double& sigma : column.current_sigma_m_s) sigma *= earned.spread.scale;
  const std::size_t size = column.current_m_s.size();
  const std::vector<Horizontal> own = column.current_m_s;
  const auto& share = earned.blend.share;
  const bool is_own_alone = std::all_of(share.begin(), share.end(), [](const auto& s) {
    return s.method == Method::forecast || s.weight <= 0;
  });
  if (!is_own_alone) {
    const Chosen<Horizontal> places = places_of(column, plan, known);
    const auto methods = methods_at(column, data, plan, places, known);
    const std::size_t levels = plan.depth_m.size();
    for (std::size_t t = 0; t < plan.stamps.size(); ++t) {
      for (std::size_t k = 0; k < std::min(levels, places.column.levels()); ++k) {
        const std::size_t o = t * levels + k;
        if (!has_value(column.current_status[o])) continue;
        Horizontal sum{};
        double weight = 0;
        for (const auto& s : share) {
          const MethodForecast* method = s.weight > 0 ? find_method(methods, s.method) : nullptr;
          const std::size_t at = places.column.offset(t, k);
          if (method == nullptr || !method->made.has(at)) continue;
          sum += s.weight * method->made.value[at];
          weight += s.weight;
        }
        if (weight > 0) column.current_m_s[o] = sum / weight;
      }
    }
  }
  // Members hold absolute currents: their departures are scaled and set upon the new centre.
  for (std::size_t i = 0; i < column.member_m_s.size(); ++i) {
    const std::size_t o = i % size;
    column.member_m_s[i] =
        column.current_m_s[o] + earned.spread.scale * (column.member_m_s[i] - own[o]);
  }
}

}  // namespace slackwater::calibration
