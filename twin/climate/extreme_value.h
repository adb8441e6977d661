#pragma once
#include <optional>
#include <vector>

namespace slackwater::twin {

/// A generalised Pareto distribution of what exceeds a threshold, y >= 0:
///
///   P(Y > y) = (1 + shape y / scale)^(-1/shape),   exp(-y / scale) for shape 0
///
/// The shape is Coles' xi (2001, section 4.2), the negative of Hosking's k. Below 0 nothing exceeds
/// `greatest`; from 0.5 on it has no variance.
struct Pareto {
  double scale = 1;  ///< in the unit of the values, > 0
  double shape = 0;

  /// What is exceeded with a probability. @param survival  in (0, 1]
  [[nodiscard]] double exceeded_with(double survival) const noexcept;
  /// The end of what is possible; infinite for a shape of 0 and above.
  [[nodiscard]] double greatest() const noexcept;
};

/// A generalised extreme-value distribution of maxima; of shape 0 Gumbel's:
///
///   P(X <= x) = exp(-(1 + shape (x - location) / scale)^(-1/shape)),
///               exp(-exp(-(x - location) / scale)) for shape 0
///
/// Source: Coles (2001), An Introduction to Statistical Modeling of Extreme Values, section 3.1.
struct ExtremeValue {
  double location = 0;
  double scale = 1;
  double shape = 0;

  /// What is not exceeded with a probability. @param probability  in (0, 1)
  [[nodiscard]] double not_exceeded_with(double probability) const noexcept;
  /// The end of what is possible; infinite for a shape of 0 and above.
  [[nodiscard]] double greatest() const noexcept;
};

/// The first moments of a sample in order, in linear combinations of its order statistics, without
/// bias: the mean, half the mean difference of two, and how lopsided three are.
///
///   l1 = b0,  l2 = 2 b1 - b0,  l3 = 6 b2 - 6 b1 + b0,
///   b_r = 1/n sum over x_(i) ascending of (i-1)...(i-r) / ((n-1)...(n-r)) x_(i)
///
/// They are the same thing as probability-weighted moments.
/// Source: Hosking (1990), L-moments, J. R. Statist. Soc. B 52, 105-124.
struct LinearMoments {
  double l1 = 0;
  double l2 = 0;
  double l3 = 0;
};
/// @param values  3 at least, in any order
[[nodiscard]] LinearMoments linear_moments(std::vector<double> values);

// Fits by probability-weighted moments: in closed form, for small samples less wide than maximum
// likelihood, and with an answer for every sample. Nothing where all values are alike.

/// scale = l1 (l1/l2 - 1), shape = 2 - l1/l2. For shapes below 0.5.
/// Source: Hosking and Wallis (1987), Parameter and quantile estimation for the generalized Pareto
/// distribution, Technometrics 29, 339-349.
/// @param excesses  over the threshold, > 0; 3 at least
[[nodiscard]] std::optional<Pareto> fitted_pareto(std::vector<double> excesses);

/// scale = l2 / ln 2, location = l1 - gamma scale, with Euler's gamma.
/// @param maxima  3 at least
[[nodiscard]] std::optional<ExtremeValue> fitted_gumbel(std::vector<double> maxima);

/// With k = -shape from k = 7.8590 c + 2.9554 c^2, c = 2 / (3 + l3/l2) - ln 2 / ln 3, within 0.0009
/// for shapes of -0.5 to 0.5.
/// Source: Hosking, Wallis and Wood (1985), Technometrics 27, 251-261.
/// @param maxima  3 at least
[[nodiscard]] std::optional<ExtremeValue> fitted_extreme_value(std::vector<double> maxima);

}  // namespace slackwater::twin
