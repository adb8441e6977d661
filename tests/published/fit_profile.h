#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/published/profile_form.h"
#include "tests/published/profile_level.h"

namespace slackwater::calibration {

struct ProfileFitOptions {
  /// Unset: the form that explains the profile better.
  std::optional<ProfileForm> form;
  /// What each component of the current differs by from the best profile of this family, at best;
  /// the profile's own misfit replaces it in the covariance where that is larger.
  double sigma_m_s = 0.01;
};

/// One form, tried.
struct ProfileCandidate {
  ProfileForm form = ProfileForm::free_scales;
  double cost = 0;     ///< half the sum of squares, whitened: misfit and priors
  double eps_m_s = 0;  ///< sqrt(mean |observed - fitted|^2)
};

/// A fitted profile.
struct FittedProfile {
  ProfileForm form = ProfileForm::free_scales;
  MixedLayerProfile<double> profile;  ///< at_depth answers at any depth
  std::vector<Parameter> parameters;  ///< nine, in the order of `ProfileIndex`
  /// 9 x 9, row-major, in the terms of each parameter's sigma (logarithms where so).
  std::vector<double> covariance;
  double eps_m_s = 0;           ///< sqrt(mean |observed - fitted|^2) over the levels, unweighted
  double eps_constant_m_s = 0;  ///< the same about the mean vector of the levels
  std::vector<ProfileCandidate> considered;  ///< every form tried, in the order of the enumeration
  int starts = 0;                            ///< solved in all
  std::string termination;                   ///< one sentence an operator can read
  std::vector<std::string> warnings;
};

/// Fits the mixed-layer profile (tests/published/mixed_layer_profile.h) to one instant.
///
/// From each of a fixed set of starts (profile_starts.h) one Ceres problem: a whitened residual for
/// each level, a prior for each parameter, bounds; the lowest minimum is taken. Both forms have
/// nine real parameters, so that AIC and BIC differ between them by the cost alone: the form of
/// lower cost is taken, and `considered` reports both. (Laplace's evidence, tried on real profiles,
/// chose otherwise on a third of the dates and moved no median.) A parameter on a bound, or that
/// the levels say little about, is flagged and warned of.
///
/// The covariance is (J'J/sigma^2 + prior information)^-1, sigma the larger of the stated one and
/// the misfit, and the levels counted as the fewer independent ones they are worth where neighbours
/// err alike.
///
/// @param levels  at least five, distinct depths, any order
/// @throws Error(invalid_input) for fewer levels, a depth that is negative or appears twice, a
///         value that is not finite, a sigma that is not positive, |latitude| < 3 degrees;
///         Error(not_converged) where no start led to a minimum.
/// Deterministic, thread-safe. About 10 ms for 24 levels.
[[nodiscard]] FittedProfile fit_profile(std::span<const ProfileLevel> levels, Angle latitude,
                                        const ProfileFitOptions& options = {});

}  // namespace slackwater::calibration
