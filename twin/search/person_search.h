#pragma once
#include <optional>
#include <string>

#include "twin/search/drifter.h"
#include "twin/search/search_lookout.h"

namespace slackwater::twin {

/// Somebody in the water, and who of a vehicle looks out for him, beside whatever it does.
///
/// Vehicles of a mission that search for one person each carry the same search: they draw the same
/// drifter from the seed, and he drifts alike in all their states while their conducts last and
/// tick alike. A vehicle that found him goes on with what it does.
struct PersonSearch {
  std::string person = "person";  ///< whom: names the streams he is drawn from
  std::string object;             ///< in data/leeway
  std::string lookout;            ///< in data/lookouts
  std::optional<Triple<double>>
      last_known_m;      ///< NED; absent: the first waypoint of the vehicle's work
  double radius_m = 0;   ///< probable error of that
  double elapsed_s = 0;  ///< that he has drifted before the start, in the water and wind of it
  double diffusivity_m2_s = 0;
  double visibility_m = 0;
  LeewayObject drifts;  ///< the object, once `load` has read it
  SearchLookout eyes;   ///< the look-out, likewise
  bool operator==(const PersonSearch&) const = default;
};

/// Reads what the names stand for. @throws Error(invalid_input)
void load(PersonSearch& search, const std::filesystem::path& data_folder);

/// How far a vehicle's search has come.
struct SearchState {
  Drifter drifter;
  DrifterState person;
  Rng eyes_rng{0, ""};
  Triple<double> off_m;     ///< the person from the vehicle, at the last look
  bool is_looking = false;  ///< at the last look it looked
  bool is_lost = false;     ///< the person, out of the forecast: nobody knows where to
  bool is_found = false;
  double found_s = 0;     ///< when
  double found_at_m = 0;  ///< from how far
};

/// What the person drifts in and the look-out looks through.
struct SearchWater {
  Triple<double> current_m_s;            ///< NED, where the person is
  Triple<double> wind_10m_m_s;           ///< NED, there too
  double wave_height_m = 0;              ///< significant
  std::optional<double> visibility_m{};  ///< in air; absent: as the search has it
};

/// @param seed, vehicle  name the streams: the person's by the seed alone
/// @param water          at the start, at the last known position
[[nodiscard]] SearchState begin_search(const PersonSearch& search,
                                       const Triple<double>& last_known_m, const SearchWater& water,
                                       std::uint64_t seed, const std::string& vehicle);

/// Lets the person drift on for `dt_s` and looks out for him from where the vehicle is then.
/// @param is_looking  it is out there; nobody looks out from a deck at home
/// @return whether it has found him just now
bool search_on(const PersonSearch& search, const SearchWater& water,
               const Triple<double>& vehicle_m, bool is_looking, double t_s, double dt_s,
               SearchState& state) noexcept;

}  // namespace slackwater::twin
