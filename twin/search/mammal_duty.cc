#include "twin/search/mammal_duty.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

void note(Stretches& stretches, bool is_now, double from_s, double to_s) {
  const bool was_on = is_on(stretches);
  if (is_now && !was_on) stretches.push_back(from_s);
  if (!is_now && was_on) stretches.push_back(to_s);
}

}  // namespace

bool is_within(const Stretches& stretches, double t_s, double until_s) noexcept {
  const auto after = std::lower_bound(stretches.begin(), stretches.end(), t_s);
  return t_s <= until_s && (after - stretches.begin()) % 2 == 1;
}

void load(MammalDuty& duty, const std::filesystem::path& data_folder) {
  duty.kind = read_mammal(duty.animal, data_folder);
  duty.sight = read_mammal_watch(duty.watch, data_folder);
}

MammalDutyState begin_duty(const MammalDuty& duty, const Triple<double>& noise_m,
                           std::uint64_t seed, const std::string& vehicle) {
  expects(duty.kind.surfaces_every_s > 0, "a watch is loaded before it begins");
  MammalDutyState state;
  state.noise_m = noise_m;
  state.mammals = begin_swim({duty.kind, noise_m.x, noise_m.y, duty.half_side_m, duty.count},
                             Rng(seed, "twin/mammals/" + duty.animals));
  state.watch_rng = Rng(seed, "twin/mammals/" + duty.animals + "/" + vehicle);
  state.sightings_s.reserve(64);
  state.watched_s.reserve(16);
  state.inside_s.reserve(32);
  return state;
}

void watch_on(const MammalDuty& duty, double wind_10m_m_s, const Triple<double>& vehicle_m,
              bool is_out, double t_s, double dt_s, MammalDutyState& state) {
  swim({duty.kind, state.noise_m.x, state.noise_m.y, duty.half_side_m, duty.count}, dt_s,
       state.mammals);
  const double radius_m = duty.noise.radius_m;
  note(state.inside_s, count_within(state.mammals, state.noise_m, radius_m) > 0, t_s - dt_s,
       t_s - dt_s);
  note(state.watched_s, is_out, t_s - dt_s, t_s - dt_s);
  state.until_s = t_s;
  // The draws are the same in number whether it is out or not.
  const CueSight sight = is_out ? sight_at(duty.sight, wind_10m_m_s) : CueSight{};
  bool is_seen = false;
  look_for_mammals(duty.sight, sight, vehicle_m, state.mammals.animals, state.watch_rng,
                   [&](const Mammal& animal) {
                     is_seen |= std::hypot(animal.position_m.x - state.noise_m.x,
                                           animal.position_m.y - state.noise_m.y) <= radius_m;
                   });
  if (is_seen) state.sightings_s.push_back(t_s);
}

NoiseRecord noise_under(const NoiseRule& rule, std::span<const MammalDutyState* const> watches,
                        double end_s, double dt_s) {
  NoiseRecord record;
  NoiseGate gate;
  const auto steps = static_cast<std::int64_t>(std::llround(end_s / dt_s));
  for (std::int64_t i = 1; i <= steps; ++i) {
    const double t_s = static_cast<double>(i) * dt_s;
    bool is_seen = false, is_watched = false, is_inside = false;
    for (const MammalDutyState* watch : watches) {
      const auto seen =
          std::lower_bound(watch->sightings_s.begin(), watch->sightings_s.end(), t_s - 0.5 * dt_s);
      is_seen |= seen != watch->sightings_s.end() && *seen < t_s + 0.5 * dt_s;
      is_watched |= is_within(watch->watched_s, t_s - 0.5 * dt_s, watch->until_s);
      is_inside |= is_within(watch->inside_s, t_s - 0.5 * dt_s, watch->until_s);
    }
    const bool was_on = gate.is_on != 0;
    step_noise(rule, t_s, dt_s, is_seen, is_watched, gate);
    if (was_on && is_inside) record.exposed_s += dt_s;
    note(record.noisy_s, gate.is_on != 0, t_s, t_s);
  }
  record.noise_s = gate.noise_s;
  record.stops = gate.stops;
  return record;
}

}  // namespace slackwater::twin
