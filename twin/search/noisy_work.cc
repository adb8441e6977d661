#include "twin/search/noisy_work.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {

void add_to(ZoneReport& report, const MammalDutyState& watch, bool is_there) noexcept {
  report.is_watched |= is_there && is_on(watch.watched_s);
  if (!watch.sightings_s.empty()) report.seen_s = std::max(report.seen_s, watch.sightings_s.back());
}

void hear(const ZoneRule& rule, const ZoneReport& report, double t_s,
          NoisyWorkState& state) noexcept {
  if (report.seen_s > state.clear_since_s) {
    state.clear_since_s = report.seen_s;
    state.is_seen = true;
  }
  if (!report.is_watched) {
    state.clear_since_s = t_s;
    state.is_seen = false;
  }
  const double wanted_s = state.noisy_s.empty() ? rule.clear_for_s : rule.again_after_s;
  state.is_clear = report.is_watched && t_s - state.clear_since_s >= wanted_s;
}

void note_noise(bool is_noisy, double t_s, NoisyWorkState& state) {
  const bool was_noisy = is_on(state.noisy_s);
  if (is_noisy == was_noisy) return;
  state.noisy_s.push_back(t_s);
  if (was_noisy && !state.is_clear && state.is_seen) state.stops += 1;
}

NoiseRecord noise_made(const NoisyWorkState& state, std::span<const MammalDutyState* const> watches,
                       double end_s, double dt_s) {
  NoiseRecord record;
  record.stops = state.stops;
  record.noisy_s = state.noisy_s;
  for (std::size_t i = 0; i < state.noisy_s.size(); i += 2)
    record.noise_s +=
        (i + 1 < state.noisy_s.size() ? state.noisy_s[i + 1] : end_s) - state.noisy_s[i];
  const auto steps = static_cast<std::int64_t>(std::llround(end_s / dt_s));
  for (std::int64_t i = 0; i < steps; ++i) {
    const double t_s = (static_cast<double>(i) + 0.5) * dt_s;
    const bool is_inside = std::any_of(watches.begin(), watches.end(), [&](const auto* watch) {
      return is_within(watch->inside_s, t_s, watch->until_s);
    });
    if (is_inside && is_within(state.noisy_s, t_s, end_s)) record.exposed_s += dt_s;
  }
  return record;
}

}  // namespace slackwater::twin
