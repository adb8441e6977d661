#pragma once
#include <optional>
#include <string>
#include <vector>

#include "twin/search/mammal_watch.h"

namespace slackwater::twin {

/// Animals about noisy work, and how a vehicle watches for them beside whatever it does.
///
/// Vehicles of a mission that watch for the same animals each carry them: they come of the seed and
/// swim alike in all their states.
struct MammalDuty {
  std::string animals = "mammals";        ///< names their stream
  std::string animal;                     ///< in data/mammals
  std::string watch;                      ///< in data/watches
  std::size_t count = 0;                  ///< in the square
  double half_side_m = 0;                 ///< of the square about the noise
  std::optional<Triple<double>> noise_m;  ///< NED; absent: the structure the vehicle is nearest to
  NoiseRule noise;
  /// The vehicle whose work is the noise; empty: a schedule of the watch's own, as `noise` says.
  std::string noise_by;
  /// For how long the zone has to be clear before that work goes on after a sighting; absent: as
  /// long as before it begins.
  std::optional<double> again_after_s;
  MammalKind kind;    ///< the animal, once `load` has read it
  MammalWatch sight;  ///< the watch, likewise
  bool operator==(const MammalDuty&) const = default;
};

/// Reads what the names stand for. @throws Error(invalid_input)
void load(MammalDuty& duty, const std::filesystem::path& data_folder);

/// Stretches of time: each begins at an even place of the list and ends at the next; one that goes
/// on has no end yet.
using Stretches = std::vector<double>;
/// Whether one goes on.
[[nodiscard]] inline bool is_on(const Stretches& stretches) noexcept {
  return stretches.size() % 2 == 1;
}
/// Whether t lies in one of them; `until_s` ends one that goes on.
[[nodiscard]] bool is_within(const Stretches& stretches, double t_s, double until_s) noexcept;

/// What a watch has come to. Noise on a schedule moves neither vehicles nor animals, so that when
/// it was made is worked out afterwards, of what all watches noticed; a vehicle whose work is the
/// noise hears of it while it works (`noisy_work.h`).
struct MammalDutyState {
  MammalsState mammals;
  Rng watch_rng{0, ""};
  Triple<double> noise_m;
  std::vector<double> sightings_s;  ///< of an animal within the radius
  Stretches watched_s;              ///< it was out there, looking
  Stretches inside_s;               ///< an animal was within the radius
  double until_s = 0;               ///< the last step
};
[[nodiscard]] MammalDutyState begin_duty(const MammalDuty& duty, const Triple<double>& noise_m,
                                         std::uint64_t seed, const std::string& vehicle);

/// Lets the animals swim for `dt_s` and looks for them.
/// @param wind_10m_m_s  speed at the vehicle
/// @param is_out        nobody watches from a deck at home
void watch_on(const MammalDuty& duty, double wind_10m_m_s, const Triple<double>& vehicle_m,
              bool is_out, double t_s, double dt_s, MammalDutyState& state);

/// How the noisy work went.
struct NoiseRecord {
  double noise_s = 0;
  double stops = 0;      ///< for an animal
  double exposed_s = 0;  ///< noise with an animal within the radius, seen or not
  Stretches noisy_s;
  std::string by;  ///< the vehicle whose work it was; empty: a schedule of the watch's own
  [[nodiscard]] bool is_done(const NoiseRule& rule) const { return noise_s >= rule.wanted_s; }
};

/// The noise that the watches together let be made from 0 to `end_s`, in steps of `dt_s`: a
/// sighting by any stops it, and a time that none watches lets none begin or go on.
[[nodiscard]] NoiseRecord noise_under(const NoiseRule& rule,
                                      std::span<const MammalDutyState* const> watches, double end_s,
                                      double dt_s);

}  // namespace slackwater::twin
