#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "api/ask/render/render_view.h"
#include "api/ask/render/sight_choice.h"
#include "twin/inspection/instrument/pose.h"
#include "twin/render/light/lit_scene.h"
#include "twin/render/light/warmth.h"
#include "twin/render/scene/scene_of_run.h"
#include "twin/run/command.h"
#include "twin/run/set_up.h"
#include "twin/sensor/camera_pointing.h"

namespace slackwater::api {

/// A sensor on a vehicle of a run, and how one sees there.
struct MountedSensor {
  twin::RenderSensor sensor;
  std::size_t vehicle = 0;  ///< its place among those of the run
  twin::WaterType water_type;
  twin::Warmth warmth;  ///< to infrared
  bool is_overcast = false;
  int threads = 1;
};
/// @param sensor   of data/sensors, by its name
/// @param vehicle  its place among those of the run
/// @throws Error(invalid_input) for a name that is none of those in its folder
[[nodiscard]] MountedSensor mounted_sensor(const std::string& sensor, std::size_t vehicle,
                                           const SightChoice& sight,
                                           const std::filesystem::path& data_folder);

/// What of a run moves, at a moment.
struct SeenMoment {
  double t_s = 0;  ///< since the start of the run
  /// Of each of its vehicles; nothing: it was not there.
  std::span<const std::optional<twin::Carriage>> vehicles;
  /// Each command of the run that `changes_the_view`, in the order of their steps; those of a later
  /// time are left out.
  std::span<const twin::Command> commands;
};

/// Whether what is seen hangs on it beside where the vehicles are: the weather, and where somebody
/// turned a camera.
[[nodiscard]] bool changes_the_view(const twin::Command& command) noexcept;

/// A run for those who look at it: its scenario made ready once more, where nothing moves by
/// itself. Where its vehicles are, a log says (`RenderedRun`), or the run that goes on beside it
/// (`slackwater live`): the same moment is the same view, bit for bit.
///
/// A camera that somebody at the helm has turned looks along the hull and its joints (pointing.h),
/// lamps and all, and no longer at what is inspected; zoomed in, it sees less of it in as many
/// pixels. All cameras of a vehicle are turned as one.
///
/// For one thread: the weather of a moment is led in its own environment.
class SeenRun {
 public:
  /// @param vehicles  names of all, in the order of the run; those that joined it later are not
  ///                  drawn
  /// @throws as `twin::set_up`
  SeenRun(twin::Scenario scenario, const twin::Surround& surround,
          std::vector<std::string> vehicles);

  [[nodiscard]] GeoPoint origin() const noexcept { return ready_.origin; }
  [[nodiscard]] UtcTime start() const noexcept { return ready_.start; }
  /// What is left out or assumed where a sensor looks from this vehicle, for people.
  [[nodiscard]] std::vector<std::string> warnings(std::size_t vehicle) const;

  /// @throws Error(invalid_input) for a sensor outside its medium; ContractViolation for a vehicle
  ///         that is not there
  [[nodiscard]] RenderView look(const MountedSensor& mounted, const SeenMoment& moment) const;
  /// @throws as `look`, without the work of one
  void expect_sees(const MountedSensor& mounted, const SeenMoment& moment) const;

 private:
  /// What is before a sensor.
  struct Sighting {
    twin::Pose pose;
    twin::Carriage lamps_on;
    twin::RenderScene scene;
  };
  [[nodiscard]] Sighting sighting(const MountedSensor& mounted, const SeenMoment& moment,
                                  const twin::EnvironmentSampler& sampler) const;
  struct Sight {
    twin::Clarity in_water, in_air;
    bool is_stated = false;  ///< by the scenario
  };
  [[nodiscard]] Sight sight_from(std::size_t vehicle) const;
  void lead_weather(const SeenMoment& moment) const;
  [[nodiscard]] twin::CameraPointing pointing(const MountedSensor& mounted,
                                              const SeenMoment& moment) const;
  [[nodiscard]] std::vector<twin::SeenVehicle> others_than(std::size_t vehicle,
                                                           const SeenMoment& moment) const;
  [[nodiscard]] twin::Lighting lighting(const MountedSensor& mounted, const SeenMoment& moment,
                                        const twin::EnvironmentSampler& sampler,
                                        UtcTime time) const;

  twin::Scenario scenario_;
  std::vector<std::string> names_;
  twin::ReadyRun ready_;
  std::vector<std::optional<twin::VehicleShape>> shapes_;  ///< of the vehicles
  std::vector<std::shared_ptr<const twin::Inspection>> inspections_;
};

}  // namespace slackwater::api
