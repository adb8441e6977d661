// Compiled once per instruction set, see kernels.cmake; SLACKWATER_KERNEL names the namespace.
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
    const SineCosine at = sine_cosine_of_turns(turns);
    sum = sum + Lanes::load(waves.amplitude_m + i) * at.cosine;
    if constexpr (keep) {
      at.sine.store(phases->sine + i);
      at.cosine.store(phases->cosine + i);
    }
  }
  return sum_of(sum);
}

/// 2^-45 = 3e-14 of the motion at the surface, below the error of the rest.
constexpr double unfelt_halvings = 45.0;

/// Wheeler's level: the surface is brought to still water, the bed stays (Wheeler 1970).
SLACKWATER_INLINE double stretched_level(double up_m, double elevation_m, double depth_m) {
  return depth_m * (up_m - elevation_m) / (depth_m + elevation_m);
}

template <bool with_acceleration>
SLACKWATER_INLINE void motion_of(const SeaKernelWaves& waves, const Phases& phases,
                                 SeaKernelSums& sums) {
  const Lanes up = Lanes::all(sums.evaluated_up_m);
  const Lanes zero = Lanes::all(0.0);
  Lanes u = zero, v = zero, w = zero;
  Lanes du = zero, dv = zero, dw = zero, p = zero;
  for (std::size_t i = 0; i < waves.count; i += Lanes::count) {
    // The waves are sorted: this one and all that follow do not reach down here.
    if (waves.decay_per_m[i] * sums.evaluated_up_m < -unfelt_halvings) break;
    // cosh k(z+h)/sinh kh = (E + B/E)/(1 - B) with E = e^kz, B = e^-2kh: nothing overflows.
    const PowerAndInverse decay = powers_of_two(Lanes::load(waves.decay_per_m + i) * up);
    const Lanes mirrored = Lanes::load(waves.reflection + i) * decay.inverse;
    const Lanes sine = Lanes::load(phases.sine + i);
    const Lanes cosine = Lanes::load(phases.cosine + i);
    const Lanes level = decay.power + mirrored;
    const Lanes upright = decay.power - mirrored;
    const Lanes forward = level * cosine;
    const Lanes lift = Lanes::load(waves.up_m_s + i) * upright;
    const Lanes east = Lanes::load(waves.east_m_s + i);
    const Lanes north = Lanes::load(waves.north_m_s + i);
    u = u + east * forward;
    v = v + north * forward;
    w = w + lift * sine;
    if constexpr (with_acceleration) {
      const Lanes sigma = Lanes::load(waves.intrinsic_rad_s + i);
      const Lanes pushed = sigma * (level * sine);
      du = du + east * pushed;
      dv = dv + north * pushed;
      dw = dw - sigma * (lift * cosine);
      p = p + Lanes::load(waves.pressure_pa + i) * forward;
    }
  }
  sums.velocity_m_s[0] = sum_of(u);
  sums.velocity_m_s[1] = sum_of(v);
  sums.velocity_m_s[2] = sum_of(w);
  if constexpr (with_acceleration) {
    sums.acceleration_m_s2[0] = sum_of(du);
    sums.acceleration_m_s2[1] = sum_of(dv);
    sums.acceleration_m_s2[2] = sum_of(dw);
    sums.pressure_pa = sum_of(p);
  }
}

void evaluate_elevation(const SeaKernelWaves& waves, const SeaKernelPlace& place,
                        bool /*stretched*/, SeaKernelSums& sums) noexcept {
  sums.elevation_m = elevation_of<false>(waves, place, nullptr);
}

template <bool with_acceleration>
void evaluate(const SeaKernelWaves& waves, const SeaKernelPlace& place, bool stretched,
              SeaKernelSums& sums) noexcept {
  Phases phases;  // written before it is read: not cleared
  sums.elevation_m = elevation_of<true>(waves, place, &phases);
  double up = stretched ? stretched_level(place.up_m, sums.elevation_m, waves.depth_m) : place.up_m;
  // Outside the water the caller gives no value; here it only must not overflow.
  if (!(up < 0)) up = 0;
  if (up < -waves.depth_m) up = -waves.depth_m;
  sums.evaluated_up_m = up;
  motion_of<with_acceleration>(waves, phases, sums);
}

}  // namespace

SeaKernels sea_kernels() noexcept { return {evaluate_elevation, evaluate<false>, evaluate<true>}; }

}  // namespace slackwater::SLACKWATER_KERNEL
