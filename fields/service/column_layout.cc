#include "fields/service/column_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr double lone_reach_m = 5000.0;
constexpr double metres_per_degree = constants::earth_radius_m * constants::pi / 180.0;
/// Coordinates read from float files miss a crossing by up to 1e-5 degrees.
constexpr double same_deg = 2e-5;
/// Within this share of a cell a place is the centre, so that a column's own place is that column.
constexpr double centre_tolerance = 1e-3;

/// The longitude in [-180, 180) about the origin.
double turned(double longitude_deg, double origin_deg) noexcept {
  double x = longitude_deg - origin_deg;
  if (x < -180.0 || x >= 180.0) x -= 360.0 * std::floor((x + 180.0) / 360.0);
  return x;
}

std::vector<double> distinct(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  std::vector<double> out;
  for (const double value : values) {
    if (out.empty() || value - out.back() > same_deg) out.push_back(value);
  }
  return out;
}

std::size_t nearest(const std::vector<double>& axis, double value) {
  const auto above = std::lower_bound(axis.begin(), axis.end(), value - same_deg);
  // The difference may round to the other side of `same_deg` than in `distinct`.
  return std::min(static_cast<std::size_t>(above - axis.begin()), axis.size() - 1);
}

}  // namespace

ColumnLayout::Axis::Place ColumnLayout::Axis::at(double value) const noexcept {
  const std::size_t n = centre.size();
  if (!(value >= centre.front() - reach_low && value <= centre.back() + reach_high)) return {};
  if (n == 1 || value <= centre.front()) return {0, 0, true};
  if (value >= centre.back()) return {n - 2, 1, true};
  // Steps are nearly equal: begin where an even axis would have it.
  auto low = static_cast<std::size_t>((value - centre.front()) * per_span);
  low = std::min(low, n - 2);
  while (low > 0 && value < centre[low]) --low;
  while (low + 2 < n && value >= centre[low + 1]) ++low;
  double upper = (value - centre[low]) * per_step[low];
  if (upper < centre_tolerance) upper = 0;
  if (upper > 1 - centre_tolerance) upper = 1;
  return {low, upper, true};
}

ColumnLayout::ColumnLayout(std::span<const GeoPoint> columns) {
  expects(!columns.empty(), "a forecast has a column");
  origin_deg_ = columns.front().longitude_deg();
  std::vector<double> longitude;
  std::vector<double> latitude;
  for (const GeoPoint& point : columns) {
    longitude.push_back(turned(point.longitude_deg(), origin_deg_));
    latitude.push_back(point.latitude_deg());
  }
  x_.centre = distinct(longitude);
  y_.centre = distinct(latitude);
  const double middle_deg = 0.5 * (y_.centre.front() + y_.centre.back());
  metres_per_degree_east_ =
      metres_per_degree * std::max(0.01, std::cos(middle_deg * constants::pi / 180.0));
  const std::size_t crossings = x_.centre.size() * y_.centre.size();
  // Two columns anywhere stand on half of four crossings, and are no grid.
  is_grid_ = 2 * columns.size() > crossings;
  const auto set_reach = [&](Axis& axis, double lone_deg) {
    const std::size_t n = axis.centre.size();
    const bool is_lone = n == 1 || !is_grid_;
    axis.reach_low = is_lone ? lone_deg : 0.5 * (axis.centre[1] - axis.centre[0]) * (1 + 1e-9);
    axis.reach_high =
        is_lone ? lone_deg : 0.5 * (axis.centre[n - 1] - axis.centre[n - 2]) * (1 + 1e-9);
    for (std::size_t i = 0; i + 1 < n; ++i)
      axis.per_step.push_back(1 / (axis.centre[i + 1] - axis.centre[i]));
    if (n > 1)
      axis.per_span = static_cast<double>(n - 1) / (axis.centre.back() - axis.centre.front());
  };
  set_reach(x_, lone_reach_m / metres_per_degree_east_);
  set_reach(y_, lone_reach_m / metres_per_degree);
  box_ = {normalised_longitude_deg(origin_deg_ + x_.centre.front() - x_.reach_low),
          std::max(-90.0, y_.centre.front() - y_.reach_low),
          normalised_longitude_deg(origin_deg_ + x_.centre.back() + x_.reach_high),
          std::min(90.0, y_.centre.back() + y_.reach_high)};
  if (is_grid_) {
    column_.assign(crossings, none);
    for (std::size_t i = 0; i < columns.size(); ++i)
      column_[nearest(y_.centre, latitude[i]) * x_.centre.size() +
              nearest(x_.centre, longitude[i])] = static_cast<std::uint32_t>(i);
    lay_cells();
    return;
  }
  for (std::size_t i = 0; i < columns.size(); ++i)
    point_.push_back({longitude[i] * metres_per_degree_east_, latitude[i] * metres_per_degree});
}

