#include "api/door/edr/sample/answer_shape.h"

#include <algorithm>

#include "fields/base/check.h"

namespace slackwater::api::edr {
namespace {

bool is_one_or_none(std::size_t length) { return length <= 1; }

/// Whether an axis of a trajectory has an entry for each vertex, for all, or none.
bool fits(std::size_t length, std::size_t vertices) {
  return is_one_or_none(length) || length == vertices;
}

void expect_axes(const Coverage& c) {
  expects(!c.longitude_deg.empty() && !c.latitude_deg.empty(), "a coverage has a place");
  const std::size_t times = c.time.size();
  const std::size_t levels = c.vertical_m.size();
  if (c.domain == DomainType::trajectory) {
    const std::size_t vertices = c.longitude_deg.size();
    expects(
        c.latitude_deg.size() == vertices && times > 0 && fits(times, vertices) &&
            fits(levels, vertices),
        "a trajectory has a latitude and a time for each vertex, and as many levels, one or none");
    return;
  }
  if (c.domain == DomainType::grid) return;
  expects(c.longitude_deg.size() == 1 && c.latitude_deg.size() == 1, "a point has one place");
  expects(c.domain == DomainType::point_series ? times > 0 : is_one_or_none(times),
          "a series has times, a point or profile one or none");
  expects(c.domain == DomainType::vertical_profile ? levels > 0 : is_one_or_none(levels),
          "a profile has levels, a point or series one or none");
}

}  // namespace

AxisLengths shape_of(const Coverage& coverage) noexcept {
  if (coverage.domain == DomainType::trajectory) return {1, 1, 1, coverage.longitude_deg.size()};
  return {std::max<std::size_t>(1, coverage.time.size()),
          std::max<std::size_t>(1, coverage.vertical_m.size()), coverage.latitude_deg.size(),
          coverage.longitude_deg.size()};
}

void expect_whole(const Answer& answer) {
  for (const Coverage& coverage : answer.coverages) {
    expects(coverage.domain == answer.coverages.front().domain,
            "all coverages of an answer have one domain type");
    expect_axes(coverage);
    expects(coverage.vertical_m.empty() || answer.vertical != Vertical::none,
            "an answer with levels says what they count");
    expects(coverage.values.size() == answer.parameters.size(), "values of each parameter");
    const std::size_t size = shape_of(coverage).size();
    for (const auto& values : coverage.values) {
      expects(values.size() == size, "a value at each point of the domain");
    }
  }
}

bool has_time(const Answer& answer) noexcept {
  return std::any_of(answer.coverages.begin(), answer.coverages.end(),
                     [](const Coverage& c) { return !c.time.empty(); });
}

bool has_vertical(const Answer& answer) noexcept {
  return std::any_of(answer.coverages.begin(), answer.coverages.end(),
                     [](const Coverage& c) { return !c.vertical_m.empty(); });
}

std::string_view vertical_name(const Answer& answer) noexcept {
  return answer.vertical == Vertical::height_up ? "height_m" : "depth_m";
}

}  // namespace slackwater::api::edr
