// Compiled once per instruction set, see cmake/SlackwaterKernels.cmake; SLACKWATER_KERNEL names the
// namespace.
#include "fields/wave/sea_moment_kernel.h"

#include <cstdint>
#include <cstring>
#include <numbers>

namespace slackwater::SLACKWATER_KERNEL {
namespace {

/// Eight floats on every instruction set: the compiler finds the registers for them.
using Floats [[gnu::vector_size(32)]] = float;
using Bits [[gnu::vector_size(32)]] = std::uint32_t;
constexpr std::size_t floats = 8;

[[gnu::always_inline]] inline Floats load(const float* from) {
  Floats value;
  std::memcpy(&value, from, sizeof value);
  return value;
}
[[gnu::always_inline]] inline void store(const Floats& value, float* to) {
  std::memcpy(to, &value, sizeof value);
}
/// In one order.
[[gnu::always_inline]] inline float sum_of(const Floats& a) {
  return ((a[0] + a[4]) + (a[1] + a[5])) + ((a[2] + a[6]) + (a[3] + a[7]));
}

/// e^(-2kh) of waves that do not feel the bed: what it mirrors of them is e^(-kh), 1e-4, at most.
constexpr double least_reflection = 1e-8;

/// The waves at one moment: what all places share.
struct Waves {
  std::size_t feeling_bed = 0;                      ///< the first so many do
  alignas(64) float base_turns[most_kernel_waves];  ///< of the phase at the reference
  alignas(64) float east_turns_m[most_kernel_waves];
  alignas(64) float north_turns_m[most_kernel_waves];
  alignas(64) float amplitude_m[most_kernel_waves];
  alignas(64) float decay_per_m[most_kernel_waves];
  alignas(64) float reflection[most_kernel_waves];
  alignas(64) float east_m_s[most_kernel_waves];
  alignas(64) float north_m_s[most_kernel_waves];
  alignas(64) float up_m_s[most_kernel_waves];
  alignas(64) float passing_rad_s[most_kernel_waves];  ///< a place at rest
  // Of the place in hand.
  alignas(64) float sine[most_kernel_waves];
  alignas(64) float cosine[most_kernel_waves];
  alignas(64) float met_rad_s[most_kernel_waves];
};

/// As floats. A phase of many turns is brought to its rest as a double first.
void convert(const SeaKernelWaves& from, const SeaKernelPlace& reference, Waves& to) {
  constexpr double rounder = 6755399441055744.0;  // 1.5 2^52, see fields/base/lanes.h
  for (std::size_t i = 0; i < from.count; ++i) {
    const double turns =
        ((from.east_turns_m[i] * reference.east_m + from.north_turns_m[i] * reference.north_m) -
         from.turns_s[i] * reference.t_s) +
        from.phase_turns[i];
    to.base_turns[i] = static_cast<float>(turns - ((turns + rounder) - rounder));
  }
  const auto as_floats = [count = from.count](const double* values, float* out) {
    for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<float>(values[i]);
  };
  as_floats(from.east_turns_m, to.east_turns_m);
  as_floats(from.north_turns_m, to.north_turns_m);
  as_floats(from.amplitude_m, to.amplitude_m);
  as_floats(from.decay_per_m, to.decay_per_m);
  as_floats(from.east_m_s, to.east_m_s);
  as_floats(from.north_m_s, to.north_m_s);
  as_floats(from.up_m_s, to.up_m_s);
  for (std::size_t i = 0; i < from.count; ++i)
    to.passing_rad_s[i] = static_cast<float>(2 * std::numbers::pi * from.turns_s[i]);
  for (std::size_t i = 0; i < from.count; ++i)
    to.reflection[i] =
        from.reflection[i] < least_reflection ? 0.0F : static_cast<float>(from.reflection[i]);
  to.feeling_bed = 0;
  while (to.feeling_bed < from.count && from.reflection[to.feeling_bed] > least_reflection)
    to.feeling_bed += floats;
}

constexpr float rounder = 12582912.0F;  ///< 1.5 2^23: a sum with it has no room for a fraction

/// sin and cos of an angle in turns, |turns| < 2^22: by polynomials of the half of what is left of
/// whole turns, at most pi/2, through the values at Chebyshev's nodes; doubled. Error below 2e-5.
struct SineCosine {
  Floats sine;
  Floats cosine;
};
[[gnu::always_inline]] inline SineCosine sine_cosine_of_turns(const Floats& turns) {
  const Floats rest = turns - ((turns + rounder) - rounder);
  const Floats square = rest * rest;
  const Floats sine =
      rest *
      (((-0.559435001F * square + 2.54400022F) * square - 5.16740577F) * square + 3.14159026F);
  const Floats cosine =
      ((-1.22193646F * square + 4.04121234F) * square - 4.93393131F) * square + 0.999993202F;
  const Floats twice = sine + sine;
  return {twice * cosine, 1.0F - twice * sine};
}

/// 2^n for the whole number n that a sum with `rounder` holds, and 2^-n.
[[gnu::always_inline]] inline Floats whole_power(const Floats& shifted) {
  return (Floats)(((Bits)shifted + 127U) << 23U);
}
[[gnu::always_inline]] inline Floats whole_power_of_half(const Floats& shifted) {
  return (Floats)((127U - (Bits)shifted) << 23U);
}

/// Where nothing is left of a power, 120 halvings down.
[[gnu::always_inline]] inline Floats bounded(const Floats& x) {
  const Floats least = Floats{} - 120.0F;
  return x > least ? x : least;
}

/// 2^x for -120 <= x <= 0: by a polynomial of what a whole number leaves, through the values at
/// Chebyshev's nodes. Relative error below 4e-6.
[[gnu::always_inline]] inline Floats power_of_two(const Floats& x) {
  const Floats shifted = x + rounder;
  const Floats rest = x - (shifted - rounder);
  return ((((0.00966636852F * rest + 0.0559219758F) * rest + 0.24022349F) * rest + 0.693121045F) *
              rest +
          1.0F) *
         whole_power(shifted);
}

/// 2^x and 2^-x likewise, by Taylor's series, even and odd terms apart.
struct PowerAndInverse {
  Floats power;
  Floats inverse;
};
[[gnu::always_inline]] inline PowerAndInverse powers_of_two(const Floats& x) {
  constexpr double q = std::numbers::ln2;
  constexpr auto e2 = static_cast<float>(q * q / 2), e4 = static_cast<float>(q * q * q * q / 24);
  constexpr auto o1 = static_cast<float>(q), o3 = static_cast<float>(q * q * q / 6),
                 o5 = static_cast<float>(q * q * q * q * q / 120);
  const Floats shifted = x + rounder;
  const Floats rest = x - (shifted - rounder);
  const Floats square = rest * rest;
  const Floats even = (e4 * square + e2) * square + 1.0F;
  const Floats odd = rest * ((o5 * square + o3) * square + o1);
  return {(even + odd) * whole_power(shifted), (even - odd) * whole_power_of_half(shifted)};
}

/// The surface over a place and how fast it rises there.
struct Surface {
  float elevation_m = 0;
  float rise_m_s = 0;
};

Surface surface_at(Waves& waves, std::size_t count, const SeaMomentPlace& place) {
  constexpr float turn = 2 * std::numbers::pi_v<float>;
  const float east_m = place.east_m, north_m = place.north_m;
  const float east_rad_s = turn * place.east_m_s, north_rad_s = turn * place.north_m_s;
  Floats elevation{}, rise{};
  for (std::size_t i = 0; i < count; i += floats) {
    const Floats east = load(waves.east_turns_m + i);
    const Floats north = load(waves.north_turns_m + i);
    const SineCosine at =
        sine_cosine_of_turns(load(waves.base_turns + i) + (east * east_m + north * north_m));
    const Floats amplitude = load(waves.amplitude_m + i);
    elevation = elevation + amplitude * at.cosine;
    // How fast the phases pass one who moves so.
    const Floats met = load(waves.passing_rad_s + i) - (east * east_rad_s + north * north_rad_s);
    rise = rise + amplitude * (met * at.sine);
    store(at.sine, waves.sine + i);
    store(at.cosine, waves.cosine + i);
    store(met, waves.met_rad_s + i);
  }
  return {sum_of(elevation), sum_of(rise)};
}

/// Where the waves are evaluated, and how fast that level rises.
struct Level {
  float up_m = 0;
  float rise_m_s = 0;
};

/// Wheeler's level h (z - eta)/(h + eta), held within the water.
Level level_of(const SeaMomentPlace& place, const Surface& surface, float depth_m, bool stretched) {
  Level level{place.up_m, place.up_m_s};
  if (stretched) {
    const float column_m = depth_m + surface.elevation_m;
    level.up_m = depth_m * (place.up_m - surface.elevation_m) / column_m;
    level.rise_m_s =
        (depth_m * (place.up_m_s - surface.rise_m_s) - level.up_m * surface.rise_m_s) / column_m;
  }
  if (!(level.up_m < 0)) level.up_m = 0;
  if (level.up_m < -depth_m) level.up_m = -depth_m;
  return level;
}

/// 2^-14 = 6e-5 of a wave's motion at the surface, which has 0.1 m/s at most of its own.
constexpr float unfelt_halvings = 14;

/// Sums over the waves.
struct Motion {
  Floats u{}, v{}, w{}, du{}, dv{}, dw{};
};

/// Adds eight waves whose horizontal motion is there `level` of that at the surface in deep water,
/// and whose vertical one is `upright`.
[[gnu::always_inline]] inline void add(const Waves& waves, std::size_t i, const Floats& level,
                                       const Floats& upright, float climb_m_s, Motion& motion) {
  const Floats sine = load(waves.sine + i);
  const Floats cosine = load(waves.cosine + i);
  const Floats met = load(waves.met_rad_s + i);
  const Floats east = load(waves.east_m_s + i);
  const Floats north = load(waves.north_m_s + i);
  const Floats up = load(waves.up_m_s + i);
  const Floats climb = load(waves.decay_per_m + i) * climb_m_s;
  const Floats forward = level * cosine;
  const Floats crossing = level * sine;
  const Floats standing = upright * cosine;
  const Floats pushed = met * crossing + climb * standing;
  motion.u = motion.u + east * forward;
  motion.v = motion.v + north * forward;
  motion.w = motion.w + up * (upright * sine);
  motion.du = motion.du + east * pushed;
  motion.dv = motion.dv + north * pushed;
  motion.dw = motion.dw + up * (climb * crossing - met * standing);
}

void motion_at(const Waves& waves, std::size_t count, const Level& at, SeaMomentSums& sums) {
  const float up_m = at.up_m;
  const float climb_m_s = std::numbers::ln2_v<float> * at.rise_m_s;
  Motion motion;
  // The waves are sorted: where one does not reach down to the place, nor do those that follow.
  const auto reaches = [&](std::size_t i) -> bool {
    return waves.decay_per_m[i] * up_m >= -unfelt_halvings;
  };
  std::size_t i = 0;
  for (; i < waves.feeling_bed && reaches(i); i += floats) {
    // As in sea_kernel.cc.
    const PowerAndInverse decay = powers_of_two(bounded(load(waves.decay_per_m + i) * up_m));
    const Floats mirrored = load(waves.reflection + i) * decay.inverse;
    add(waves, i, decay.power + mirrored, decay.power - mirrored, climb_m_s, motion);
  }
  for (; i < count && reaches(i); i += floats) {
    const Floats level = power_of_two(bounded(load(waves.decay_per_m + i) * up_m));
    add(waves, i, level, level, climb_m_s, motion);
  }
  sums.velocity_m_s[0] = sum_of(motion.u);
  sums.velocity_m_s[1] = sum_of(motion.v);
  sums.velocity_m_s[2] = sum_of(motion.w);
  sums.acceleration_m_s2[0] = sum_of(motion.du);
  sums.acceleration_m_s2[1] = sum_of(motion.dv);
  sums.acceleration_m_s2[2] = sum_of(motion.dw);
}

void evaluate(const SeaKernelWaves& from, const SeaKernelPlace& reference, bool stretched,
              const SeaMomentPlace* places, std::size_t count, SeaMomentSums* sums) noexcept {
  Waves waves;  // written before it is read: not cleared
  convert(from, reference, waves);
  for (std::size_t i = 0; i < count; ++i) {
    const Surface surface = surface_at(waves, from.count, places[i]);
    sums[i].elevation_m = surface.elevation_m;
    sums[i].rise_m_s = surface.rise_m_s;
    const Level level = level_of(places[i], surface, static_cast<float>(from.depth_m), stretched);
    motion_at(waves, from.count, level, sums[i]);
  }
}

}  // namespace

SeaMomentKernel sea_moment_kernel() noexcept { return evaluate; }

}  // namespace slackwater::SLACKWATER_KERNEL