void ColumnLayout::lay_cells() {
  const std::size_t width = x_.centre.size();
  for (std::size_t j = 0; j + 1 < y_.centre.size(); ++j) {
    for (std::size_t i = 0; i + 1 < width; ++i) {
      const std::uint32_t* corner = &column_[j * width + i];
      std::array<std::uint32_t, 4> cell{corner[0], corner[1], corner[width], corner[width + 1]};
      if (std::find(cell.begin(), cell.end(), none) != cell.end()) cell[0] = none;
      cell_.push_back(cell);
    }
  }
}

ColumnStencil ColumnLayout::at(double longitude_deg, double latitude_deg) const noexcept {
  ColumnStencil stencil;
  if (!std::isfinite(longitude_deg) || !(std::abs(latitude_deg) <= 90.0)) return stencil;
  const double x = turned(longitude_deg, origin_deg_);
  if (!is_grid_) return at_scattered(x * metres_per_degree_east_, latitude_deg * metres_per_degree);
  const Axis::Place column = x_.at(x);
  const Axis::Place row = y_.at(latitude_deg);
  if (!column.is_inside || !row.is_inside) return stencil;
  stencil.is_inside = true;
  const bool is_within = column.upper > 0 && column.upper < 1 && row.upper > 0 && row.upper < 1;
  if (is_within) {  // most places are among four columns of water
    const auto& cell = cell_[row.low * (x_.centre.size() - 1) + column.low];
    if (cell[0] != none) {
      stencil.column = cell;
      stencil.weight = {(1 - row.upper) * (1 - column.upper), (1 - row.upper) * column.upper,
                        row.upper * (1 - column.upper), row.upper * column.upper};
      stencil.count = 4;
      return stencil;
    }
  }
  double sum = 0;
  for (const std::size_t j : {0U, 1U}) {
    for (const std::size_t i : {0U, 1U}) {
      const double weight =
          (j == 0 ? 1 - row.upper : row.upper) * (i == 0 ? 1 - column.upper : column.upper);
      if (!(weight > 0)) continue;
      const std::uint32_t found = column_[(row.low + j) * x_.centre.size() + column.low + i];
      if (found == none) continue;
      stencil.column[stencil.count] = found;
      stencil.weight[stencil.count++] = weight;
      sum += weight;
    }
  }
  if (sum > 1 - 1e-12) return stencil;
  for (std::uint32_t c = 0; c < stencil.count; ++c) stencil.weight[c] /= sum;
  return stencil;
}

ColumnStencil ColumnLayout::at_scattered(double x, double y) const noexcept {
  constexpr std::size_t wanted = 5;  // the fifth sets how far the four are heard
  std::array<double, wanted> distance_m;
  std::array<std::uint32_t, wanted> column{};
  distance_m.fill(std::numeric_limits<double>::infinity());  // squared, until all are seen
  for (std::size_t i = 0; i < point_.size(); ++i) {
    const double east = point_[i].x - x;
    const double north = point_[i].y - y;
    double d = east * east + north * north;
    if (d >= distance_m[wanted - 1]) continue;
    auto c = static_cast<std::uint32_t>(i);
    for (std::size_t k = 0; k < wanted; ++k) {
      if (d >= distance_m[k]) continue;
      std::swap(d, distance_m[k]);
      std::swap(c, column[k]);
    }
  }
  for (double& d : distance_m) d = std::sqrt(d);
  ColumnStencil stencil;
  if (distance_m[0] > lone_reach_m) return stencil;
  stencil.is_inside = true;
  const bool all_alike = distance_m[wanted - 1] - distance_m[0] < 1.0;
  if (distance_m[0] < 1.0 || all_alike) {
    stencil.count = 1;
    stencil.column[0] = column[0];
    stencil.weight[0] = 1;
    return stencil;
  }
  double sum = 0;
  for (std::size_t k = 0; k + 1 < wanted && std::isfinite(distance_m[k]); ++k) {
    const double weight = std::pow(1 / distance_m[k] - 1 / distance_m[wanted - 1], 2);
    if (!(weight > 0)) continue;
    stencil.column[stencil.count] = column[k];
    stencil.weight[stencil.count++] = weight;
    sum += weight;
  }
  for (std::uint32_t k = 0; k < stencil.count; ++k) stencil.weight[k] /= sum;
  return stencil;
}

}  // namespace slackwater
