#pragma once
#include "twin/tether/tether_dynamics.h"

namespace slackwater::twin {

/// How drag grows with the velocity of the water past a node, times a change of that.
template <typename Real>
[[nodiscard]] Triple<Real> drag_growth(const NodeLoad<Real>& load, const Triple<Real>& more_m_s) {
  return load.damping_across_kg_s * more_m_s +
         ((load.damping_along_kg_s - load.damping_across_kg_s) * dot(load.along, more_m_s)) *
             load.along;
}

/// `motion_of` with no more added to the inertia than a long step needs: beside mass m and implicit
/// damping c, a node between tensions T_1 and T_2 swings on without growing where
///
///   dt^2 (T_1 + T_2)/(2 l) <= m + dt c/2 + held
///
/// (Jury's condition for v' = v - (dt/M)(4 T/l x + c v'), x' = x + dt v', M = m + held). Four
/// times the left side is asked for: with twice, the snap of a line that comes taut within a step
/// is twenty times too hard.
template <typename Real>
[[nodiscard]] ChainMotion<Real> least_held_motion(
    const Tether& tether, const Chain<Real>& chain,
    const std::array<Real, tether_segments>& tension_n, double dt_s) {
  constexpr std::size_t last = tether_segments;
  const Real dt = Real{} + dt_s;
  const Real none = Real{} + 0.0;
  const Real needed_per_n = (2.0 * dt_s * dt_s) / chain.segment_m;
  ChainMotion<Real> motion;
  motion.free_m_s = chain.velocity_m_s;
  for (std::size_t i = 1; i < last; ++i) {
    const NodeLoad<Real>& load = chain.load[i];
    const Real needed_kg = needed_per_n * (tension_n[i - 1] + tension_n[i]);
    const auto whole_kg = [&](const Real& mass_kg, const Real& damping_kg_s) -> Real {
      const Real held_kg = larger_of(needed_kg - mass_kg - (0.5 * dt_s) * damping_kg_s, none);
      return mass_kg + dt_s * damping_kg_s + held_kg;
    };
    const Yield<Real> yield{load.along, 1.0 / whole_kg(load.mass_along_kg, load.damping_along_kg_s),
                            1.0 / whole_kg(load.mass_across_kg, load.damping_across_kg_s)};
    motion.free_m_s[i] = motion.free_m_s[i] + yield.to(dt * load.force_n);
    motion.by_above[i] = yield.to(dt * chain.along[i - 1]);
    motion.by_below[i] = yield.to(dt * chain.along[i]);
  }
  motion.by_above[last] = (Real{} + dt_s * tether.vehicle_mobility_per_kg) * chain.along[last - 1];
  return motion;
}

/// `pull` for steps that are long beside the time in which drag stops a node (mass over damping,
/// hundredths of a second): the water is given at both ends of the step, drag is linear about the
/// velocity past the node as it was and then, once more, about what it will be, and the inertia is
/// burdened with no more than the step needs.
///
/// At rest in steady water it is the same balance as that of `pull`.
///
/// Cost: a tenth more than that of `pull`. No allocation.
template <typename Real>
TetherPull<Real> pull_long(const Tether& tether, TetherState<Real>& state,
                           const TetherEnds<Real>& ends, const WaterAtNodes<Real>& before,
                           const WaterAtNodes<Real>& after, double dt_s) {
  constexpr std::size_t last = tether_segments;
  Chain<Real> chain = chain_of(tether, state, ends, before);
  for (std::size_t i = 1; i < last; ++i) {
    NodeLoad<Real>& load = chain.load[i];
    load.force_n = load.force_n + drag_growth(load, after.velocity_m_s[i] - before.velocity_m_s[i]);
  }
  ChainMotion<Real> motion = least_held_motion(tether, chain, state.tension_n, dt_s);
  constexpr int once = 1;  // which segments pull is mended again below
  std::array<Real, tether_segments> tension =
      tensions_of(tether, chain, motion, state.tension_n, dt_s, once);
  // Once more, with tensions, directions and drag as they are at the end of the step.
  const auto velocity = velocities_of(motion, tension);
  for (std::size_t i = 1; i < last; ++i) {
    NodeLoad<Real>& load = chain.load[i];
    load = load_of(tether, load.along, chain.segment_m, chain.at_m[i].z,
                   after.velocity_m_s[i] - velocity[i], after.elevation_m);
    load.force_n = load.force_n + drag_growth(load, velocity[i] - chain.velocity_m_s[i]);
  }
  turn(chain, velocity, dt_s);
  motion = least_held_motion(tether, chain, tension, dt_s);
  tension = tensions_of(tether, chain, motion, tension, dt_s);
  return move_on(tether, state, ends, chain, motion, tension, dt_s);
}

}  // namespace slackwater::twin
