#pragma once
#include <array>
#include <filesystem>
#include <span>
#include <string>

#include "twin/search/mammals.h"

namespace slackwater::twin {

/// The force on Beaufort's scale, not rounded: v = 0.836 m/s B^(3/2).
/// Source: WMO, Commission for Maritime Meteorology (1970), Marine Science Affairs report 3.
[[nodiscard]] double beaufort_force(double wind_10m_m_s) noexcept;

/// What a watch makes of one cue at a distance r:
///
///   g(r) = g0 exp(-r^2/(2 s^2)),  s = w sqrt(2/pi),
///
/// so that w is the effective half width of the strip: the integral of g/g0 (Buckland et al. 2001).
struct CueSight {
  double half_width_m = 0;    ///< w
  double chance_at_zero = 0;  ///< g0
  bool operator==(const CueSight&) const = default;
};
[[nodiscard]] double chance_of_cue(const CueSight& sight, double distance_m) noexcept;

enum class Cue { surfacing, call };

/// How far who watches for marine mammals sees, or hears, by the state of the sea.
struct MammalWatch {
  static constexpr std::size_t forces = 7;
  std::string name;
  Cue cue = Cue::surfacing;
  std::array<CueSight, forces> by_force;  ///< Beaufort 0 to 6
  bool operator==(const MammalWatch&) const = default;
};

/// Reads data/watches/NAME.yaml: name, source, status, cue: surfacing | call, half_width_m and
/// chance_at_zero, seven numbers each. @throws Error(invalid_input), also where a rougher sea
/// shows more
[[nodiscard]] MammalWatch read_mammal_watch(const std::string& name,
                                            const std::filesystem::path& data_folder);

/// Linear between forces; nothing is seen from one force beyond the last on.
[[nodiscard]] CueSight sight_at(const MammalWatch& watch, double wind_10m_m_s) noexcept;

/// The chance that an animal which stays anywhere within `radius_m` of a watch is noticed at least
/// once in `watch_s`, its cues as a Poisson process:
///
///   P = 1 - (2/R^2) integral_0^R exp(-g(r) T/every) r dr.
[[nodiscard]] double chance_in_watch(const CueSight& sight, double radius_m, double watch_s,
                                     double cue_every_s);

/// Which animals a watch notices in a step, by their cues in it. Draws one number for each animal.
/// @param from_m  where the watch is, NED
/// @param heard   called for each animal that is noticed
template <typename Noticed>
void look_for_mammals(const MammalWatch& watch, const CueSight& sight, const Triple<double>& from_m,
                      std::span<const Mammal> animals, Rng& rng, Noticed&& noticed);

/// When noise may be made.
struct NoiseRule {
  double radius_m = 500;  ///< about the noise
  double watch_s = 1800;  ///< without a sighting within the radius before it starts
  double wanted_s = 0;    ///< of noise, in all
  bool operator==(const NoiseRule&) const = default;
};

/// How far the noisy work has come.
struct NoiseGate {
  double clear_since_s = 0;  ///< the watch's start, or the last sighting
  double is_on = 0;          ///< 1: noise is being made
  double noise_s = 0;
  double stops = 0;  ///< for an animal, so far
};

/// One step of it: a sighting within the radius stops the noise at once, and it starts (again) when
/// the watch has lasted `watch_s` without one; it ends when there was as much as wanted.
///
/// Stricter than the JNCC's protocol for piling (2010: 500 m, 30 minutes before, 20 minutes from
/// the last sighting), which lets a pile be finished at full power.
///
/// @param t_s      at the end of the step
/// @param is_seen  an animal within the radius, in the step
/// @param watched  somebody watches: a time without counts for nothing, noise ends with the watch
void step_noise(const NoiseRule& rule, double t_s, double dt_s, bool is_seen, bool watched,
                NoiseGate& gate) noexcept;

template <typename Noticed>
void look_for_mammals(const MammalWatch& watch, const CueSight& sight, const Triple<double>& from_m,
                      std::span<const Mammal> animals, Rng& rng, Noticed&& noticed) {
  for (const Mammal& animal : animals) {
    const double lot = rng.uniform();
    if ((watch.cue == Cue::surfacing ? animal.surfaced : animal.called) == 0) continue;
    const Triple<double> off = animal.position_m - from_m;
    if (lot < chance_of_cue(sight, length_of(Triple<double>{off.x, off.y, 0}))) noticed(animal);
  }
}

}  // namespace slackwater::twin
