#pragma once
#include "twin/rehearse/flight.h"

namespace slackwater::twin {

/// What came of the reserve of a vehicle, from good to bad.
enum class ReserveFate {
  kept,  ///< home with it, and not because of it; also who turned for home for something else
  called_home,  ///< home with it, since it turned for home before its work was done
  broken,       ///< home with less, or its battery was empty
  not_home,     ///< lost, or out of time
};
inline constexpr std::size_t reserve_fate_count = 4;
/// kept, called_home, broken, not_home.
[[nodiscard]] const char* name_of(ReserveFate fate) noexcept;

/// @param reserve_share  of its conduct
[[nodiscard]] ReserveFate reserve_fate(const VehicleAccount& vehicle, double reserve_share);
/// The worst of the vehicles whose work counts.
[[nodiscard]] ReserveFate reserve_fate(const Flight& flight, const Scenario& mission,
                                       const FlightSettings& settings);

/// Whether a vehicle's work counts.
[[nodiscard]] bool counts(const ScenarioVehicle& vehicle, const FlightSettings& settings);

}  // namespace slackwater::twin
