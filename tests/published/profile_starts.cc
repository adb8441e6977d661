#include "tests/published/profile_starts.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "calibration/solve/parameter_set.h"

namespace slackwater::calibration {
namespace {

// Steps of 12 % in the depth of the base: finer than the native levels of any product.
constexpr int base_depth_steps = 36;
constexpr double shallowest_base_m = 4.0;
constexpr double deepest_base_m = 200.0;
constexpr std::array base_ratios{0.07, 0.15, 0.3};
constexpr std::array spiral_scales_m{5.0, 8.0, 12.0, 18.0, 27.0, 40.0, 60.0};

/// Two of the nine that belong to one free vector.
constexpr std::array vector_places{interior_at, slab_at, spiral_at, shear_at};

class LinearProblem {
 public:
  LinearProblem(ProfileForm form, Angle latitude, std::span<const ProfileLevel> levels,
                double sigma_m_s)
      : form_(form),
        is_northern_(latitude.radians() > 0),
        parameters_(profile_parameters(form, latitude)),
        vectors_(form == ProfileForm::sheared_interior ? 4 : 3),
        levels_(levels),
        sigma_m_s_(sigma_m_s),
        basis_(static_cast<Eigen::Index>(levels.size()), vectors_),
        observed_(static_cast<Eigen::Index>(levels.size())),
        ridge_(vectors_) {
    for (std::size_t i = 0; i < levels.size(); ++i)
      observed_(static_cast<Eigen::Index>(i)) = levels[i].current_m_s;
    for (Eigen::Index v = 0; v < vectors_; ++v) {
      const double sigma = parameters_[vector_places[static_cast<std::size_t>(v)]].prior_sigma;
      ridge_(v) = (sigma_m_s / sigma) * (sigma_m_s / sigma);
    }
  }

  /// Fills the vectors of `start` for its lengths, and the cost.
  void solve(ProfileStart& start) {
    fill_basis(shape_of(form_, start.estimate.data(), is_northern_));
    const Eigen::MatrixXcd normal =
        basis_.adjoint() * basis_ + Eigen::MatrixXcd(ridge_.cast<Horizontal>().asDiagonal());
    const Eigen::VectorXcd vectors = normal.ldlt().solve(basis_.adjoint() * observed_);
    const double misfit = (observed_ - basis_ * vectors).squaredNorm();
    const double penalty = ridge_.dot(vectors.cwiseAbs2());
    start.cost = 0.5 * (misfit + penalty) / (sigma_m_s_ * sigma_m_s_) + length_priors(start);
    for (Eigen::Index v = 0; v < vectors_; ++v) {
      const std::size_t place = vector_places[static_cast<std::size_t>(v)];
      start.estimate[place] = vectors(v).real();
      start.estimate[place + 1] = vectors(v).imag();
    }
  }

 private:
  void fill_basis(const MixedLayerShape<double>& shape) {
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      const double depth_m = levels_[i].depth_m;
      const MixedLayerShare<double> share = shape.at_depth(depth_m);
      const auto row = static_cast<Eigen::Index>(i);
      basis_(row, 0) = 1.0;
      basis_(row, 1) = share.slab;
      basis_(row, 2) = to_horizontal(share.spiral);
      if (vectors_ == 4) basis_(row, 3) = depth_m;
    }
  }

  [[nodiscard]] double length_priors(const ProfileStart& start) const {
    double sum = 0;
    for (std::size_t i = 0; i < profile_parameter_count; ++i) {
      if (!parameters_[i].is_logarithmic) continue;
      const double residual = prior_of(parameters_[i]).residual(start.estimate[i]);
      sum += 0.5 * residual * residual;
    }
    return sum;
  }

  ProfileForm form_;
  bool is_northern_;
  std::vector<Parameter> parameters_;
  Eigen::Index vectors_;
  std::span<const ProfileLevel> levels_;
  double sigma_m_s_;
  Eigen::MatrixXcd basis_;
  Eigen::VectorXcd observed_;
  Eigen::VectorXd ridge_;
};

/// The best start with this depth of the base.
ProfileStart best_at(double base_depth_m, ProfileForm form, LinearProblem& problem) {
  ProfileStart start;
  start.estimate[log_base_depth_at] = std::log(base_depth_m);
  if (form == ProfileForm::sheared_interior) {
    problem.solve(start);
    return start;
  }
  ProfileStart best;
  best.cost = std::numeric_limits<double>::infinity();
  for (const double ratio : base_ratios) {
    for (const double scale_m : spiral_scales_m) {
      start.estimate[log_base_ratio_at] = std::log(ratio);
      start.estimate[log_spiral_scale_at] = std::log(scale_m);
      problem.solve(start);
      if (start.cost < best.cost) best = start;
    }
  }
  return best;
}

}  // namespace

std::vector<ProfileStart> profile_starts(ProfileForm form, Angle latitude,
                                         std::span<const ProfileLevel> levels, double sigma_m_s,
                                         std::size_t count) {
  LinearProblem problem(form, latitude, levels, sigma_m_s);
  std::vector<ProfileStart> along;
  const double step = std::log(deepest_base_m / shallowest_base_m) / (base_depth_steps - 1);
  along.reserve(base_depth_steps);
  for (int i = 0; i < base_depth_steps; ++i)
    along.push_back(best_at(shallowest_base_m * std::exp(step * i), form, problem));
  std::vector<ProfileStart> starts;
  for (std::size_t i = 0; i < along.size(); ++i) {
    const bool falls = i == 0 || along[i].cost < along[i - 1].cost;
    const bool rises = i + 1 == along.size() || along[i].cost <= along[i + 1].cost;
    if (falls && rises) starts.push_back(along[i]);
  }
  std::stable_sort(starts.begin(), starts.end(),
                   [](const ProfileStart& a, const ProfileStart& b) { return a.cost < b.cost; });
  if (starts.size() > count) starts.resize(count);
  return starts;
}

}  // namespace slackwater::calibration
