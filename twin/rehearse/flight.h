#pragma once
#include <atomic>
#include <span>
#include <vector>

#include "twin/account/vehicle_account.h"
#include "twin/run/set_up.h"

namespace slackwater::twin {

/// One flight of a mission: when, and in which future.
struct FlightCase {
  UtcTime start;
  std::size_t member = 0;
};

/// What is kept of a vehicle's flight, every `every_s`.
struct FlightSample {
  float north_m = 0;
  float east_m = 0;
  float down_m = 0;
  float charge = 1;
  float needed = 0;  ///< charge that the way home, its margin and the reserve take
  float current_m_s = 0;
  float wind_m_s = 0;
  float wave_height_m = 0;
  std::uint8_t phase = 0;
  std::uint8_t doing = 0;
};

struct Flight {
  FlightCase flown;
  /// By all whose work counts, and no other vehicle was lost; whom they searched for was found, and
  /// the noise under their watch was made where it is not the work of one of them.
  bool is_done = false;
  std::string stopped_by;  ///< "surveyor: limit: ..."; empty: nothing
  /// Whether all inspections covered what is asked of them, done or not; nothing: none is asked.
  std::optional<bool> is_seen;
  std::string unseen_by;  ///< "less than 90 % covered by the ... (surveyor)"; empty: nothing
  double ended_s = 0;
  std::optional<double> found_s;     ///< when any vehicle found whom they search for
  std::optional<NoiseRecord> noise;  ///< of work that their watches for mammals let go on
  std::vector<VehicleAccount> vehicles;
  std::vector<std::vector<FlightSample>> samples;  ///< of each vehicle

  /// Done, and where something is to be seen, seen.
  [[nodiscard]] bool is_success() const noexcept { return is_done && is_seen.value_or(true); }
};

struct FlightSettings {
  double sample_every_s = 60;
  std::vector<std::string> workers;  ///< whose success counts; none: all that conduct themselves
};

/// The seed of a case: sea, gusts and pilots of a member are its own, and the same whatever other
/// cases are flown. Below 2^31, as scenarios have it.
[[nodiscard]] std::uint64_t seed_of(std::uint64_t mission_seed, const FlightCase& flown) noexcept;

/// Rays of a look of what inspects, where many futures are flown: coverage is within two points of
/// that with 2000 (tests/twin/inspection/coverage_test.cc).
inline constexpr std::size_t rays_per_look_of_many = 80;

/// The surround of a mission with what all its flights share: vehicles read, inspections made
/// ready. @throws Error(invalid_input) that names the vehicle
[[nodiscard]] Surround shared_by_flights(const Scenario& mission, Surround surround);

/// Flies some cases side by side in one run, eight vehicles of a kind at a time: the same to the
/// last bit as each by itself.
/// @param surround  `shared_by_flights`, or it is done here
/// @throws Error(invalid_input) as `set_up`
[[nodiscard]] std::vector<Flight> fly(const Scenario& mission, const Surround& surround,
                                      std::span<const FlightCase> cases,
                                      const FlightSettings& settings);

}  // namespace slackwater::twin
