#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "fields/base/time.h"
#include "fields/geo/geo_point.h"
#include "fields/wave/regular_wave.h"
#include "fields/wave/sea_state.h"
#include "twin/clearance/lookout.h"
#include "twin/control/route.h"
#include "twin/mission/conduct.h"
#include "twin/mission/phase.h"
#include "twin/scenario/actuator_table.h"
#include "twin/scenario/manoeuvre_task.h"
#include "twin/scenario/scenario_traffic.h"

namespace slackwater::twin {

/// Water of an issued forecast: of the store by site and day (the newest where no day is given), or
/// of a file.
struct ForecastWater {
  std::string site;
  std::optional<UtcDay> day;
  std::string file;
  /// Run even where its currents are means over hours, without most of the tide.
  bool accept_means = false;
  bool operator==(const ForecastWater&) const = default;
};

/// The current at a level of made-up water.
struct MadeUpLevel {
  double depth_m = 0;
  double east_m_s = 0;
  double north_m_s = 0;
  bool operator==(const MadeUpLevel&) const = default;
};

/// Water that somebody made up: the same at all places and times, linear between levels.
struct MadeUpWater {
  double depth_m = 0;
  std::vector<MadeUpLevel> current;  ///< by depth; one level: the same throughout; none: still
  double wind_speed_m_s = 0;         ///< at 10 m
  double wind_from_deg = 0;
  bool operator==(const MadeUpWater&) const = default;
};

/// Which waves: those of the forecast, none, or made-up ones.
struct ScenarioWaves {
  bool from_forecast = true;
  /// Those of the forecast have, in each member but the central one, the error of its height that
  /// `WaveFutures` has for the seed of the forecast: what `windows` holds limits against.
  bool have_height_errors = false;
  PartitionedSea made_up;              ///< empty and not from the forecast: a calm
  std::optional<RegularWave> regular;  ///< one wave instead of a sea
  std::size_t components = 200;
  bool operator==(const ScenarioWaves&) const = default;
};

enum class GustModel { none, dryden };

struct ScenarioStructure {
  enum class Kind { cylinder, box };
  std::string name;
  Kind kind = Kind::cylinder;
  Triple<double> centre_m;  ///< NED, of the axis or the box; z unused
  double diameter_m = 0;    ///< of a cylinder
  Triple<double> size_m;    ///< of a box, along north, east, down
  double top_m = 0;         ///< NED z, negative above the sea
  double bottom_m = 0;
  bool turns_current = false;  ///< local flow about a cylinder that reaches to the bed
  bool operator==(const ScenarioStructure&) const = default;
};

/// One thing that a vehicle does, after the one before it.
struct ScenarioTask {
  enum class Kind {
    route,  ///< patterns too, laid out
    hold,
    follow_track,
    aboard,
    stand_by,   ///< a hold, until those that it carries are back from their sortie
    actuators,  ///< thrusters, fins and ballast by a table in time
    manoeuvre,  ///< a standard one, or steps of what is kept
  };
  Phase phase = Phase::work;  ///< what it belongs to
  Kind kind = Kind::route;
  std::vector<Waypoint> waypoints;  ///< of a route
  double hold_s = 0;  ///< of `hold`, `aboard`, `actuators`; infinite: to the end. Of `manoeuvre`
                      ///< the longest that it is
  /// Its waypoints are places about the datum of the vehicle's search, and drift with that.
  bool drifts = false;
  std::optional<TrackToFollow> follow;  ///< of `follow_track`
  std::optional<ActuatorTable> table;   ///< of `actuators`
  std::optional<ManoeuvreTask> manoeuvre;
  /// Of `aboard`, where it goes at its carrier's, or at home: what becomes of its battery. Charged
  /// with so much power; infinite: another one is put in at the end; 0: it stays as it is.
  double charger_w = 0;
  /// Of `aboard`: not over before its carrier stands by. The first such task is for the carrier's
  /// first `stand_by`, and so on: one for each sortie from a place of its own.
  bool until_stand_by = false;
  bool operator==(const ScenarioTask&) const = default;
};

/// Preset of the way waypoints are followed.
enum class FollowerChoice { line_of_sight, no_feed_forward, paper, published_code };

/// How closely water and tether of a vehicle are stepped: in full, or as coarse.h says.
enum class StepDetail { full, coarse };

struct ScenarioVehicle {
  std::string name;
  std::string model;  ///< id in data/vehicles, or the path of a file
  Triple<double> start_m;
  bool starts_on_track = false;  ///< of its first task; `start_m` then says nothing
  double start_speed_m_s = 0;    ///< ahead over ground: of a track that it starts on
  double heading_rad = 0;
  double state_of_charge = 1;
  double held_voltage_v = 0;  ///< above 0: the bus is held there
  double depth_bound_m = 0;   ///< above 0: it is said where it leaves its depth by more
  std::optional<double> step_s;
  StepDetail detail = StepDetail::full;
  FollowerChoice follower = FollowerChoice::line_of_sight;
  std::optional<double> speed_m_s;
  bool is_speed_over_ground = false;  ///< `ground_speed_m_s` rather than `speed_m_s`
  std::vector<ScenarioTask> tasks;
  struct TetherStart {
    std::optional<Triple<double>> top_m;  ///< absent: on the deck of its carrier
    double length_m = 0;
    bool operator==(const TetherStart&) const = default;
  };
  std::optional<TetherStart> tether;
  /// Who carries it, and where on board: body axes of the carrier.
  struct Carrier {
    std::string name;
    Triple<double> deck_m;
    bool operator==(const Carrier&) const = default;
  };
  std::optional<Carrier> carrier;
  std::optional<Conduct> conduct;     ///< absent: it does its tasks, come what may
  bool keeps_clear = true;            ///< where the scenario says from what and how far
  bool navigates_by_sensors = false;  ///< else its autopilot is told the truth
  bool logs_sensors = false;
  bool operator==(const ScenarioVehicle&) const = default;
};

/// A run as its YAML file describes it, positions in NED metres about the origin.
struct Scenario {
  std::string name;
  std::uint64_t seed = 0;
  std::optional<UtcTime> start;  ///< absent: the first time of the forecast
  double duration_s = 0;
  double step_s = 0;  ///< of the barrier
  double log_every_s = 1;
  bool logs_sensors = false;         ///< what the vehicles' instruments show
  std::size_t rays_per_look = 2000;  ///< of those that inspect, where their plan does not say
  GeoPoint origin;
  bool has_origin = false;  ///< else the site of the forecast
  std::variant<ForecastWater, MadeUpWater> water;
  std::size_t member = 0;
  ScenarioWaves waves;
  GustModel gusts = GustModel::none;
  bool has_wakes = false;
  std::vector<ScenarioStructure> structures;
  std::vector<ScenarioVehicle> vehicles;
  /// After so long of a hold for want of a helm a vehicle goes home; 0: never. See `HelmRule`.
  double home_after_s = 60;
  ScenarioTraffic traffic;
  std::optional<StandOff> clearance;  ///< absent: nobody keeps clear of anybody
  /// The text it was read from, or, of what was laid out, that of `write_scenario`.
  std::string yaml;
  bool operator==(const Scenario&) const = default;
};

/// Reads a scenario. Everything that can be known without the forecast is checked: throws
/// Error(invalid_input) with file, line, what was found and what to do.
[[nodiscard]] Scenario read_scenario(const std::filesystem::path& file);
[[nodiscard]] Scenario parse_scenario(std::string_view yaml, std::string_view name);

}  // namespace slackwater::twin
