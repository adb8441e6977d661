#include "twin/tether/lay_tether.h"

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/tether/long_step.h"
#include "twin/tether/tether_dynamics.h"

namespace slackwater::twin {
namespace {

/// x in (0, pi) with sin(x)/x = ratio: half the angle of an arc whose chord is that share of its
/// length.
double half_angle_of(double ratio) {
  double low = 0;
  double high = constants::pi;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (std::sin(middle) > ratio * middle ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Across `chord`, a unit, as near to `wanted` as can be.
Triple<double> across(const Triple<double>& chord, const Triple<double>& wanted) {
  for (const Triple<double>& v : {wanted, Triple<double>{0, 0, 1}, Triple<double>{1, 0, 0}}) {
    const Triple<double> out = v - dot(v, chord) * chord;
    const double size = length_of(out);
    if (size > 1e-3 * length_of(v) && size > 0) return (1 / size) * out;
  }
  return {0, 1, 0};
}

void expect_reach(const Tether& tether, double distance_m, double length_m) {
  if (!(length_m >= shortest_tether_m && length_m <= tether.longest_m)) {
    throw Error(ErrorKind::invalid_input,
                formatted("found {:g} m of tether paid out; give {:g} m, below which it is not "
                          "resolved, to the {:g} m of tether.longest_m",
                          length_m, shortest_tether_m, tether.longest_m));
  }
  const double reach_m = length_m * (1 + tether.breaking_load_n / tether.axial_stiffness_n);
  if (distance_m < reach_m) return;
  throw Error(
      ErrorKind::invalid_input,
      formatted("the vehicle is {:g} m from the top of its tether, of which {:g} m are "
                "paid out: it would part at {:g} m; pay out more or move the vehicle nearer",
                distance_m, length_m, reach_m));
}

}  // namespace

TetherState<double> laid_out(const Tether& tether, const Triple<double>& top_m,
                             const Triple<double>& vehicle_m, double length_m,
                             const Triple<double>& bow) {
  const Triple<double> between = vehicle_m - top_m;
  const double distance_m = length_of(between);
  expect_reach(tether, distance_m, length_m);
  const Triple<double> chord =
      distance_m > 0 ? (1 / distance_m) * between : Triple<double>{0, 0, 1};
  const Triple<double> out = across(chord, bow);
  TetherState<double> state;
  state.length_m = length_m;
  const double half = distance_m < length_m ? half_angle_of(distance_m / length_m) : 0;
  for (std::size_t i = 0; i < tether_inner_nodes; ++i) {
    const double share = static_cast<double>(i + 1) / tether_segments;
    const double angle = half * (2 * share - 1);
    const double radius_m = half > 1e-6 ? length_m / (2 * half) : 0;
    const double along_m =
        half > 1e-6 ? 0.5 * distance_m + radius_m * std::sin(angle) : share * distance_m;
    state.node_m[i] =
        top_m + along_m * chord + (radius_m * (std::cos(angle) - std::cos(half))) * out;
  }
  return state;
}

WaterAtNodes<double> water_at_nodes(const TetherState<double>& state, const Triple<double>& top_m,
                                    const Triple<double>& vehicle_m, const SteadyWater& water) {
  WaterAtNodes<double> out;
  out.velocity_m_s.front() = water(top_m.z);
  out.velocity_m_s.back() = water(vehicle_m.z);
  for (std::size_t i = 0; i < tether_inner_nodes; ++i)
    out.velocity_m_s[i + 1] = water(state.node_m[i].z);
  return out;
}

namespace {

/// Dynamic relaxation (Day 1965): the line moves, and is stopped whenever its kinetic energy has
/// passed a peak.
/// @return whether no node was faster than `still_m_s` for a second
template <typename Pull>
bool relax(TetherState<double>& state, const TetherEnds<double>& ends, const SteadyWater& water,
           double still_m_s, int most_steps, double dt_s, const Pull& pulled) {
  double before = 0;
  int quiet = 0;
  for (int step = 0; step < most_steps; ++step) {
    pulled(water_at_nodes(state, ends.top_m, ends.vehicle_m, water));
    double energy = 0;
    double fastest = 0;
    for (const Triple<double>& v : state.velocity_m_s) {
      energy += dot(v, v);
      fastest = std::max(fastest, length_of(v));
    }
    quiet = fastest < still_m_s ? quiet + 1 : 0;
    if (quiet * dt_s > 1) return true;
    if (energy < before) {
      state.velocity_m_s = {};
      energy = 0;
    }
    before = energy;
  }
  return false;
}

}  // namespace

TetherState<double> settled(const Tether& tether, TetherState<double> state,
                            const Triple<double>& top_m, const Triple<double>& vehicle_m,
                            const SteadyWater& water) {
  constexpr int most_steps = 400000;
  constexpr double dt_s = 0.05;
  const TetherEnds<double> ends{top_m, {}, vehicle_m, {}};
  if (relax(state, ends, water, 1e-12, most_steps, dt_s,
            [&](const WaterAtNodes<double>& at) { (void)pull(tether, state, ends, at, dt_s); }))
    return state;
  throw Error(ErrorKind::not_converged,
              "the tether did not come to rest in the given water; check that the water is steady");
}

TetherState<double> hung(const Tether& tether, TetherState<double> state,
                         const Triple<double>& top_m, const Triple<double>& vehicle_m,
                         const SteadyWater& water, int most_steps) {
  constexpr double dt_s = 0.05;
  const TetherEnds<double> ends{top_m, {}, vehicle_m, {}};
  (void)relax(state, ends, water, 1e-4, most_steps, dt_s,
              [&](const WaterAtNodes<double>& at) { (void)pull(tether, state, ends, at, dt_s); });
  state.velocity_m_s = {};
  return state;
}

TetherState<double> hung_roughly(const Tether& tether, TetherState<double> state,
                                 const Triple<double>& top_m, const Triple<double>& vehicle_m,
                                 const SteadyWater& water, int most_steps) {
  constexpr double dt_s = 0.2;
  const TetherEnds<double> ends{top_m, {}, vehicle_m, {}};
  (void)relax(state, ends, water, 1e-4, most_steps, dt_s, [&](const WaterAtNodes<double>& at) {
    (void)pull_long(tether, state, ends, at, at, dt_s);
  });
  state.velocity_m_s = {};
  return state;
}

}  // namespace slackwater::twin
