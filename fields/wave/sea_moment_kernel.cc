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

/// The waves at one moment: what all places share.
struct Waves {
  alignas(64) float base_turns[most_kernel_waves];  ///< of the phase at the reference
  alignas(64) float east_turns_m[most_kernel_waves];
  alignas(64) float north_turns_m[most_kernel_waves];
  alignas(64) float amplitude_m[most_kernel_waves];
  alignas(64) float decay_per_m[most_kernel_waves];
  alignas(64) float reflection[most_kernel_waves];
  alignas(64) float east_m_s[most_kernel_waves];
  alignas(64) float north_m_s[most_kernel_waves];
  alignas(64) float up_m_s[most_kernel_waves];
  alignas(64) float intrinsic_rad_s[most_kernel_waves];
  // Of the place in hand.
  alignas(64) float sine[most_kernel_waves];
  alignas(64) float cosine[most_kernel_waves];
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
  as_floats(from.intrinsic_rad_s, to.intrinsic_rad_s);
  // What would become subnormal mirrors nothing.
  for (std::size_t i = 0; i < from.count; ++i)
    to.reflection[i] = from.reflection[i] < 1e-30 ? 0.0F : static_cast<float>(from.reflection[i]);
}

constexpr float rounder = 12582912.0F;  ///< 1.5 2^23: a sum with it has no room for a fraction

/// sin and cos of an angle in turns, |turns| < 2^22: Taylor's series of a quarter of what is left
/// of whole turns, at most pi/4, doubled twice. Error below 3e-6.
struct SineCosine {
  Floats sine;
  Floats cosine;
};
[[gnu::always_inline]] inline SineCosine sine_cosine_of_turns(const Floats& turns) {
  constexpr double q = std::numbers::pi / 2;
  constexpr auto s1 = static_cast<float>(q), s3 = static_cast<float>(-q * q * q / 6),
                 s5 = static_cast<float>(q * q * q * q * q / 120),
                 s7 = static_cast<float>(-q * q * q * q * q * q * q / 5040);
  constexpr auto c2 = static_cast<float>(-q * q / 2), c4 = static_cast<float>(q * q * q * q / 24),
                 c6 = static_cast<float>(-q * q * q * q * q * q / 720),
                 c8 = static_cast<float>(q * q * q * q * q * q * q * q / 40320);
  const Floats rest = turns - ((turns + rounder) - rounder);
  const Floats square = rest * rest;
  const Floats sine = rest * (((s7 * square + s5) * square + s3) * square + s1);
  const Floats cosine = (((c8 * square + c6) * square + c4) * square + c2) * square + 1.0F;
  const Floats twice = sine + sine;
  const Floats half_sine = twice * cosine;
  const Floats half_cosine = 1.0F - twice * sine;
  const Floats twice_half = half_sine + half_sine;
  return {twice_half * half_cosine, 1.0F - twice_half * half_sine};
}

/// 2^x and 2^-x for |x| <= 120 (a smaller x counts as -120): Taylor's series of what a whole number
/// leaves, even and odd terms apart. Relative error below 1e-6.
struct PowerAndInverse {
  Floats power;
  Floats inverse;
};
[[gnu::always_inline]] inline PowerAndInverse powers_of_two(const Floats& x) {
  constexpr double q = std::numbers::ln2;
  constexpr auto e2 = static_cast<float>(q * q / 2), e4 = static_cast<float>(q * q * q * q / 24),
                 e6 = static_cast<float>(q * q * q * q * q * q / 720);
  constexpr auto o1 = static_cast<float>(q), o3 = static_cast<float>(q * q * q / 6),
                 o5 = static_cast<float>(q * q * q * q * q / 120);
  const Floats least = Floats{} - 120.0F;
  const Floats bounded = x > least ? x : least;
  const Floats shifted = bounded + rounder;
  const Floats rest = bounded - (shifted - rounder);
  const Floats square = rest * rest;
  const Floats even = ((e6 * square + e4) * square + e2) * square + 1.0F;
  const Floats odd = rest * ((o5 * square + o3) * square + o1);
  const auto up = (Floats)(((Bits)shifted + 127U) << 23U);
  const auto down = (Floats)((127U - (Bits)shifted) << 23U);
  return {(even + odd) * up, (even - odd) * down};
}

