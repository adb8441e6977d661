#pragma once
#include <Eigen/LU>
#include <cmath>

#include "tests/calibration/propagate/memory_for_tests.h"

// The textbook's regression, written densely: one level, all terms in one covariance, a plain
// inverse.

namespace slackwater::calibration {

inline Horizontal textbook_kernel(const MemoryKernel& k, double t, double u, Horizontal answer_t,
                                  Horizontal answer_u) {
  const double d = t - u;
  return k.constant_m_s * k.constant_m_s +
         k.slow_m_s * k.slow_m_s * std::exp(-std::abs(d) / k.slow_h) +
         k.inertial_m_s * k.inertial_m_s *
             std::exp(-damping_per_h * std::abs(d) - i_unit * coriolis_rad_h * d) +
         k.recent_m_s * k.recent_m_s * std::exp(-std::abs(d) / k.recent_h) +
         k.own_share * k.own_share * answer_t * std::conj(answer_u);
}

/// The kernel of a level: all amplitudes but the own share fade with depth.
inline MemoryKernel faded(MemoryKernel k, double depth_m) {
  const double left = k.deep_share + (1 - k.deep_share) * std::exp(-depth_m / k.fading_depth_m);
  for (double* amplitude :
       {&k.constant_m_s, &k.slow_m_s, &k.inertial_m_s, &k.recent_m_s, &k.noise_m_s})
    *amplitude *= left;
  return k;
}

/// Values of one level.
struct TextbookLevel {
  std::vector<double> hour;
  std::vector<Horizontal> value;
  std::vector<Horizontal> answer;
  std::vector<double> sigma;  ///< stated, of a component
};

struct Textbook {
  Eigen::VectorXcd mean;
  Eigen::MatrixXcd covariance;
  double chi_squared = 0;
  double log_evidence = 0;
};

inline Textbook textbook(const MemoryKernel& k, const TextbookLevel& level,
                         const std::vector<double>& later,
                         const std::vector<Horizontal>& answer_later) {
  std::vector<double> hour = level.hour;
  std::vector<Horizontal> answer = level.answer;
  hour.insert(hour.end(), later.begin(), later.end());
  answer.insert(answer.end(), answer_later.begin(), answer_later.end());
  const auto all = static_cast<Eigen::Index>(hour.size());
  const auto n = static_cast<Eigen::Index>(level.hour.size());
  Eigen::MatrixXcd joint(all, all);
  for (Eigen::Index i = 0; i < all; ++i) {
    for (Eigen::Index j = 0; j < all; ++j) {
      const auto a = static_cast<std::size_t>(i);
      const auto b = static_cast<std::size_t>(j);
      joint(i, j) = textbook_kernel(k, hour[a], hour[b], answer[a], answer[b]);
    }
    joint(i, i) += k.noise_m_s * k.noise_m_s;
    if (i < n && !level.sigma.empty())
      joint(i, i) += 2 * std::pow(level.sigma[static_cast<std::size_t>(i)], 2);
  }
  const Eigen::MatrixXcd of_values = joint.topLeftCorner(n, n);
  const Eigen::MatrixXcd cross = joint.bottomLeftCorner(all - n, n);
  const Eigen::MatrixXcd inverse = of_values.inverse();
  const Eigen::Map<const Eigen::VectorXcd> y(level.value.data(), n);
  Textbook out;
  out.mean = cross * inverse * y;
  out.covariance = joint.bottomRightCorner(all - n, all - n) - cross * inverse * cross.adjoint();
  out.chi_squared = (y.adjoint() * inverse * y).value().real();
  out.log_evidence = -out.chi_squared - std::log(of_values.determinant().real()) -
                     static_cast<double>(n) * std::log(std::acos(-1.0));
  return out;
}

}  // namespace slackwater::calibration
