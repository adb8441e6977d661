#include "ingest/cf/axis_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "fields/base/error.h"
#include "fields/base/turn.h"

namespace slackwater::ingest {
namespace {

// A cell that stands alone is 10 km wide (fields/docs/conventions.md), about 0.045 degrees either
// side.
constexpr double lone_half_cell_deg = 0.045;

void expect_finite(const std::vector<double>& values, double limit, const char* what) {
  if (values.empty())
    refuse(std::string("the ") + what + " axis is empty; expected at least one cell");
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(std::abs(values[i]) <= limit)) {
      refuse(std::string(what) + " " + std::to_string(i) + " is " + std::to_string(values[i]) +
             "; expected within +-" + std::to_string(static_cast<int>(limit)) + " degrees");
    }
  }
}

/// Ascending order of a strictly monotonic axis.
AxisOrder monotonic(std::vector<double> values, const char* what) {
  AxisOrder order;
  order.values = std::move(values);
  order.source.resize(order.values.size());
  std::iota(order.source.begin(), order.source.end(), std::size_t{0});
  if (order.values.size() > 1 && order.values[1] < order.values[0]) {
    std::reverse(order.values.begin(), order.values.end());
    std::reverse(order.source.begin(), order.source.end());
  }
  for (std::size_t i = 1; i < order.values.size(); ++i) {
    if (!(order.values[i] > order.values[i - 1])) {
      refuse(std::string("the ") + what + " axis is not monotonic near index " +
             std::to_string(order.source[i]) + " (" + std::to_string(order.values[i - 1]) + ", " +
             std::to_string(order.values[i]) + "); expected a rectilinear grid");
    }
  }
  return order;
}

double half_cell(const std::vector<double>& values, bool at_end) {
  const std::size_t n = values.size();
  if (n < 2) return lone_half_cell_deg;
  return 0.5 * (at_end ? values[n - 1] - values[n - 2] : values[1] - values[0]);
}

struct Interval {
  double low = 0;
  double high = 0;
};

Interval extent(const std::vector<double>& values) {
  return {values.front() - half_cell(values, false), values.back() + half_cell(values, true)};
}

void keep(AxisOrder& order, std::size_t first, std::size_t last) {
  const auto cut = [&](auto& list) {
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(last + 1), list.end());
    list.erase(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(first));
  };
  cut(order.values);
  cut(order.source);
}

/// Keeps the places inside [low, high] and one either side. False if the interval misses the axis.
bool keep_inside(AxisOrder& order, const Interval& wanted) {
  const Interval whole = extent(order.values);
  if (wanted.high < whole.low || wanted.low > whole.high) return false;
  const auto begin = order.values.begin();
  const auto first = std::lower_bound(begin, order.values.end(), wanted.low) - begin;
  const auto last = std::upper_bound(begin, order.values.end(), wanted.high) - begin;
  const auto size = static_cast<std::ptrdiff_t>(order.values.size());
  keep(order, static_cast<std::size_t>(std::max<std::ptrdiff_t>(first - 1, 0)),
       static_cast<std::size_t>(std::min(last, size - 1)));
  return true;
}

std::string shown(double degrees) {
  std::string text = std::to_string(degrees);
  text.resize(text.size() - 2);
  return text;
}

[[noreturn]] void refuse_cut(const char* what, const Interval& wanted,
                             const std::vector<double>& values) {
  refuse(std::string("the cut selects nothing: it spans ") + what + " " + shown(wanted.low) +
         " to " + shown(wanted.high) + ", the file " + shown(values.front()) + " to " +
         shown(values.back()) + "; give a --bbox or --site inside the file");
}

/// Adds or subtracts whole turns so that steps between neighbours are the short way round.
std::vector<double> unwrapped(const std::vector<double>& degrees) {
  std::vector<double> turned = degrees;
  for (std::size_t i = 1; i < turned.size(); ++i) {
    const double step = degrees[i] - degrees[i - 1];
    turned[i] = turned[i - 1] + step - 360.0 * std::round(step / 360.0);
  }
  return turned;
}

/// Whether the axis goes around the globe; a last column that repeats the first is dropped.
bool is_around_the_globe(AxisOrder& order) {
  const std::size_t n = order.values.size();
  if (n < 4) return false;
  const double span = order.values.back() - order.values.front();
  const double step = span / static_cast<double>(n - 1);
  if (std::abs(span - 360.0) < 0.5 * step) {
    order.values.pop_back();
    order.source.pop_back();
    return true;
  }
  if (span > 360.0) refuse("the longitudes span " + shown(span) + " degrees; expected at most 360");
  return std::abs(span + step - 360.0) < 0.5 * step;
}

