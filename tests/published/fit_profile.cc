#include "tests/published/fit_profile.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "calibration/solve/determination.h"
#include "calibration/solve/parameter_set.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/current/coriolis.h"
#include "tests/published/profile_problem.h"
#include "tests/published/profile_starts.h"

namespace slackwater::calibration {
namespace {

constexpr std::size_t starts_per_form = 3;
constexpr std::size_t fewest_levels = 5;  // ten numbers for nine parameters

void check_level(const ProfileLevel& level) {
  if (std::isfinite(level.depth_m) && level.depth_m >= 0 &&
      std::isfinite(level.current_m_s.real()) && std::isfinite(level.current_m_s.imag())) {
    return;
  }
  refuse(
      formatted("profile level at depth {:g} m holds the current ({:g}, {:g}) m/s: expected a "
                "depth >= 0 and finite values; leave missing levels out",
                level.depth_m, level.current_m_s.real(), level.current_m_s.imag()));
}

void check(std::span<const ProfileLevel> levels, Angle latitude, const ProfileFitOptions& options) {
  if (levels.size() < fewest_levels) {
    refuse("profile has " + std::to_string(levels.size()) + " levels: expected at least " +
           std::to_string(fewest_levels) + " for the nine parameters of the mixed-layer profile");
  }
  std::vector<double> depths_m;
  for (const ProfileLevel& level : levels) {
    check_level(level);
    depths_m.push_back(level.depth_m);
  }
  std::sort(depths_m.begin(), depths_m.end());
  const auto twice = std::adjacent_find(depths_m.begin(), depths_m.end());
  if (twice != depths_m.end()) {
    refuse(formatted("profile has two levels at {:g} m: expected one instant, each depth once",
                     *twice));
  }
  if (!(options.sigma_m_s > 0)) refuse("sigma_m_s of a profile fit must be positive");
  if (is_equatorial(latitude)) {
    refuse("profile at latitude " + std::to_string(latitude.degrees()) +
           " degrees: nearer than 3 degrees to the equator an Ekman spiral has no finite scale");
  }
}

/// The lowest minimum of one form, over its starts.
ProfileMinimum best_minimum(ProfileForm form, std::span<const ProfileLevel> levels, Angle latitude,
                            double sigma_m_s, int& starts) {
  std::optional<ProfileMinimum> best;
  std::string failure;
  for (const ProfileStart& start :
       profile_starts(form, latitude, levels, sigma_m_s, starts_per_form)) {
    const ProfileMinimum m = minimise_profile(form, latitude, levels, sigma_m_s, start.estimate);
    ++starts;
    failure = m.termination;
    if (m.converged && (!best || m.cost < best->cost)) best = m;
  }
  if (!best) {
    throw Error(ErrorKind::not_converged, "form " + std::string(name_of(form)) + ": " + failure +
                                              "; look for levels whose current is not physical");
  }
  return *best;
}

std::vector<Horizontal> residuals_of(const MixedLayerProfile<double>& profile,
                                     std::span<const ProfileLevel> levels) {
  std::vector<Horizontal> residuals;
  for (const ProfileLevel& level : levels)
    residuals.push_back(level.current_m_s - to_horizontal(profile.at_depth(level.depth_m)));
  return residuals;
}

double root_mean_square(const std::vector<Horizontal>& values) {
  double sum = 0;
  for (const Horizontal& v : values) sum += std::norm(v);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double eps_about_mean(std::span<const ProfileLevel> levels) {
  Horizontal mean = 0;
  for (const ProfileLevel& level : levels) mean += level.current_m_s;
  mean /= static_cast<double>(levels.size());
  std::vector<Horizontal> about_mean;
  for (const ProfileLevel& level : levels) about_mean.push_back(level.current_m_s - mean);
  return root_mean_square(about_mean);
}

/// Share of the levels that is independent, (1 - r)/(1 + r) with r the correlation of neighbouring
/// residuals in depth (first-order memory).
double independent_share(std::vector<ProfileLevel> levels,
                         const MixedLayerProfile<double>& profile) {
  std::sort(levels.begin(), levels.end(),
            [](const ProfileLevel& a, const ProfileLevel& b) { return a.depth_m < b.depth_m; });
  const std::vector<Horizontal> e = residuals_of(profile, levels);
  double product = 0;
  double square = 0;
  for (std::size_t i = 0; i < e.size(); ++i) {
    square += std::norm(e[i]);
    if (i > 0) product += (e[i] * std::conj(e[i - 1])).real();
  }
  const double r = square > 0 ? std::clamp(product / square, 0.0, 0.9) : 0.0;
  return (1 - r) / (1 + r);
}

ProfileInformation posterior_covariance(const ProfileMinimum& minimum, const FittedProfile& fit,
                                        std::span<const ProfileLevel> levels, Angle latitude,
                                        double stated_sigma_m_s) {
  const double n = static_cast<double>(levels.size());
  const double free_numbers = 2 * n - static_cast<double>(profile_parameter_count);
  const double misfit_m_s = fit.eps_m_s * std::sqrt(n / free_numbers);  // of each component
  const double sigma_m_s = std::max(stated_sigma_m_s, misfit_m_s);
  const double share =
      independent_share(std::vector<ProfileLevel>(levels.begin(), levels.end()), fit.profile);
  ProfileInformation information = share * profile_information(minimum.form, latitude.radians() > 0,
                                                               levels, sigma_m_s, minimum.estimate);
  for (std::size_t i = 0; i < profile_parameter_count; ++i) {
    const double sigma = fit.parameters[i].prior_sigma;
    const auto row = static_cast<Eigen::Index>(i);
    information(row, row) += 1 / (sigma * sigma);
  }
  return information.llt().solve(ProfileInformation::Identity());
}

}  // namespace

FittedProfile fit_profile(std::span<const ProfileLevel> levels, Angle latitude,
                          const ProfileFitOptions& options) {
  check(levels, latitude, options);
  FittedProfile fit;
  std::optional<ProfileMinimum> best;
  for (const ProfileForm form : profile_forms) {
    if (options.form && form != *options.form) continue;
    const ProfileMinimum m = best_minimum(form, levels, latitude, options.sigma_m_s, fit.starts);
    const auto profile = profile_of(form, m.estimate.data(), latitude.radians() > 0);
    fit.considered.push_back({form, m.cost, root_mean_square(residuals_of(profile, levels))});
    if (best && best->cost <= m.cost) continue;
    best = m;
    fit.profile = profile;
    fit.eps_m_s = fit.considered.back().eps_m_s;
  }
  fit.form = best->form;
  fit.termination = best->termination;
  fit.eps_constant_m_s = eps_about_mean(levels);
  fit.parameters = profile_parameters(fit.form, latitude);
  const ProfileInformation covariance =
      posterior_covariance(*best, fit, levels, latitude, options.sigma_m_s);
  fit.covariance.assign(covariance.data(), covariance.data() + covariance.size());
  fit.warnings = judge_determination({best->estimate.begin(), best->estimate.end()}, covariance,
                                     fit.parameters);
  return fit;
}

}  // namespace slackwater::calibration
