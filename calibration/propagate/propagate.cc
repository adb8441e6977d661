#include "calibration/propagate/propagate.h"

#include <algorithm>
#include <cmath>

#include "calibration/propagate/gaussian_memory.h"
#include "calibration/propagate/member_wind.h"
#include "calibration/propagate/wind_error.h"
#include "calibration/residuals/column_rows.h"
#include "calibration/solve/parameter_set.h"
#include "fields/base/check.h"
#include "fields/current/coriolis.h"

namespace slackwater::calibration {
namespace {

/// What all forms share.
struct Horizon {
  std::span<const UtcTime> times;
  UtcTime end_of_day;
  const std::optional<VectorColumn>& wind;
  StressSeries stress;  ///< empty where the calibration used none
  const Spread& spread;
  const WindErrorGrowth& wind_error;
};

/// One form carried forward.
struct FormOutlook {
  std::vector<Horizontal> mean;
  std::vector<Horizontal> driven;
  std::vector<double> variance;        ///< of a component: the memory's
  std::vector<Horizontal> departures;  ///< of the members of this form, members x times x levels
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

/// What a column remembers under kernels of several livelinesses, with their probabilities.
class ColumnMemory {
 public:
  ColumnMemory(const Calibration& c, const Horizon& horizon) {
    const double coriolis_rad_h = 3600.0 * coriolis_parameter_rad_s(c.latitude);
    const double damping_per_h = inertial_damping_per_h(c, horizon.spread.inertial_decay_h);
    std::size_t levels = 0;
    for (const MisfitAtDepth& m : c.misfit) levels += m.n > 0 ? 1 : 0;
    const double witnesses =
        std::min(1.0, horizon.spread.independent_levels /
                          static_cast<double>(std::max<std::size_t>(1, levels)));
    std::vector<double> log_weight;
    for (const double slow : horizon.spread.slow_scales) {
      for (const double recent : horizon.spread.recent_scales) {
        for (const double inertial : horizon.spread.inertial_scales) {
          MemoryKernel kernel = horizon.spread.memory;
          kernel.slow_m_s *= slow;
          kernel.recent_m_s *= recent;
          kernel.inertial_m_s *= inertial;
          memory_.emplace_back(c.remembered, c.wind_driven_m_s, horizon.end_of_day, damping_per_h,
                               coriolis_rad_h, kernel);
          log_weight.push_back(witnesses * memory_.back().log_evidence());
        }
      }
    }
    const double best = *std::max_element(log_weight.begin(), log_weight.end());
    double sum = 0;
    for (const double w : log_weight) {
      // A kernel of less than a hundredth would move nothing.
      weight_.push_back(w - best < std::log(0.01) ? 0.0 : std::exp(w - best));
      sum += weight_.back();
    }
    for (double& w : weight_) w /= sum;
  }

  void predict(std::span<const UtcTime> times, std::span<const Horizontal> driven,
               std::vector<Horizontal>& mean, std::vector<double>& variance) const {
    std::vector<Horizontal> one(mean.size());
    std::vector<double> spread(mean.size());
    std::vector<double> square(mean.size());
    for (std::size_t m = 0; m < memory_.size(); ++m) {
      if (weight_[m] <= 0) continue;
      memory_[m].predict(times, driven, one, spread);
      for (std::size_t i = 0; i < mean.size(); ++i) {
        mean[i] += weight_[m] * one[i];
        square[i] += 0.5 * weight_[m] * std::norm(one[i]);
        variance[i] += weight_[m] * spread[i];
      }
    }
    for (std::size_t i = 0; i < mean.size(); ++i)
      variance[i] += std::max(0.0, square[i] - 0.5 * std::norm(mean[i]));
  }

  [[nodiscard]] const GaussianMemory& likeliest() const {
    return memory_[static_cast<std::size_t>(std::max_element(weight_.begin(), weight_.end()) -
                                            weight_.begin())];
  }

