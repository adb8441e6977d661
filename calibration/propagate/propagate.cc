#include "calibration/propagate/propagate.h"

#include <algorithm>
#include <cmath>

#include "calibration/propagate/column_memory.h"
#include "calibration/propagate/member_wind.h"
#include "calibration/propagate/members.h"
#include "calibration/residuals/column_rows.h"
#include "calibration/solve/parameter_set.h"
#include "fields/base/check.h"

namespace slackwater::calibration {
namespace {

/// What all forms share.
struct Horizon {
  std::span<const UtcTime> times;
  UtcTime end_of_day;
  StressSeries stress;  ///< empty where the calibration used none
  const Spread& spread;
};

/// All forms carried forward; each vector one entry a form, then times x levels.
struct Outlook {
  std::vector<std::vector<Horizontal>> mean;
  std::vector<std::vector<Horizontal>> driven;
  std::vector<std::vector<double>> variance;  ///< of a component: the memory's
};

/// The stress that may blow unseen makes currents that no member has.
void add_unknown_wind(const Calibration& c, const Horizon& horizon,
                      const std::vector<double>& depth_m, std::vector<double>& variance) {
  if (!c.layout.has_wind) return;
  const LevelResponses responses =
      level_responses(c.form, steady_parameters(c), c.latitude, c.water_depth_m, depth_m);
  for (std::size_t t = 0; t < horizon.times.size(); ++t) {
    if (horizon.stress.at(horizon.times[t])) continue;
    for (std::size_t k = 0; k < depth_m.size(); ++k) {
      const double unseen = horizon.spread.unknown_stress_pa * std::abs(responses.stress(k));
      variance[t * depth_m.size() + k] += unseen * unseen;
    }
  }
}

void carry(const Calibration& c, const ColumnMemory& memory, const Horizon& horizon,
           Outlook& outlook) {
  ColumnRows rows(day_of_horizon(c, horizon.times, horizon.end_of_day, horizon.stress));
  rows.evaluate(without_flow(estimates_of(c.parameters), c.layout).data(), false);
  const auto size = static_cast<std::size_t>(rows.model().size());
  std::vector<Horizontal> driven(rows.wind_driven().data(), rows.wind_driven().data() + size);
  std::vector<Horizontal> mean(size);
  std::vector<double> variance(size);
  memory.predict(horizon.times, driven, mean, variance);
  for (std::size_t i = 0; i < size; ++i) mean[i] += rows.model().data()[i];
  add_unknown_wind(c, horizon, rows.day().depth_m, variance);
  outlook.mean.push_back(std::move(mean));
  outlook.driven.push_back(std::move(driven));
  outlook.variance.push_back(std::move(variance));
}

/// The forms' weighted mean into `result`; what is left open, their disagreement included, is
/// returned.
std::vector<double> mix(const Outlook& outlook, Propagated& result) {
  const std::size_t size = outlook.mean.front().size();
  result.mean_m_s.resize(size);
  result.wind_driven_m_s.resize(size);
  for (std::size_t f = 0; f < outlook.mean.size(); ++f) {
    for (std::size_t i = 0; i < size; ++i) {
      result.mean_m_s[i] += result.form_weight[f] * outlook.mean[f][i];
      result.wind_driven_m_s[i] += result.form_weight[f] * outlook.driven[f][i];
    }
  }
  std::vector<double> variance(size);
  for (std::size_t f = 0; f < outlook.mean.size(); ++f) {
    for (std::size_t i = 0; i < size; ++i) {
      const double apart = 0.5 * std::norm(outlook.mean[f][i] - result.mean_m_s[i]);
      variance[i] += result.form_weight[f] * (outlook.variance[f][i] + apart);
    }
  }
  return variance;
}

/// Adds the first members of a set to those that are there.
void add_first(const Members& set, std::size_t members, std::size_t size, std::size_t times,
               Propagated& result) {
  const auto add = [&](auto& to, const auto& from, std::size_t each) {
    const std::size_t count = std::min(from.size(), members * each);
    to.insert(to.end(), from.begin(), from.begin() + static_cast<std::ptrdiff_t>(count));
  };
  add(result.departure_m_s, set.departures(), size);
  add(result.wind_departure_m_s, set.wind_departures(), times);
  add(result.wind_member_number, set.wind_numbers(), 1);
}

}  // namespace

Propagated propagate(std::span<const Calibration> forms, std::span<const UtcTime> times,
                     const std::optional<VectorColumn>& wind, UtcTime end_of_day,
                     const WindErrorGrowth& wind_error, const Spread& spread, std::uint64_t seed,
                     const WindDepartures& ensemble) {
  expects(!forms.empty() && !times.empty(), "something to carry, and somewhere to carry it");
  const bool uses_wind = wind && forms.front().wind_used;
  const Horizon horizon{times, end_of_day,
                        uses_wind ? StressSeries(*wind, forms.front().drag_law) : StressSeries(),
                        spread};
  Propagated result;
  for (const UtcTime time : times) {
    result.has_wind.push_back(horizon.stress.at(time).has_value());
    if (forms.front().wind_used && !result.has_wind.back()) ++result.wind_missing;
  }
  result.form_weight = form_weights({forms.begin(), forms.end()});
  Outlook outlook;
  std::vector<ColumnMemory> memory;
  for (const Calibration& c : forms) {
    expects(c.remembered.levels() == forms.front().remembered.levels(),
            "all forms stand on the same levels");
    memory.emplace_back(c, end_of_day, spread);
    carry(c, memory.back(), horizon, outlook);
  }
  std::vector<double> variance = mix(outlook, result);

  expects(spread.set_of_members > 0 && spread.set_of_members % 2 == 0, "sets of whole pairs");
  const auto of_set = static_cast<std::size_t>(spread.set_of_members);
  const auto wanted = static_cast<std::size_t>(std::max(0, spread.members));
  const std::size_t sets = std::max<std::size_t>(1, (wanted + of_set - 1) / of_set);
  for (std::size_t set = 0; set < sets; ++set) {
    if (wanted == 0 && !uses_wind) break;
    Members members(forms, result.form_weight, spread.set_of_members, variance.size(), seed, set);
    if (uses_wind)
      members.draw_wind_driven(times, *wind, end_of_day, wind_error, outlook.driven, ensemble);
    if (set == 0) {
      const std::vector<double> driven = members.variance();
      for (std::size_t i = 0; i < variance.size(); ++i) variance[i] += driven[i];
    }
    if (wanted == 0) break;
    members.draw_memory(times, memory, outlook.driven);
    std::vector<double> sigma_m_s;
    for (const double v : variance) sigma_m_s.push_back(std::sqrt(v));
    members.scale_to(sigma_m_s);
    add_first(members, std::min(of_set, wanted - set * of_set), variance.size(), times.size(),
              result);
  }
  for (const double v : variance) result.sigma_m_s.push_back(std::sqrt(v));
  return result;
}

}  // namespace slackwater::calibration
