#include "twin/search/person_search.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {

void load(PersonSearch& search, const std::filesystem::path& data_folder) {
  search.drifts = read_leeway(search.object, data_folder);
  search.eyes = read_search_lookout(search.lookout, search.drifts.seen_as, data_folder);
}

SearchState begin_search(const PersonSearch& search, const Triple<double>& last_known_m,
                         const SearchWater& water, std::uint64_t seed, const std::string& vehicle) {
  expects(!search.eyes.width_m.empty(), "a search is loaded before it begins");
  SearchState state;
  Rng rng(seed, "twin/search/" + search.person);
  state.drifter = {draw_leeway(search.drifts, rng), search.drifts.jibe_rate_per_s,
                   search.diffusivity_m2_s};
  state.person = begin_drift(last_known_m, search.radius_m, rng);
  constexpr double step_s = 10;
  for (double left_s = search.elapsed_s; left_s > 0; left_s -= step_s)
    drift(state.drifter, water.current_m_s, water.wind_10m_m_s, std::min(left_s, step_s),
          state.person);
  state.eyes_rng = Rng(seed, "twin/search/" + search.person + "/" + vehicle);
  return state;
}

bool search_on(const PersonSearch& search, const SearchWater& water,
               const Triple<double>& vehicle_m, bool is_looking, double t_s, double dt_s,
               SearchState& state) noexcept {
  drift(state.drifter, water.current_m_s, water.wind_10m_m_s, dt_s, state.person);
  const Triple<double> off_m = state.person.position_m - vehicle_m;
  // The first look of a watch has no way behind it.
  const Triple<double> from_m = state.is_looking ? state.off_m : off_m;
  state.off_m = off_m;
  state.is_looking = is_looking;
  if (!is_looking || state.is_found) return false;
  const SightConditions sight{std::hypot(water.wind_10m_m_s.x, water.wind_10m_m_s.y),
                              water.wave_height_m,
                              water.visibility_m.value_or(search.visibility_m)};
  const double width_m = sweep_width_m(search.eyes, sight);
  if (!detected(look_exposure(search.eyes.law, width_m, from_m, off_m, dt_s), state.eyes_rng))
    return false;
  state.is_found = true;
  state.found_s = t_s;
  state.found_at_m = std::hypot(off_m.x, off_m.y);
  return true;
}

}  // namespace slackwater::twin
