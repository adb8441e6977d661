#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "api/door/people/run_place.h"
#include "twin/risk/workability/sun_position.h"
#include "twin/traffic/traffic_picture.h"

namespace slackwater::people {

/// A vessel that passes by.
struct VesselNow {
  std::uint32_t mmsi = 0;
  std::string name;
  double east_m = 0, north_m = 0;
  Horizontal velocity_m_s;  ///< over ground
  std::optional<double> length_m;
};

/// The forecast's current at a depth, led.
struct CurrentAtDepth {
  double depth_m = 0;
  Horizontal towards_m_s;
};

/// The weather at the origin of the run, as its vehicles have it, and who passes by.
struct Surroundings {
  std::optional<Horizontal> wind_10m_m_s, hub_wind_m_s;  ///< towards, free; absent: nobody knows
  std::optional<SeaState> sea;
  double waves_factor = 1;  ///< on the heights of the run's waves now (height_course.h)
  std::optional<Horizontal> current_m_s;                   ///< towards, at the surface
  std::vector<CurrentAtDepth> currents;                    ///< from the surface to the bed
  std::optional<double> visibility_m, water_visibility_m;  ///< where somebody says so
  twin::SunPosition sun;
  twin::WeatherAsked asked;          ///< what is led
  double settled_s = 0;              ///< of the run: when it is as asked
  std::vector<VesselNow> vessels;    ///< nearest first
  std::size_t vessels_left_out = 0;  ///< farther ones
};

/// @param t_s  since the start of the run
[[nodiscard]] twin::SunPosition sun_at(const GeoPoint& origin, UtcTime start, double t_s);

/// Looks round at a time of the run. Costs microseconds, and a copy of each vessel. What is led of
/// the weather is what the environment has in hand now: of a run that goes on, on its thread, at a
/// barrier.
/// @param vehicles_m  where they are: east, north; vessels are told by how near they are to them
[[nodiscard]] Surroundings surroundings_of(const RunPlace& place, double t_s,
                                           std::span<const Horizontal> vehicles_m);

}  // namespace slackwater::people