 private:
  std::vector<GaussianMemory> memory_;
  std::vector<double> weight_;
};

FormOutlook carry(const Calibration& c, const ColumnMemory& memory, const Horizon& horizon) {
  ColumnRows rows(day_of_horizon(c, horizon.times, horizon.end_of_day, horizon.stress));
  rows.evaluate(without_flow(estimates_of(c.parameters), c.layout).data(), false);
  FormOutlook out;
  const auto size = static_cast<std::size_t>(rows.model().size());
  out.driven.assign(rows.wind_driven().data(), rows.wind_driven().data() + size);
  out.mean.resize(size);
  out.variance.resize(size);
  memory.predict(horizon.times, out.driven, out.mean, out.variance);
  for (std::size_t i = 0; i < size; ++i) out.mean[i] += rows.model().data()[i];
  add_unknown_wind(c, horizon, rows.day().depth_m, out.variance);
  return out;
}

std::vector<UtcTime> wind_samples_after(const VectorColumn& wind, UtcTime end_of_day) {
  std::vector<UtcTime> times;
  for (const TimeCell& cell : wind.time) {
    if (cell.centre() > end_of_day) times.push_back(cell.centre());
  }
  return times;
}

/// Departures known at the samples of the wind, at the stamps of the forecast: linear between samples,
/// from 0 at the end of D, held after the last.
std::vector<Horizontal> at_stamps(std::span<const UtcTime> samples,
                                  std::span<const Horizontal> departure,
                                  std::span<const UtcTime> stamps, UtcTime end_of_day) {
  std::vector<Horizontal> out;
  for (const UtcTime stamp : stamps) {
    const auto i = static_cast<std::size_t>(
        std::lower_bound(samples.begin(), samples.end(), stamp) - samples.begin());
    if (samples.empty() || stamp <= end_of_day) {
      out.emplace_back();
    } else if (i == samples.size()) {
      out.push_back(departure.back());
    } else {
      const UtcTime before = i == 0 ? end_of_day : samples[i - 1];
      const Horizontal low = i == 0 ? Horizontal{} : departure[i - 1];
      const double share = hours_between(before, stamp) / hours_between(before, samples[i]);
      out.push_back((1.0 - share) * low + share * departure[i]);
    }
  }
  return out;
}

std::vector<Horizontal> opposite(std::vector<Horizontal> values) {
  for (Horizontal& value : values) value = -value;
  return values;
}

/// Departures of the wind-driven part and of the memory for one pair of members of a form.
void draw_pair(const Calibration& c, const Horizon& horizon, WindDriven& model,
               const std::vector<Horizontal>& central, std::span<const Horizontal> wind_departure,
               Rng& random, std::span<Horizontal> plus, std::span<Horizontal> minus) {
  std::vector<double> normals(c.parameters.size());
  for (double& z : normals) z = random.normal();
  for (const double sign : {1.0, -1.0}) {
    std::vector<double> z = normals;
    for (double& x : z) x *= sign;
    const std::vector<Horizontal> wind(wind_departure.begin(), wind_departure.end());
    const StressSeries stress(
        departed_wind(*horizon.wind, horizon.end_of_day, sign > 0 ? wind : opposite(wind)),
        c.drag_law);
    const std::vector<Horizontal> driven = model.under(stress, drawn_parameters(c, z));
    const std::span<Horizontal> out = sign > 0 ? plus : minus;
    for (std::size_t i = 0; i < driven.size(); ++i) out[i] = driven[i] - central[i];
  }
  // Nonlinear drag gives the pair a mean; member 0 is the centre.
  for (std::size_t i = 0; i < plus.size(); ++i) {
    const Horizontal half = 0.5 * (plus[i] + minus[i]);
    plus[i] -= half;
    minus[i] -= half;
  }
}

/// Which form each pair of members follows: as often as its weight asks, in order.
std::vector<std::size_t> form_of_pairs(const std::vector<double>& weight, std::size_t pairs) {
  std::vector<std::size_t> form;
  double sum = 0;
  std::size_t f = 0;
  for (std::size_t p = 0; p < pairs; ++p) {
    const double at = (static_cast<double>(p) + 0.5) / static_cast<double>(pairs);
    while (f + 1 < weight.size() && sum + weight[f] < at) sum += weight[f++];
    form.push_back(f);
  }
  return form;
}

/// Sum over members of |d|^2/2 over their number: variance of a component.
std::vector<double> component_variance(const std::vector<Horizontal>& departures,
                                       std::size_t members, std::size_t size) {
  std::vector<double> variance(size);
  if (members == 0) return variance;
  for (std::size_t m = 0; m < members; ++m) {
    for (std::size_t i = 0; i < size; ++i)
      variance[i] += 0.5 * std::norm(departures[m * size + i]) / static_cast<double>(members);
  }
  return variance;
}

}  // namespace

double inertial_damping_per_h(const Calibration& calibration, double decay_h) {
  double damping_per_h = 1.0 / decay_h;
  if (calibration.form == SteadyForm::finite_depth && calibration.layout.has_shape) {
    damping_per_h +=
        3600.0 * steady_parameters(calibration).bottom_friction_m_s / calibration.water_depth_m;
  }
  return damping_per_h;
}

Propagated propagate(std::span<const Calibration> forms, std::span<const UtcTime> times,
                     const std::optional<VectorColumn>& wind, UtcTime end_of_day,
                     const WindErrorGrowth& wind_error, const Spread& spread, std::uint64_t seed) {
  expects(!forms.empty() && !times.empty(), "something to carry, and somewhere to carry it");
  const bool uses_wind = wind && forms.front().wind_used;
  const Horizon horizon{
      times,  end_of_day,
      wind,   uses_wind ? StressSeries(*wind, forms.front().drag_law) : StressSeries(),
      spread, wind_error};
  const std::size_t levels = forms.front().remembered.levels();
  const std::size_t size = times.size() * levels;

  Propagated result;
  for (const UtcTime time : times) {
    result.has_wind.push_back(horizon.stress.at(time).has_value());
    if (forms.front().wind_used && !result.has_wind.back()) ++result.wind_missing;
  }
  result.form_weight = form_weights({forms.begin(), forms.end()});
  std::vector<FormOutlook> outlook;
  std::vector<ColumnMemory> memory;
  for (const Calibration& c : forms) {
    expects(c.remembered.levels() == levels, "all forms stand on the same levels");
    memory.emplace_back(c, horizon);
    outlook.push_back(carry(c, memory.back(), horizon));
  }
  result.mean_m_s.resize(size);
  result.wind_driven_m_s.resize(size);
  std::vector<double> variance(size);
  for (std::size_t f = 0; f < forms.size(); ++f) {
    for (std::size_t i = 0; i < size; ++i) {
      result.mean_m_s[i] += result.form_weight[f] * outlook[f].mean[i];
      result.wind_driven_m_s[i] += result.form_weight[f] * outlook[f].driven[i];
    }
  }
  for (std::size_t f = 0; f < forms.size(); ++f) {
    for (std::size_t i = 0; i < size; ++i) {
      const double apart = 0.5 * std::norm(outlook[f].mean[i] - result.mean_m_s[i]);
      variance[i] += result.form_weight[f] * (outlook[f].variance[i] + apart);
    }
  }

  const auto pairs = static_cast<std::size_t>(std::max(0, spread.members) / 2);
  const std::size_t members = 2 * pairs;
  std::vector<Horizontal> departures(members * size);
  const auto member = [&](std::size_t m) { return std::span(departures).subspan(m * size, size); };
  const std::vector<std::size_t> form = form_of_pairs(result.form_weight, pairs);
  if (uses_wind) {
    const std::vector<UtcTime> samples = wind_samples_after(*wind, end_of_day);
    std::vector<WindDriven> model;
    for (const Calibration& c : forms) model.emplace_back(c, times, end_of_day);
    for (std::size_t p = 0; p < pairs; ++p) {
      Rng random(seed, "calibration/member_wind/" + std::to_string(p));
      const std::vector<Horizontal> drawn =
          draw_wind_departures(samples, end_of_day, wind_error, random);
      const Calibration& c = forms[form[p]];
      draw_pair(c, horizon, model[form[p]], outlook[form[p]].driven, drawn, random, member(2 * p),
                member(2 * p + 1));
      const std::vector<Horizontal> at_times = at_stamps(samples, drawn, times, end_of_day);
      for (const double sign : {1.0, -1.0}) {
        for (const Horizontal& w : at_times) result.wind_departure_m_s.push_back(sign * w);
      }
    }
    const std::vector<double> driven = component_variance(departures, members, size);
    for (std::size_t i = 0; i < size; ++i) variance[i] += driven[i];
  }
  for (std::size_t f = 0; f < forms.size(); ++f) {
    const auto count = static_cast<int>(std::count(form.begin(), form.end(), f));
    if (count == 0) continue;
    Rng random(seed, "calibration/member_memory/" + std::to_string(f));
    std::vector<Horizontal> drawn(static_cast<std::size_t>(count) * size);
    memory[f].likeliest().sample(times, outlook[f].driven, random, count, drawn);
    std::size_t next = 0;
    for (std::size_t p = 0; p < pairs; ++p) {
      if (form[p] != f) continue;
      for (std::size_t i = 0; i < size; ++i) {
        member(2 * p)[i] += drawn[next * size + i];
        member(2 * p + 1)[i] -= drawn[next * size + i];
      }
      ++next;
    }
  }
  result.sigma_m_s.resize(size);
  for (std::size_t i = 0; i < size; ++i) result.sigma_m_s[i] = std::sqrt(variance[i]);
  const std::vector<double> drawn = component_variance(departures, members, size);
  for (std::size_t m = 0; m < members; ++m) {
    for (std::size_t i = 0; i < size; ++i) {
      const double scale = drawn[i] > 0 ? result.sigma_m_s[i] / std::sqrt(drawn[i]) : 0.0;
      member(m)[i] *= scale;
    }
  }
  result.departure_m_s = std::move(departures);
  return result;
}

}  // namespace slackwater::calibration
