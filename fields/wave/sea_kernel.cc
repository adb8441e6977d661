// Compiled once per instruction set, see cmake/SlackwaterKernels.cmake; SLACKWATER_KERNEL names the
// namespace.
#include "fields/wave/sea_kernel.h"

#include "fields/wave/lane_functions.h"

namespace slackwater::SLACKWATER_KERNEL {
namespace {

/// sin and cos of every phase, kept from the elevation for the velocity.
struct Phases {
  alignas(64) double sine[most_kernel_waves];
  alignas(64) double cosine[most_kernel_waves];
};

template <bool keep>
SLACKWATER_INLINE double elevation_of(const SeaKernelWaves& waves, const SeaKernelPlace& place,
                                      Phases* phases) {
  const Lanes east = Lanes::all(place.east_m);
  const Lanes north = Lanes::all(place.north_m);
  const Lanes t = Lanes::all(place.t_s);
  Lanes sum = Lanes::all(0.0);
  for (std::size_t i = 0; i < waves.count; i += Lanes::count) {
    const Lanes turns = ((Lanes::load(waves.east_turns_m + i) * east +
                          Lanes::load(waves.north_turns_m + i) * north) -
                         Lanes::load(waves.turns_s + i) * t) +
                        Lanes::load(waves.phase_turns + i);
    const auto at = sine_cosine_of_turns(turns);
    sum = sum + Lanes::load(waves.amplitude_m + i) * at.cosine;
    if constexpr (keep) {
      at.sine.store(phases->sine + i);
      at.cosine.store(phases->cosine + i);
    }
  }
  return sum_of(sum);
}

/// By how much each phase grows from one place of a row to the next.
SLACKWATER_INLINE void step_phases(const SeaKernelWaves& waves, const SeaKernelPlace& step,
                                   Phases& by) {
  const Lanes east = Lanes::all(step.east_m);
  const Lanes north = Lanes::all(step.north_m);
  for (std::size_t i = 0; i < waves.count; i += Lanes::count) {
    const auto at = sine_cosine_of_turns(Lanes::load(waves.east_turns_m + i) * east +
                                         Lanes::load(waves.north_turns_m + i) * north);
    at.sine.store(by.sine + i);
    at.cosine.store(by.cosine + i);
  }
}

/// Turns the phases on to the next place. @return the elevation there
SLACKWATER_INLINE double next_elevation(const SeaKernelWaves& waves, const Phases& by,
                                        Phases& phases) {
  Lanes sum = Lanes::all(0.0);
  for (std::size_t i = 0; i < waves.count; i += Lanes::count) {
    const Lanes sine = Lanes::load(phases.sine + i);
    const Lanes cosine = Lanes::load(phases.cosine + i);
    const Lanes by_sine = Lanes::load(by.sine + i);
    const Lanes by_cosine = Lanes::load(by.cosine + i);
    const Lanes next = cosine * by_cosine - sine * by_sine;
    sum = sum + Lanes::load(waves.amplitude_m + i) * next;
    (sine * by_cosine + cosine * by_sine).store(phases.sine + i);
    next.store(phases.cosine + i);
  }
  return sum_of(sum);
}

/// 2^-45 = 3e-14 of the motion at the surface, below the error of the rest.
constexpr double unfelt_halvings = 45.0;

/// Wheeler's level: the surface is brought to still water, the bed stays (Wheeler 1970).
SLACKWATER_INLINE double stretched_level(double up_m, double elevation_m, double depth_m) {
  return depth_m * (up_m - elevation_m) / (depth_m + elevation_m);
}

/// Eight partial sums of each component: the waves by their place modulo eight.
struct PartialSums {
  double velocity[3][Lanes::count];
  double acceleration[3][Lanes::count];
  double pressure[Lanes::count];
};

/// The sums of one register's lanes, so that they and what they are made of stay in registers.
template <bool with_acceleration>
SLACKWATER_INLINE void add_up(const SeaKernelWaves& waves, const Phases& phases, double up_m,
                              std::size_t part, PartialSums& sums) {
  using Few = OneRegister;
  const Few up = Few::all(up_m);
  const Few zero = Few::all(0.0);
  Few u = zero, v = zero, w = zero;
  Few du = zero, dv = zero, dw = zero, p = zero;
  for (std::size_t eight = 0; eight < waves.count; eight += Lanes::count) {
    // The waves are sorted: this one and all that follow do not reach down here.
    if (waves.decay_per_m[eight] * up_m < -unfelt_halvings) break;
    const std::size_t i = eight + part;
    // cosh k(z+h)/sinh kh = (E + B/E)/(1 - B) with E = e^kz, B = e^-2kh: nothing overflows.
    const auto decay = powers_of_two(Few::load(waves.decay_per_m + i) * up);
    const Few mirrored = Few::load(waves.reflection + i) * decay.inverse;
    const Few sine = Few::load(phases.sine + i);
    const Few cosine = Few::load(phases.cosine + i);
    const Few level = decay.power + mirrored;
    const Few upright = decay.power - mirrored;
    const Few forward = level * cosine;
    const Few lift = Few::load(waves.up_m_s + i) * upright;
    const Few east = Few::load(waves.east_m_s + i);
    const Few north = Few::load(waves.north_m_s + i);
    u = u + east * forward;
    v = v + north * forward;
    w = w + lift * sine;
    if constexpr (with_acceleration) {
      const Few sigma = Few::load(waves.intrinsic_rad_s + i);
      const Few pushed = sigma * (level * sine);
      du = du + east * pushed;
      dv = dv + north * pushed;
      dw = dw - sigma * (lift * cosine);
      p = p + Few::load(waves.pressure_pa + i) * forward;
    }
  }
  u.store(sums.velocity[0] + part);
  v.store(sums.velocity[1] + part);
  w.store(sums.velocity[2] + part);
  if constexpr (with_acceleration) {
    du.store(sums.acceleration[0] + part);
    dv.store(sums.acceleration[1] + part);
    dw.store(sums.acceleration[2] + part);
    p.store(sums.pressure + part);
  }
}

template <bool with_acceleration>
SLACKWATER_INLINE void motion_of(const SeaKernelWaves& waves, const Phases& phases, double factor,
                                 SeaKernelSums& sums) {
  PartialSums partial;
  for (std::size_t part = 0; part < Lanes::count; part += native_lanes)
    add_up<with_acceleration>(waves, phases, sums.evaluated_up_m, part, partial);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sums.velocity_m_s[axis] = factor * sum_of(Lanes::load(partial.velocity[axis]));
    if constexpr (with_acceleration)
      sums.acceleration_m_s2[axis] = factor * sum_of(Lanes::load(partial.acceleration[axis]));
  }
  if constexpr (with_acceleration)
    sums.pressure_pa = factor * sum_of(Lanes::load(partial.pressure));
}

void evaluate_elevation(const SeaKernelWaves& waves, const SeaKernelPlace& place,
                        bool /*stretched*/, SeaKernelSums& sums) noexcept {
  sums.elevation_m = place.height_factor * elevation_of<false>(waves, place, nullptr);
}

/// Where the waves are to be evaluated for a place under a surface of that elevation.
SLACKWATER_INLINE double evaluated_level(const SeaKernelWaves& waves, double up_m,
                                         double elevation_m, bool stretched) {
  double up = stretched ? stretched_level(up_m, elevation_m, waves.depth_m) : up_m;
  // Outside the water the caller gives no value; here it only must not overflow.
  if (!(up < 0)) up = 0;
  if (up < -waves.depth_m) up = -waves.depth_m;
  return up;
}

template <bool with_acceleration>
void evaluate(const SeaKernelWaves& waves, const SeaKernelPlace& place, bool stretched,
              SeaKernelSums& sums) noexcept {
  Phases phases;  // written before it is read: not cleared
  sums.elevation_m = place.height_factor * elevation_of<true>(waves, place, &phases);
  sums.evaluated_up_m = evaluated_level(waves, place.up_m, sums.elevation_m, stretched);
  motion_of<with_acceleration>(waves, phases, place.height_factor, sums);
}

void evaluate_row(const SeaKernelWaves& waves, const SeaKernelPlace& first,
                  const SeaKernelPlace& step, std::size_t count, bool stretched,
                  SeaKernelSums* sums) noexcept {
  Phases phases;
  Phases by;
  step_phases(waves, step, by);
  for (std::size_t j = 0; j < count; ++j) {
    const double up_m = first.up_m + static_cast<double>(j) * step.up_m;
    sums[j].elevation_m = first.height_factor * (j == 0 ? elevation_of<true>(waves, first, &phases)
                                                        : next_elevation(waves, by, phases));
    sums[j].evaluated_up_m = evaluated_level(waves, up_m, sums[j].elevation_m, stretched);
    motion_of<true>(waves, phases, first.height_factor, sums[j]);
  }
}

}  // namespace

SeaKernels sea_kernels() noexcept {
  return {evaluate_elevation, evaluate<false>, evaluate<true>, evaluate_row};
}

}  // namespace slackwater::SLACKWATER_KERNEL
