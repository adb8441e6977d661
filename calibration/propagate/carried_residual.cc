#include "calibration/propagate/carried_residual.h"

#include <algorithm>
#include <cmath>

namespace slackwater::calibration {
namespace {

/// The end of the last cell that holds a residual and does not reach past the end of D.
std::optional<UtcTime> last_residual(const VectorColumn& residual, UtcTime end_of_day) {
  for (std::size_t t = residual.times(); t-- > 0;) {
    if (residual.time[t].end > end_of_day) continue;
    for (std::size_t k = 0; k < residual.levels(); ++k) {
      if (residual.has(t, k)) return residual.time[t].end;
    }
  }
  return std::nullopt;
}

/// What a decay to `left` takes out of a mean of this modulus goes to the spread of a component.
double given_up(Horizontal value, double left) {
  return 0.5 * std::norm(value) * (1.0 - left * left);
}

}  // namespace

CarriedResidual::CarriedResidual(const Calibration& calibration, const VectorColumn& residual,
                                 InertialBasis basis, const PropagationSettings& settings)
    : basis_(std::move(basis)), settings_(settings) {
  expects(!calibration.misfit.empty(), "a calibration has a misfit at one depth at least");
  const std::optional<UtcTime> last = last_residual(residual, basis_.end_of_day());
  age_h_ = last ? std::max(0.0, hours_between(*last, basis_.end_of_day())) : 0.0;
  for (std::size_t k = 0; k < residual.levels(); ++k) {
    std::optional<InertialMemory> memory =
        fit_inertial_memory(residual, k, basis_, settings.memory_prior);
    if (!memory) continue;  // a level without observations
    Horizontal sum{};
    double n = 0;
    for (std::size_t t = 0; last && t < residual.times(); ++t) {
      if (!residual.has(t, k)) continue;
      const UtcTime end = residual.time[t].end;
      if (end > *last || hours_between(end, *last) >= settings.recent_h) continue;
      sum += residual.value[residual.offset(t, k)] - memory->at(basis_.over(residual.time[t]));
      n += 1;
    }
    node_m_.push_back(residual.levels_m.empty() ? 0.0 : residual.levels_m[k]);
    memory_.push_back(std::move(*memory));
    recent_m_s_.push_back(n > 0 ? sum / n : Horizontal{});
  }
}

void CarriedResidual::at(UtcTime time, std::span<const double> depths_m,
                         std::span<Carried> out) const {
  expects(out.size() == depths_m.size(), "one value per depth");
  if (node_m_.empty()) return;
  const double lead_h = std::max(0.0, hours_between(basis_.end_of_day(), time));
  const double constant_left = std::exp(-lead_h / settings_.bias_decay_h);
  const double recent_left = std::exp(-(lead_h + age_h_) / settings_.residual_decay_h);
  Eigen::Vector3cd basis = basis_.over(TimeCell::instant(add_hours(basis_.end_of_day(), lead_h)));
  basis(0) *= constant_left;
  std::vector<Carried> node(node_m_.size());
  for (std::size_t k = 0; k < node.size(); ++k) {
    const InertialMemory& memory = memory_[k];
    node[k].mean_m_s = memory.at(basis) + recent_left * recent_m_s_[k];
    node[k].variance_m2_s2 = memory.left_over_m_s * memory.left_over_m_s +
                             memory.variance_at(basis) +
                             given_up(memory.coefficients(0), constant_left) +
                             given_up(memory.coefficients(2), std::abs(basis(2)));
    node[k].interior_doubt = memory.has_motion ? 0.0 : 1.0;
  }
  const auto mixed = [](double weight, const Carried& a, const Carried& b) {
    return Carried{(1.0 - weight) * a.mean_m_s + weight * b.mean_m_s,
                   (1.0 - weight) * a.variance_m2_s2 + weight * b.variance_m2_s2,
                   (1.0 - weight) * a.interior_doubt + weight * b.interior_doubt};
  };
  for (std::size_t i = 0; i < depths_m.size(); ++i) {
    const auto after = std::lower_bound(node_m_.begin(), node_m_.end(), depths_m[i]);
    if (after == node_m_.begin()) {
      out[i] = node.front();
    } else if (after == node_m_.end()) {
      out[i] = node.back();
    } else {
      const auto k = static_cast<std::size_t>(after - node_m_.begin());
      const double weight = (depths_m[i] - node_m_[k - 1]) / (node_m_[k] - node_m_[k - 1]);
      out[i] = mixed(weight, node[k - 1], node[k]);
    }
  }
}

double CarriedResidual::left_over_m2_s2() const noexcept {
  double sum = 0;
  for (const InertialMemory& memory : memory_) sum += memory.left_over_m_s * memory.left_over_m_s;
  return sum;
}

}  // namespace slackwater::calibration
