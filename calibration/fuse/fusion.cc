#include "calibration/fuse/fusion.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "calibration/fuse/comparison.h"
#include "calibration/fuse/error_filter.h"
#include "fields/base/check.h"
#include "fields/base/numbers/square.h"

namespace slackwater::calibration {
namespace {

/// Variance of one component about the mean of all.
class Spread {
 public:
  void add(Horizontal value) {
    sum_ += value;
    squares_ += std::norm(value);
    ++count_;
  }
  [[nodiscard]] double of_component() const {
    if (count_ < 2) return 0;
    const auto n = static_cast<double>(count_);
    return 0.5 * (squares_ / n - std::norm(sum_ / n));
  }

 private:
  Horizontal sum_{};
  double squares_ = 0;
  std::size_t count_ = 0;
};

/// Noise variance of the values of one time.
class Noise {
 public:
  Noise(const FusionSettings& settings, const MooredInstrumentErrors& errors)
      : least_(square(settings.instrument_error_m_s)), errors_(errors) {}

  /// As the instrument's values show it; 0 where nobody looked.
  [[nodiscard]] double seen(const Differences& found, std::size_t i) const {
    if (errors_.noise_m_s.empty()) return 0;
    return square(errors_.noise_m_s[found.level[i]]) * found.noise_left[i];
  }
  [[nodiscard]] Eigen::VectorXd of(const Differences& found) const {
    Eigen::VectorXd noise(static_cast<Eigen::Index>(found.value.size()));
    for (std::size_t i = 0; i < found.value.size(); ++i)
      noise(static_cast<Eigen::Index>(i)) = std::max(least_, seen(found, i));
    return noise;
  }

 private:
  double least_;
  const MooredInstrumentErrors& errors_;
};

double variance_lacking(const std::vector<Differences>& all, const Noise& noise) {
  Spread observed;
  Spread product;
  double of_noise = 0;
  std::size_t count = 0;
  for (const Differences& one : all) {
    for (std::size_t i = 0; i < one.value.size(); ++i) {
      observed.add(one.observed[i]);
      product.add(one.observed[i] - one.value[i]);
      of_noise += noise.seen(one, i);
      ++count;
    }
  }
  if (count == 0) return 0;
  return std::max(0.0, observed.of_component() - product.of_component() -
                           of_noise / static_cast<double>(count));
}

double difference_variance(double distance_m, const FusionSettings& settings) {
  return square(settings.difference_m_s * std::cbrt(distance_m / settings.difference_m));
}

struct Variances {
  double product = 0;     ///< P
  double lacking = 0;     ///< M
  double difference = 0;  ///< R(D), and what of the instrument's error stays
  double shared = 0;      ///< P exp(-D/L) + M

  [[nodiscard]] double sum() const noexcept { return product + lacking + difference; }
  [[nodiscard]] double weight() const noexcept { return shared / sum(); }
};

Variances variances_of(double distance_m, double lacking, double lasting_m_s,
                       const FusionSettings& settings) {
  Variances v;
  v.product = square(settings.product_error_m_s);
  v.lacking = lacking;
  v.difference = difference_variance(distance_m, settings) + square(lasting_m_s);
  v.shared = v.product * std::exp(-distance_m / settings.product_length_m) + v.lacking;
  return v;
}

void observe(ErrorFilter& filter, const Differences& found, const Noise& noise,
             std::size_t levels) {
  const auto count = static_cast<Eigen::Index>(found.value.size());
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(count, static_cast<Eigen::Index>(levels));
  Eigen::VectorXcd y(count);
  for (Eigen::Index m = 0; m < count; ++m) {
    const DepthPlace& place = found.place[static_cast<std::size_t>(m)];
    h(m, static_cast<Eigen::Index>(place.low)) += 1 - place.share;
    h(m, static_cast<Eigen::Index>(place.high)) += place.share;
    y(m) = found.value[static_cast<std::size_t>(m)];
  }
  filter.observe(h, y, noise.of(found));
}

ErrorFilter filter_of(const std::vector<double>& depths_m, const Variances& v,
                      const FusionSettings& settings) {
  const double errors = v.product + v.difference;
  return ErrorFilter(depths_m, {settings.slow_share * errors, settings.slow_memory_h},
                     {(1 - settings.slow_share) * errors + v.lacking, settings.quick_memory_h},
                     settings.vertical_length_m);
}

}  // namespace

double expected_difference(double distance_m, const MooredInstrumentErrors& errors,
                           const FusionSettings& settings) {
  return std::sqrt(variances_of(distance_m, 0, errors.lasting_m_s, settings).sum());
}

double weight_at(double distance_m, const FusionSettings& settings) {
  return variances_of(distance_m, 0, 0, settings).weight();
}

FusedColumn fuse(const VectorColumn& product, const VectorColumn& observed, double distance_m,
                 const FusionSettings& settings, const MooredInstrumentErrors& errors) {
  expects(product.vertical == VerticalKind::depth_m && !product.levels_m.empty(),
          "a product over depths");
  expects(observed.vertical == VerticalKind::depth_m && !observed.levels_m.empty(),
          "an observed series over depths");
  expects(distance_m >= 0, "a distance of zero or more");
  expects(errors.noise_m_s.empty() || errors.noise_m_s.size() == observed.levels(),
          "a noise for each level of the instrument");
  FusedColumn fused;
  fused.column = product;
  fused.sigma_m_s.assign(product.value.size(), 0);
  fused.noise_m_s.assign(product.value.size(), 0);
  for (std::size_t i = 0; i < product.value.size(); ++i) {
    if (has_value(product.status[i])) fused.sigma_m_s[i] = settings.product_error_m_s;
  }
  if (distance_m > settings.farthest_m) return fused;

  const Comparison comparison(product, observed, settings);
  std::vector<Differences> differences;
  for (std::size_t t = 0; t < product.times(); ++t) differences.push_back(comparison.at(t));
  const Noise noise(settings, errors);
  const Variances v =
      variances_of(distance_m, variance_lacking(differences, noise), errors.lasting_m_s, settings);
  fused.weight = v.weight();
  for (double& sigma : fused.sigma_m_s) {
    if (sigma > 0) sigma = std::sqrt(v.product + v.lacking);
  }
  ErrorFilter filter = filter_of(product.levels_m, v, settings);
  const double left_m2_s2 = v.product + v.lacking - square(fused.weight) * v.sum();

  for (std::size_t t = 0; t < product.times(); ++t) {
    if (t > 0 && fused.times_observed > 0)
      filter.forget(hours_between(product.time[t - 1].centre(), product.time[t].centre()));
    const bool is_heard = !differences[t].value.empty();
    if (is_heard) {
      observe(filter, differences[t], noise, product.levels());
      ++fused.times_observed;
    }
    if (fused.times_observed == 0) continue;
    const Eigen::VectorXcd mean = filter.mean();
    const Eigen::VectorXd variance = filter.variance();
    const Eigen::VectorXd fresh = filter.fresh_noise();
    for (std::size_t k = 0; k < product.levels(); ++k) {
      const std::size_t o = product.offset(t, k);
      if (!has_value(product.status[o])) continue;
      const auto row = static_cast<Eigen::Index>(k);
      fused.column.value[o] += fused.weight * mean(row);
      fused.sigma_m_s[o] =
          std::sqrt(std::max(0.0, square(fused.weight) * variance(row) + left_m2_s2));
      if (is_heard) fused.noise_m_s[o] = fused.weight * std::sqrt(fresh(row));
    }
  }
  return fused;
}

}  // namespace slackwater::calibration