float elevation_at(Waves& waves, std::size_t count, const SeaMomentPlace& place) {
  Floats sum{};
  for (std::size_t i = 0; i < count; i += floats) {
    const Floats turns =
        load(waves.base_turns + i) + (load(waves.east_turns_m + i) * place.east_m +
                                      load(waves.north_turns_m + i) * place.north_m);
    const SineCosine at = sine_cosine_of_turns(turns);
    sum = sum + load(waves.amplitude_m + i) * at.cosine;
    store(at.sine, waves.sine + i);
    store(at.cosine, waves.cosine + i);
  }
  return sum_of(sum);
}

/// 2^-14 = 6e-5 of a wave's motion at the surface, which has 0.1 m/s at most of its own.
constexpr float unfelt_halvings = 14;

void motion_at(const Waves& waves, std::size_t count, float up_m, SeaMomentSums& sums) {
  Floats u{}, v{}, w{}, du{}, dv{}, dw{};
  for (std::size_t i = 0; i < count; i += floats) {
    // The waves are sorted: these and all that follow do not reach down here.
    if (waves.decay_per_m[i] * up_m < -unfelt_halvings) break;
    // As in sea_kernel.cc.
    const PowerAndInverse decay = powers_of_two(load(waves.decay_per_m + i) * up_m);
    const Floats mirrored = load(waves.reflection + i) * decay.inverse;
    const Floats sine = load(waves.sine + i);
    const Floats cosine = load(waves.cosine + i);
    const Floats level = decay.power + mirrored;
    const Floats forward = level * cosine;
    const Floats lift = load(waves.up_m_s + i) * (decay.power - mirrored);
    const Floats east = load(waves.east_m_s + i);
    const Floats north = load(waves.north_m_s + i);
    const Floats sigma = load(waves.intrinsic_rad_s + i);
    const Floats pushed = sigma * (level * sine);
    u = u + east * forward;
    v = v + north * forward;
    w = w + lift * sine;
    du = du + east * pushed;
    dv = dv + north * pushed;
    dw = dw - sigma * (lift * cosine);
  }
  sums.velocity_m_s[0] = sum_of(u);
  sums.velocity_m_s[1] = sum_of(v);
  sums.velocity_m_s[2] = sum_of(w);
  sums.acceleration_m_s2[0] = sum_of(du);
  sums.acceleration_m_s2[1] = sum_of(dv);
  sums.acceleration_m_s2[2] = sum_of(dw);
}

/// Wheeler's level, held within the water.
float level_of(float up_m, float elevation_m, float depth_m, bool stretched) {
  const float up = stretched ? depth_m * (up_m - elevation_m) / (depth_m + elevation_m) : up_m;
  if (!(up < 0)) return 0;
  return up < -depth_m ? -depth_m : up;
}

void evaluate(const SeaKernelWaves& from, const SeaKernelPlace& reference, bool stretched,
              const SeaMomentPlace* places, std::size_t count, SeaMomentSums* sums) noexcept {
  Waves waves;  // written before it is read: not cleared
  convert(from, reference, waves);
  for (std::size_t i = 0; i < count; ++i) {
    sums[i].elevation_m = elevation_at(waves, from.count, places[i]);
    const float up_m =
        level_of(places[i].up_m, sums[i].elevation_m, static_cast<float>(from.depth_m), stretched);
    motion_at(waves, from.count, up_m, sums[i]);
  }
}

}  // namespace

SeaMomentKernel sea_moment_kernel() noexcept { return evaluate; }

}  // namespace slackwater::SLACKWATER_KERNEL
