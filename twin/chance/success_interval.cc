#include "twin/chance/success_interval.h"

#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

/// a log x, nothing for a = 0 whatever x is.
double times_log(double a, double x) { return a > 0 ? a * std::log(x) : 0; }

}  // namespace

SuccessInterval success_interval(std::size_t successes, std::size_t trials, double level) {
  expects(successes <= trials, "no more successes than trials");
  expects(level > 0 && level < 1, "a level between 0 and 1");
  const auto s = static_cast<double>(successes), n = static_cast<double>(trials);
  const double f = n - s;
  const double log_beta = std::lgamma(1 + s) + std::lgamma(1 + f) - std::lgamma(2 + n);
  const double most = -std::log1p(-level);
  const auto is_inside = [&](double p) {
    return log_beta - times_log(s, p) - times_log(f, 1 - p) < most;
  };
  const double best = n > 0 ? s / n : 0.5;
  // W falls up to the share of successes and rises after it.
  const auto edge = [&](double outside) {
    if (is_inside(outside)) return outside;
    double in = best, out = outside;
    constexpr int halvings = 60;
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (in + out);
      (is_inside(middle) ? in : out) = middle;
    }
    return out;
  };
  return {edge(0), edge(1)};
}

double next_success(std::size_t successes, std::size_t trials) {
  expects(successes <= trials, "no more successes than trials");
  return (static_cast<double>(successes) + 0.5) / (static_cast<double>(trials) + 1);
}

}  // namespace slackwater::twin
