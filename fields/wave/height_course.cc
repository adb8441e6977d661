#include "fields/wave/height_course.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fields/base/check.h"

namespace slackwater {

HeightCourse::HeightCourse(double step_s, std::vector<double> factors)
    : step_s_(step_s), factors_(std::move(factors)) {
  expects(step_s_ > 0 && std::isfinite(step_s_), "the nodes of a height are some time apart");
  expects(std::all_of(factors_.begin(), factors_.end(),
                      [](double factor) { return factor >= 0 && std::isfinite(factor); }),
          "a factor on a height is a number, 0 or more");
}

HeightCourse HeightCourse::led(std::optional<double> to, double from_s, double over_s) const {
  expects(!to || (*to >= 0 && std::isfinite(*to)), "a factor on a height is a number, 0 or more");
  HeightCourse course = *this;
  course.lead_.lead(to, from_s, over_s);
  return course;
}

double HeightCourse::at(double t_s) const noexcept { return lead_.of(at_nodes(t_s), t_s); }

double HeightCourse::at_nodes(double t_s) const noexcept {
  if (factors_.empty()) return 1;
  const double steps = t_s / step_s_;
  if (!(steps > 0)) return factors_.front();
  const auto last = static_cast<double>(factors_.size() - 1);
  if (steps >= last) return factors_.back();
  const auto low = static_cast<std::size_t>(steps);
  const double share = steps - static_cast<double>(low);
  return factors_[low] + share * (factors_[low + 1] - factors_[low]);
}

}  // namespace slackwater
