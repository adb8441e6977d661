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

/// In one order.
[[gnu::always_inline]] inline float sum_of(const Floats& a) {
  return ((a[0] + a[4]) + (a[1] + a[5])) + ((a[2] + a[6]) + (a[3] + a[7]));
}

/// e^(-2kh) of waves that do not feel the bed: what it mirrors of them is e^(-kh), 1e-4, at most.
constexpr double least_reflection = 1e-8;

/// Eight waves side by side. Arrays of all waves, one after the other, would lie a power of two
/// apart and push each other out of the cache.
struct EightWaves {
  Floats base_turns;  ///< of the phase at the reference
  Floats east_turns_m;
  Floats north_turns_m;
  Floats amplitude_m;
  Floats decay_per_m;
  Floats reflection;
  Floats east_m_s;
  Floats north_m_s;
  Floats up_m_s;
  Floats passing_rad_s;  ///< a place at rest
  // Of the place in hand.
  Floats sine;
  Floats cosine;
  Floats met_rad_s;
};

/// The waves at one moment: what all places share.
struct Waves {
  std::size_t groups = 0;
  std::size_t feeling_bed = 0;  ///< the first so many groups do
  EightWaves eight[most_kernel_waves / floats];
};

/// As floats. A phase of many turns is brought to its rest as a double first.
void convert(const SeaKernelWaves& from, const SeaKernelPlace& reference, Waves& to) {
  constexpr double rounder = 6755399441055744.0;  // 1.5 2^52, see fields/base/numbers/lanes.h
  using Doubles [[gnu::vector_size(64)]] = double;
  const auto doubles = [](const double* values) {
    Doubles out;
    std::memcpy(&out, values, sizeof out);
    return out;
  };
  to.groups = from.count / floats;
  for (std::size_t g = 0; g < to.groups; ++g) {
    const std::size_t i = g * floats;
    EightWaves& eight = to.eight[g];
    const auto as_floats = [&](const double* values) {
      return __builtin_convertvector(doubles(values + i), Floats);
    };
    const Doubles turns = ((doubles(from.east_turns_m + i) * reference.east_m +
                            doubles(from.north_turns_m + i) * reference.north_m) -
                           doubles(from.turns_s + i) * reference.t_s) +
                          doubles(from.phase_turns + i);
    eight.base_turns = __builtin_convertvector(turns - ((turns + rounder) - rounder), Floats);
    eight.east_turns_m = as_floats(from.east_turns_m);
    eight.north_turns_m = as_floats(from.north_turns_m);
    eight.amplitude_m = as_floats(from.amplitude_m);
    eight.decay_per_m = as_floats(from.decay_per_m);
    eight.east_m_s = as_floats(from.east_m_s);
    eight.north_m_s = as_floats(from.north_m_s);
    eight.up_m_s = as_floats(from.up_m_s);
    eight.passing_rad_s =
        __builtin_convertvector(2 * std::numbers::pi * doubles(from.turns_s + i), Floats);
    const Doubles reflection = doubles(from.reflection + i);
    eight.reflection =
        __builtin_convertvector(reflection < least_reflection ? Doubles{} : reflection, Floats);
  }
  to.feeling_bed = 0;
  while (to.feeling_bed < to.groups && from.reflection[to.feeling_bed * floats] > least_reflection)
    ++to.feeling_bed;
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

Surface surface_at(Waves& waves, const SeaMomentPlace& place, float factor) {
  constexpr float turn = 2 * std::numbers::pi_v<float>;
  const float east_m = place.east_m, north_m = place.north_m;
  const float east_rad_s = turn * place.east_m_s, north_rad_s = turn * place.north_m_s;
  Floats elevation{}, rise{};
  for (std::size_t g = 0; g < waves.groups; ++g) {
    EightWaves& eight = waves.eight[g];
    const Floats east = eight.east_turns_m;
    const Floats north = eight.north_turns_m;
    const SineCosine at =
        sine_cosine_of_turns(eight.base_turns + (east * east_m + north * north_m));
    elevation = elevation + eight.amplitude_m * at.cosine;
    // How fast the phases pass one who moves so.
    const Floats met = eight.passing_rad_s - (east * east_rad_s + north * north_rad_s);
    rise = rise + eight.amplitude_m * (met * at.sine);
    eight.sine = at.sine;
    eight.cosine = at.cosine;
    eight.met_rad_s = met;
  }
  return {factor * sum_of(elevation), factor * sum_of(rise)};
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
[[gnu::always_inline]] inline void add(const EightWaves& eight, const Floats& level,
                                       const Floats& upright, float climb_m_s, Motion& motion) {
  const Floats climb = eight.decay_per_m * climb_m_s;
  const Floats forward = level * eight.cosine;
  const Floats crossing = level * eight.sine;
  const Floats standing = upright * eight.cosine;
  const Floats pushed = eight.met_rad_s * crossing + climb * standing;
  motion.u = motion.u + eight.east_m_s * forward;
  motion.v = motion.v + eight.north_m_s * forward;
  motion.w = motion.w + eight.up_m_s * (upright * eight.sine);
  motion.du = motion.du + eight.east_m_s * pushed;
  motion.dv = motion.dv + eight.north_m_s * pushed;
  motion.dw = motion.dw + eight.up_m_s * (climb * crossing - eight.met_rad_s * standing);
}

void motion_at(const Waves& waves, const Level& at, float factor, SeaMomentSums& sums) {
  const float up_m = at.up_m;
  const float climb_m_s = std::numbers::ln2_v<float> * at.rise_m_s;
  Motion motion;
  // The waves are sorted: where one does not reach down to the place, nor do those that follow.
  const auto reaches = [&](const EightWaves& eight) -> bool {
    return eight.decay_per_m[0] * up_m >= -unfelt_halvings;
  };
  std::size_t g = 0;
  for (; g < waves.feeling_bed && reaches(waves.eight[g]); ++g) {
    // As in sea_kernel.cc.
    const EightWaves& eight = waves.eight[g];
    const PowerAndInverse decay = powers_of_two(bounded(eight.decay_per_m * up_m));
    const Floats mirrored = eight.reflection * decay.inverse;
    add(eight, decay.power + mirrored, decay.power - mirrored, climb_m_s, motion);
  }
  for (; g < waves.groups && reaches(waves.eight[g]); ++g) {
    const EightWaves& eight = waves.eight[g];
    const Floats level = power_of_two(bounded(eight.decay_per_m * up_m));
    add(eight, level, level, climb_m_s, motion);
  }
  sums.velocity_m_s[0] = factor * sum_of(motion.u);
  sums.velocity_m_s[1] = factor * sum_of(motion.v);
  sums.velocity_m_s[2] = factor * sum_of(motion.w);
  sums.acceleration_m_s2[0] = factor * sum_of(motion.du);
  sums.acceleration_m_s2[1] = factor * sum_of(motion.dv);
  sums.acceleration_m_s2[2] = factor * sum_of(motion.dw);
}

void evaluate(const SeaKernelWaves& from, const SeaKernelPlace& reference, bool stretched,
              const SeaMomentPlace* places, std::size_t count, SeaMomentSums* sums) noexcept {
  Waves waves;  // written before it is read: not cleared
  convert(from, reference, waves);
  const auto factor = static_cast<float>(reference.height_factor);
  for (std::size_t i = 0; i < count; ++i) {
    const Surface surface = surface_at(waves, places[i], factor);
    sums[i].elevation_m = surface.elevation_m;
    sums[i].rise_m_s = surface.rise_m_s;
    const Level level = level_of(places[i], surface, static_cast<float>(from.depth_m), stretched);
    motion_at(waves, level, factor, sums[i]);
  }
}

}  // namespace

SeaMomentKernel sea_moment_kernel() noexcept { return evaluate; }

}  // namespace slackwater::SLACKWATER_KERNEL
