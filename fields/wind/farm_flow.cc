#include "fields/wind/farm_flow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "fields/base/check.h"
#include "fields/wind/rotor_disc.h"
#include "fields/wind/wake_turbulence.h"

namespace slackwater {
namespace {

/// Along the wind, and to the left of it.
struct WindFrame {
  double along_m;
  double across_m;
};

WindFrame in_wind_frame(Horizontal position_m, Horizontal downwind) noexcept {
  const Horizontal turned = position_m * std::conj(downwind);
  return {turned.real(), turned.imag()};
}

/// A deficit's share of the sum.
double term(Superposition::Sum sum, double deficit) noexcept {
  return sum == Superposition::Sum::linear ? deficit : deficit * deficit;
}

/// The deficit, 0 where it is below 2e-8: most points of a farm are in few wakes.
template <typename AnyWake>
double deficit_within_reach(const AnyWake& wake, double downstream_m, double off_axis_m) noexcept {
  return off_axis_m > wake.reach_m(downstream_m) ? 0.0 : wake.deficit(downstream_m, off_axis_m);
}

bool all_different(std::span<const Horizontal> positions_m) {
  for (std::size_t i = 0; i < positions_m.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (positions_m[i] == positions_m[j]) return false;
  return true;
}

}  // namespace

FarmFlow::FarmFlow(const Turbine& turbine, std::span<const Horizontal> turbines_m,
                   Horizontal wind_at_hub_m_s, const FarmSettings& settings)
    : free_speed_m_s_(std::abs(wind_at_hub_m_s)),
      downwind_(free_speed_m_s_ > 0 ? wind_at_hub_m_s / free_speed_m_s_ : Horizontal(1, 0)),
      hub_height_m_(turbine.hub_height_m),
      diameter_m_(turbine.rotor_diameter_m),
      superposition_(settings.superposition),
      free_turbulence_(settings.turbulence_intensity),
      adds_turbulence_(settings.added_turbulence) {
  expects(std::isfinite(free_speed_m_s_), "the free wind is not a number");
  expects(all_different(turbines_m), "two turbines stand on one place");
  turbines_.resize(turbines_m.size());
  wakes_.reserve(turbines_m.size());
  for (std::size_t i = 0; i < turbines_m.size(); ++i) turbines_[i].position_m = turbines_m[i];

  std::vector<std::size_t> order(turbines_m.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // Upwind first; turbines abreast do not touch each other, and keep the order of the layout.
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return in_wind_frame(turbines_m[a], downwind_).along_m <
           in_wind_frame(turbines_m[b], downwind_).along_m;
  });
  for (const std::size_t index : order) solve_turbine(turbine, index, settings);
}

double FarmFlow::combine(double total) const noexcept {
  const double deficit =
      superposition_.sum == Superposition::Sum::linear ? total : std::sqrt(total);
  return std::max(0.0, 1 - deficit);
}

void FarmFlow::solve_turbine(const Turbine& turbine, std::size_t index,
                             const FarmSettings& settings) {
  static const DiscRule disc = disc_rule();
  TurbineFlow& here = turbines_[index];
  const auto [along_m, across_m] = in_wind_frame(here.position_m, downwind_);
  const double radius_m = 0.5 * diameter_m_;

  std::array<double, DiscRule::rings * DiscRule::spokes> totals{};
  double added = 0;
  for (std::size_t j = 0; j < wakes_.size(); ++j) {
    const PlacedWake& upwind = wakes_[j];
    const double downstream_m = along_m - upwind.along_m;
    if (!(downstream_m > 0)) continue;
    const double aside_m = across_m - upwind.across_m;
    for (std::size_t k = 0; k < totals.size(); ++k) {
      const double off_axis_m =
          std::hypot(aside_m + radius_m * disc.points[k].across, radius_m * disc.points[k].up);
      totals[k] += term(superposition_.sum,
                        upwind.scale * wake_deficit(upwind.wake, downstream_m, off_axis_m));
    }
    const double edge_m =
        std::visit([&](const auto& wake) { return wake.edge_m(downstream_m); }, upwind.wake);
    if (settings.added_turbulence && std::abs(aside_m) < edge_m) {
      added =
          std::max(added, added_turbulence(upwind.thrust_coefficient, settings.turbulence_intensity,
                                           downstream_m / diameter_m_));
    }
  }

  double ratio = 0;
  for (std::size_t k = 0; k < totals.size(); ++k) ratio += disc.weights[k] * combine(totals[k]);
  here.inflow_speed_m_s = free_speed_m_s_ * ratio;
  here.turbulence_intensity = std::min(1.0, std::hypot(settings.turbulence_intensity, added));
  here.thrust_coefficient = turbine.thrust_coefficient(here.inflow_speed_m_s);
  here.power_w = turbine.power_w(here.inflow_speed_m_s);
  const bool local = superposition_.scale == Superposition::Scale::local_inflow;
  wakes_.push_back({along_m, across_m, local ? ratio : 1.0, here.thrust_coefficient,
                    make_wake(settings.wake, diameter_m_, hub_height_m_, here.thrust_coefficient,
                              here.turbulence_intensity)});
}

double FarmFlow::power_w() const noexcept {
  double total = 0;
  for (const TurbineFlow& turbine : turbines_) total += turbine.power_w;
  return total;
}

double FarmFlow::speed_ratio(Horizontal position_m, double height_m) const noexcept {
  const auto [along_m, across_m] = in_wind_frame(position_m, downwind_);
  const double above_m = height_m - hub_height_m_;
  double total = 0;
  for (const PlacedWake& upwind : wakes_) {
    const double downstream_m = along_m - upwind.along_m;
    if (!(downstream_m > 0)) break;  // the others stand farther down the wind
    const double aside_m = across_m - upwind.across_m;
    const double off_axis_m = std::sqrt(aside_m * aside_m + above_m * above_m);
    const double deficit = std::visit(
        [&](const auto& wake) { return deficit_within_reach(wake, downstream_m, off_axis_m); },
        upwind.wake);
    total += term(superposition_.sum, upwind.scale * deficit);
  }
  return combine(total);
}

double FarmFlow::turbulence_intensity(Horizontal position_m, double height_m) const noexcept {
  if (!adds_turbulence_) return free_turbulence_;
  const auto [along_m, across_m] = in_wind_frame(position_m, downwind_);
  const double above_m = height_m - hub_height_m_;
  double most = 0;
  for (const PlacedWake& upwind : wakes_) {
    const double downstream_m = along_m - upwind.along_m;
    if (!(downstream_m > 0)) break;  // the others stand farther down the wind
    if (!(upwind.thrust_coefficient > 0)) continue;
    const double off_axis_m = std::hypot(across_m - upwind.across_m, above_m);
    // The edge of a wake is two standard deviations off its axis.
    const double width_m =
        0.5 * std::visit([&](const auto& wake) { return wake.edge_m(downstream_m); }, upwind.wake);
    if (off_axis_m > 0.5 * diameter_m_ + 6 * width_m) continue;
    const double added = std::min(
        near_wake_turbulence(upwind.thrust_coefficient),
        added_turbulence(upwind.thrust_coefficient, free_turbulence_, downstream_m / diameter_m_));
    most = std::max(most,
                    upwind.scale * added * wake_turbulence_shape(off_axis_m, diameter_m_, width_m));
  }
  return std::min(1.0, std::hypot(free_turbulence_, most));
}

void FarmFlow::speed_ratios(const HorizontalGrid& grid, std::span<double> out) const {
  expects(out.size() == grid.columns * grid.rows, "the map has another size than its grid");
  std::fill(out.begin(), out.end(), 0.0);
  const Horizontal east = std::conj(downwind_) * grid.step_east_m;
  const Horizontal north = std::conj(downwind_) * Horizontal(0, grid.step_north_m);
  const Horizontal corner = grid.south_west_m * std::conj(downwind_);
  for (const PlacedWake& upwind : wakes_) {
    const Horizontal start = corner - Horizontal(upwind.along_m, upwind.across_m);
    std::visit(
        [&](const auto& wake) {
          for (std::size_t row = 0; row < grid.rows; ++row) {
            const Horizontal first = start + static_cast<double>(row) * north;
            double* const line = out.data() + row * grid.columns;
            for (std::size_t column = 0; column < grid.columns; ++column) {
              const auto step = static_cast<double>(column);
              const double downstream_m = first.real() + step * east.real();
              const double off_axis_m = std::abs(first.imag() + step * east.imag());
              if (!(downstream_m > 0)) continue;
              line[column] +=
                  term(superposition_.sum,
                       upwind.scale * deficit_within_reach(wake, downstream_m, off_axis_m));
            }
          }
        },
        upwind.wake);
  }
  for (double& value : out) value = combine(value);
}

}  // namespace slackwater