/// Starts the circle at place `start`.
void rotate(AxisOrder& order, std::size_t start) {
  for (std::size_t i = 0; i < start; ++i) order.values[i] += 360.0;
  const auto shift = static_cast<std::ptrdiff_t>(start);
  std::rotate(order.values.begin(), order.values.begin() + shift, order.values.end());
  std::rotate(order.source.begin(), order.source.begin() + shift, order.source.end());
}

/// The place from which the way east to `west_deg` is shortest.
std::size_t place_west_of(const AxisOrder& order, double west_deg) {
  const auto way = [&](double value) { return compass_deg(west_deg - value); };
  const auto nearest = std::min_element(order.values.begin(), order.values.end(),
                                        [&](double a, double b) { return way(a) < way(b); });
  return static_cast<std::size_t>(nearest - order.values.begin());
}

void put_first_in_range(AxisOrder& order) {
  const double turn = 360.0 * std::floor((order.values.front() + 180.0) / 360.0);
  if (turn != 0.0) {
    for (double& value : order.values) value -= turn;
  }
}

}  // namespace

std::vector<AxisOrder::Run> AxisOrder::runs(std::size_t first, std::size_t count) const {
  std::vector<Run> found;
  for (std::size_t i = first; i < first + count;) {
    std::size_t end = i + 1;
    const bool reversed = end < first + count && source[end] + 1 == source[i];
    while (end < first + count &&
           (reversed ? source[end] + 1 == source[end - 1] : source[end] == source[end - 1] + 1))
      ++end;
    found.push_back({i, end - i, reversed ? source[end - 1] : source[i], reversed});
    i = end;
  }
  return found;
}

AxisOrder level_axis(const std::vector<double>& levels_m) {
  AxisOrder order;
  order.source.resize(levels_m.size());
  std::iota(order.source.begin(), order.source.end(), std::size_t{0});
  for (const double level : levels_m) {
    if (!(std::abs(level) < 2e4))
      refuse("a level lies at " + std::to_string(level) +
             " m; expected metres from the sea surface");
  }
  std::sort(order.source.begin(), order.source.end(),
            [&](std::size_t a, std::size_t b) { return levels_m[a] < levels_m[b]; });
  for (const std::size_t i : order.source) order.values.push_back(levels_m[i]);
  const auto twin = std::adjacent_find(order.values.begin(), order.values.end());
  if (twin != order.values.end())
    refuse("two levels lie at " + std::to_string(*twin) + " m; expected levels that differ");
  return order;
}

AxisOrder latitude_axis(const std::vector<double>& latitudes_deg,
                        const std::optional<BoundingBox>& cut) {
  expect_finite(latitudes_deg, 90.0, "latitude");
  AxisOrder order = monotonic(latitudes_deg, "latitude");
  if (cut) {
    const Interval wanted{cut->south_deg, cut->north_deg};
    if (!keep_inside(order, wanted)) refuse_cut("latitude", wanted, order.values);
  }
  return order;
}

AxisOrder longitude_axis(const std::vector<double>& longitudes_deg,
                         const std::optional<BoundingBox>& cut) {
  expect_finite(longitudes_deg, 720.0, "longitude");
  AxisOrder order = monotonic(unwrapped(longitudes_deg), "longitude");
  const bool circle = is_around_the_globe(order);
  const double width =
      cut ? (cut->east_deg < cut->west_deg ? cut->east_deg + 360.0 : cut->east_deg) - cut->west_deg
          : 360.0;
  const bool all = width >= 360.0;
  if (circle)
    rotate(order, all ? (place_west_of(order, -180.0) + 1) % order.values.size()
                      : place_west_of(order, cut->west_deg));
  put_first_in_range(order);
  // A column at exactly -180 is its own neighbour to the west.
  if (circle && all && order.values.back() >= 180.0) {
    rotate(order, order.values.size() - 1);
    put_first_in_range(order);
  }
  if (all) return order;
  // The box may lie a whole turn away from the axis: take the turn that covers most of it.
  const Interval whole = extent(order.values);
  Interval best{cut->west_deg, cut->west_deg + width};
  double best_overlap = -360.0;
  for (int turn = -3; turn <= 3; ++turn) {
    const Interval wanted{cut->west_deg + 360.0 * turn, cut->west_deg + 360.0 * turn + width};
    const double overlap = std::min(whole.high, wanted.high) - std::max(whole.low, wanted.low);
    if (overlap > best_overlap) {
      best_overlap = overlap;
      best = wanted;
    }
  }
  if (!keep_inside(order, best)) refuse_cut("longitude", best, order.values);
  put_first_in_range(order);
  return order;
}

}  // namespace slackwater::ingest
