#include "twin/risk/height_errors.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/numbers/ascends.h"
#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

constexpr double waves = 1000;
constexpr double rare = 1e-4;

/// The place of x among ascending knots, held at their ends.
struct Between {
  std::size_t index = 0;
  double share = 0;  ///< of the knot after it
};
Between between(double x, const std::vector<double>& knots) noexcept {
  if (knots.size() < 2) return {};
  const double held = std::clamp(x, knots.front(), knots.back());
  std::size_t i = 0;
  while (i + 2 < knots.size() && held > knots[i + 1]) ++i;
  return {i, (held - knots[i]) / (knots[i + 1] - knots[i])};
}

/// That the largest of the waves of a sea is higher.
double surpassed(double height_m, double significant_m) {
  if (!(significant_m > 0)) return 0;
  const double ratio = height_m / significant_m;
  const double one = std::exp(-2 * ratio * ratio);
  return one >= 1 ? 1 : -std::expm1(waves * std::log1p(-one));
}

/// The same where the significant height is known but for a normal error: the midpoint rule over
/// seven deviations either way.
double surpassed(double height_m, double mean_m, double sigma_m) {
  if (!(sigma_m > 0)) return surpassed(height_m, mean_m);
  constexpr int parts = 700;
  constexpr double reach = 7;
  constexpr double step = 2 * reach / parts;
  double sum = 0;
  for (int i = 0; i < parts; ++i) {
    const double z = -reach + (i + 0.5) * step;
    sum += std::exp(-0.5 * z * z) * surpassed(height_m, mean_m + sigma_m * z);
  }
  return sum * step / std::sqrt(2 * constants::pi);
}

/// The height that is surpassed with probability `rare`.
template <typename Probability>
double rare_height(double low_m, double high_m, const Probability& probability) {
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i) {
    const double middle_m = 0.5 * (low_m + high_m);
    (probability(middle_m) > rare ? low_m : high_m) = middle_m;
  }
  return 0.5 * (low_m + high_m);
}

}  // namespace

HeightError HeightErrors::at(double height_m, double lead_h) const noexcept {
  const Between h = between(height_m, heights_m);
  const Between l = between(lead_h, leads_h);
  const auto mixed = [](const HeightError& a, const HeightError& b, double share) {
    return HeightError{(1 - share) * a.bias_m + share * b.bias_m,
                       (1 - share) * a.sigma_m + share * b.sigma_m};
  };
  const auto at_height = [&](std::size_t row) {
    const auto& errors = by_height[row];
    return mixed(errors[l.index], errors[std::min(l.index + 1, errors.size() - 1)], l.share);
  };
  HeightError error =
      mixed(at_height(h.index), at_height(std::min(h.index + 1, by_height.size() - 1)), h.share);
  const double part = std::min(1.0, std::max(0.0, height_m) / heights_m.front());
  error.bias_m *= part;
  error.sigma_m *= part;
  return error;
}

HeightErrors read_height_errors(const Config& config) {
  HeightErrors errors;
  errors.name = config.text("name");
  errors.source = config.text("source");
  errors.status = config.optional_text("status").value_or("");
  errors.leads_h = config.numbers("leads_h", {0, 400});
  if (errors.leads_h.empty() || !ascends(errors.leads_h))
    config.refuse("leads_h", "expected one lead or more, ascending");
  for (const Config& entry : config.children("heights")) {
    errors.heights_m.push_back(entry.number("height_m", {0.05, 20}));
    const std::vector<double> bias_m = entry.numbers("bias_m", {-5, 5});
    const std::vector<double> sigma_m = entry.numbers("sigma_m", {0, 10});
    for (const auto& [key, values] : {std::pair{"bias_m", &bias_m}, std::pair{"sigma_m", &sigma_m}})
      if (values->size() != errors.leads_h.size())
        entry.refuse(key, formatted("found {} numbers, expected {}, one for each of `leads_h`",
                                    values->size(), errors.leads_h.size()));
    auto& row = errors.by_height.emplace_back();
    for (std::size_t i = 0; i < bias_m.size(); ++i) row.push_back({bias_m[i], sigma_m[i]});
  }
  if (errors.heights_m.empty() || !ascends(errors.heights_m))
    config.refuse("heights", "expected one height or more, ascending");
  config.expect_all_read();
  return errors;
}

HeightErrors with_verified(HeightErrors published, const std::vector<VerifiedHeights>& verified) {
  const HeightErrors prior = published;
  std::vector<std::string> named;
  for (const VerifiedHeights& own : verified) {
    if (own.forecasts < enough_forecasts || !(own.mean_height_m > 0) || !(own.sigma_m > 0))
      continue;
    const HeightError there = prior.at(own.mean_height_m, 0.5 * (own.from_h + own.to_h));
    bool is_used = false;
    for (std::size_t l = 0; l < prior.leads_h.size(); ++l) {
      if (prior.leads_h[l] <= own.from_h || prior.leads_h[l] > own.to_h) continue;
      is_used = true;
      for (auto& row : published.by_height) {
        row[l].sigma_m *= own.sigma_m / there.sigma_m;
        row[l].bias_m += own.bias_m - there.bias_m;
      }
    }
    if (is_used)
      named.push_back(
          formatted("{} own forecasts at {:g} to {:g} h", own.forecasts, own.from_h, own.to_h));
  }
  if (named.empty()) {
    published.name +=
        " (fewer than " + std::to_string(enough_forecasts) + " own forecasts are verified)";
    return published;
  }
  published.name = joined(named, ", ") + "; otherwise " + prior.name;
  published.source = "verification of own forecasts; " + prior.source;
  return published;
}

double alpha_by_errors(double limit_m, const HeightError& error) {
  expects(limit_m > 0, "a limit above 0");
  const double bias_m = error.bias_m > 0 ? 0.5 * error.bias_m : error.bias_m;
  const double mean_m = limit_m - bias_m;
  const double known_m =
      rare_height(0, 10 * limit_m, [&](double h) { return surpassed(h, limit_m); });
  const double unsure_m =
      rare_height(0, 10 * (limit_m + std::abs(bias_m) + 5 * error.sigma_m),
                  [&](double h) { return surpassed(h, mean_m, error.sigma_m); });
  return std::min(1.0, known_m / unsure_m);
}

}  // namespace slackwater::twin
