#pragma once
#include "twin/tether/node_load.h"
#include "twin/tether/tension.h"

namespace slackwater::twin {

/// A chain at the start of a step.
template <typename Real>
struct Chain {
  std::array<Triple<Real>, tether_nodes> at_m{};
  std::array<Triple<Real>, tether_nodes> velocity_m_s{};
  std::array<Triple<Real>, tether_segments> along{};  ///< unit, away from the top
  std::array<NodeLoad<Real>, tether_nodes> load{};    ///< at the ends of half a segment
  Real segment_m{};
};

/// How the inner nodes of a chain would move without tension, and what a newton in the segments
/// beside them does to their velocity.
template <typename Real>
struct ChainMotion {
  std::array<Triple<Real>, tether_nodes> free_m_s{};
  std::array<Triple<Real>, tether_nodes> by_above{};
  std::array<Triple<Real>, tether_nodes> by_below{};
};

template <typename Real>
[[nodiscard]] Chain<Real> chain_of(const Tether& tether, const TetherState<Real>& state,
                                   const TetherEnds<Real>& ends, const WaterAtNodes<Real>& water) {
  constexpr std::size_t last = tether_segments;
  Chain<Real> chain;
  auto& at = chain.at_m;
  at[0] = ends.top_m;
  chain.velocity_m_s[0] = ends.top_velocity_m_s;
  for (std::size_t i = 0; i < tether_inner_nodes; ++i) {
    at[i + 1] = state.node_m[i];
    chain.velocity_m_s[i + 1] = state.velocity_m_s[i];
  }
  at[last] = ends.vehicle_m;
  chain.velocity_m_s[last] = ends.vehicle_velocity_m_s;
  chain.segment_m = (1.0 / tether_segments) * larger_of(state.length_m, Real{} + shortest_tether_m);
  for (std::size_t j = 0; j < last; ++j) chain.along[j] = direction_of(at[j + 1] - at[j]);
  const Real three = Real{} + 3.0;
  for (std::size_t i = 0; i < tether_nodes; ++i) {
    const bool is_end = i == 0 || i == last;
    const Real length_m = (is_end ? 0.5 : 1.0) * chain.segment_m;
    // The tangent, to second order at the ends too: there the two nearest segments are
    // extrapolated.
    const Triple<Real> along =
        i == 0      ? direction_of(three * chain.along[0] - chain.along[1])
        : i == last ? direction_of(three * chain.along[last - 1] - chain.along[last - 2])
                    : direction_of(at[i + 1] - at[i - 1]);
    chain.load[i] = load_of(tether, along, length_m, at[i].z,
                            water.velocity_m_s[i] - chain.velocity_m_s[i], water.elevation_m);
  }
  return chain;
}

/// Under tension a line is stiff across itself too, the more so the shorter its segments. The step
/// squared times a bound of that stiffness (twice its diagonal, for `tension_n`) is added to the
/// inertia: what implicit Euler would add, but for the coupling of neighbours. It slows only
/// trembling that the step could not resolve.
template <typename Real>
[[nodiscard]] ChainMotion<Real> motion_of(const Tether& tether, const Chain<Real>& chain,
                                          const std::array<Real, tether_segments>& tension_n,
                                          double dt_s) {
  constexpr std::size_t last = tether_segments;
  const Real dt = Real{} + dt_s;
  const Real held_per_n = (2.0 * dt_s * dt_s) / chain.segment_m;
  ChainMotion<Real> motion;
  motion.free_m_s = chain.velocity_m_s;
  for (std::size_t i = 1; i < last; ++i) {
    const Yield<Real> yield =
        yield_of(chain.load[i], held_per_n * (tension_n[i - 1] + tension_n[i]), dt_s);
    motion.free_m_s[i] = motion.free_m_s[i] + yield.to(dt * chain.load[i].force_n);
    motion.by_above[i] = yield.to(dt * chain.along[i - 1]);
    motion.by_below[i] = yield.to(dt * chain.along[i]);
  }
  motion.by_above[last] = (Real{} + dt_s * tether.vehicle_mobility_per_kg) * chain.along[last - 1];
  return motion;
}

/// With T = EA (l/l_0 - 1), l the length at the end of the step.
template <typename Real>
[[nodiscard]] std::array<Real, tether_segments> tensions_of(
    const Tether& tether, const Chain<Real>& chain, const ChainMotion<Real>& motion,
    const std::array<Real, tether_segments>& before_n, double dt_s, int mendings = 2) {
  TensionSystem<Real> system;
  const Real compliance_m_n = chain.segment_m / tether.axial_stiffness_n;
  for (std::size_t j = 0; j < tether_segments; ++j) {
    const Triple<Real>& along = chain.along[j];
    system.diagonal[j] =
        compliance_m_n + dt_s * dot(along, motion.by_below[j] + motion.by_above[j + 1]);
    if (j + 1 < tether_segments) system.beside[j] = -(dt_s * dot(along, motion.by_below[j + 1]));
    system.stretch_m[j] = dot(along, chain.at_m[j + 1] - chain.at_m[j]) - chain.segment_m +
                          dt_s * dot(along, motion.free_m_s[j + 1] - motion.free_m_s[j]);
  }
  return pulling_tensions(system, before_n, mendings);
}

/// Velocities of all nodes at the end of the step.
template <typename Real>
[[nodiscard]] std::array<Triple<Real>, tether_nodes> velocities_of(
    const ChainMotion<Real>& motion, const std::array<Real, tether_segments>& tension_n) {
  std::array<Triple<Real>, tether_nodes> velocity = motion.free_m_s;
  for (std::size_t i = 1; i < tether_segments; ++i)
    velocity[i] =
        velocity[i] + tension_n[i] * motion.by_below[i] - tension_n[i - 1] * motion.by_above[i];
  return velocity;
}

/// The segments as they will lie at the end of the step.
template <typename Real>
void turn(Chain<Real>& chain, const std::array<Triple<Real>, tether_nodes>& velocity_m_s,
          double dt_s) {
  const Real dt = Real{} + dt_s;
  for (std::size_t j = 0; j < tether_segments; ++j)
    chain.along[j] = direction_of(chain.at_m[j + 1] - chain.at_m[j] +
                                  dt * (velocity_m_s[j + 1] - velocity_m_s[j]));
}

/// Moves the nodes by what the tensions make of their motion, and says how the line pulls.
template <typename Real>
TetherPull<Real> move_on(const Tether& tether, TetherState<Real>& state,
                         const TetherEnds<Real>& ends, const Chain<Real>& chain,
                         const ChainMotion<Real>& motion,
                         const std::array<Real, tether_segments>& tension, double dt_s) {
  constexpr std::size_t last = tether_segments;
  Real most_n{};
  for (const Real& t : tension) most_n = larger_of(most_n, t);
  const Real none = Real{} + 0.0, one = Real{} + 1.0, dt = Real{} + dt_s;
  state.whole = select(most_n > tether.breaking_load_n, none, state.whole);
  for (std::size_t j = 0; j < last; ++j)
    state.tension_n[j] = select(state.whole > 0.5, tension[j], none);
  const auto velocity = velocities_of(motion, state.tension_n);
  for (std::size_t i = 1; i < last; ++i) {
    // A line that has parted is no more followed.
    state.velocity_m_s[i - 1] = state.whole * velocity[i];
    state.node_m[i - 1] = chain.at_m[i] + dt * state.velocity_m_s[i - 1];
  }

  TetherPull<Real> out;
  out.top_tension_n = state.tension_n[0];
  out.vehicle_tension_n = state.tension_n[last - 1];
  out.on_top_n = state.whole * (chain.load[0].force_n + out.top_tension_n * chain.along[0]);
  out.on_vehicle_n =
      state.whole * (chain.load[last].force_n - out.vehicle_tension_n * chain.along[last - 1]);
  out.slack_m = state.length_m - length_of(ends.vehicle_m - ends.top_m);
  out.taut = select(out.slack_m < taut_slack_share * state.length_m, one, none);
  out.whole = state.whole;
  return out;
}

/// Moves the line on by one step and says how it pulled meanwhile.
///
/// A chain of lumped masses between two given ends. Each segment is an elastic that pulls but does
/// not push, T = EA (l/l_0 - 1) >= 0, with the length that it will have at the end of the step: the
/// tensions of all segments follow from one tridiagonal system, whatever the stiffness, so that
/// nothing is iterated to some tolerance and nothing can fail to converge. At rest in steady water
/// the chain is the quasi-static one: neither the step nor the inertia stands in that balance.
/// Between, the line lags behind a vehicle as a line does.
///
/// Left out: stiffness in bending and torsion, the bed, structures in the way, the acceleration of
/// the water (the line follows waves by its drag, within 0.05 s), and the inertia of the half
/// segments at the ends.
///
/// Cost: 3.4 us for one line, 1.1 us per line in eight lanes of AVX-512, 1.7 of SSE2 (Xeon, 2.5
/// GHz). No allocation.
template <typename Real>
TetherPull<Real> pull(const Tether& tether, TetherState<Real>& state, const TetherEnds<Real>& ends,
                      const WaterAtNodes<Real>& water, double dt_s) {
  Chain<Real> chain = chain_of(tether, state, ends, water);
  ChainMotion<Real> motion = motion_of(tether, chain, state.tension_n, dt_s);
  std::array<Real, tether_segments> tension =
      tensions_of(tether, chain, motion, state.tension_n, dt_s);
  // Once more, with the tensions of this step and along the segments as they lie at its end.
  turn(chain, velocities_of(motion, tension), dt_s);
  motion = motion_of(tether, chain, tension, dt_s);
  tension = tensions_of(tether, chain, motion, tension, dt_s);
  return move_on(tether, state, ends, chain, motion, tension, dt_s);
}

}  // namespace slackwater::twin
