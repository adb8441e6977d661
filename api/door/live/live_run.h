#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/ask/run/scenario_run.h"
#include "api/door/dds/participant.h"
#include "api/door/live/action_teller.h"
#include "api/door/live/bag_commands.h"
#include "api/door/live/host_link.h"
#include "api/door/live/punctuality.h"
#include "api/door/live/record_teller.h"
#include "api/door/live/topics/sensor_publisher.h"
#include "api/door/live/topics/stream.h"

namespace slackwater::live {

/// How a run is made live.
struct LiveSettings {
  std::optional<dds::DomainSettings> domain;  ///< nothing: not on DDS
  HostRule when_host_fails = HostRule::take_back;
  std::string site = "site";    ///< its id
  double real_time_factor = 0;  ///< of the run, for its punctuality
  /// Bags whose commands are handed in again, each as a client of its own.
  std::vector<std::filesystem::path> played_commands;
  /// Recordings, viewers: told of everything besides.
  std::vector<std::shared_ptr<Outlet>> outlets;
  SensorsAsked see;                     ///< that its vehicles carry
  OnPicture on_picture;                 ///< what its cameras saw, for people; may be null
  std::shared_ptr<ActionPost> actions;  ///< of people who take part; null: nobody can
  /// What operators should know of. From any thread.
  std::function<void(const std::string&)> on_trouble;
  /// A vehicle joined the run, and has this name on DDS. On the thread of the run.
  std::function<void(const twin::Agent& vehicle, const std::string& name)> on_newcomer;
};

/// The names of a run's vehicles as tokens of ROS, each once: "ROV 1" and "rov-1" become ROV_1 and
/// rov_1_2, as topics that differ in case alone are one for some.
[[nodiscard]] std::vector<std::string> ros_names(std::span<const twin::Agent> agents);

/// Joins a run and makes it live: voices that tell, desks that take commands and hosts, at their
/// doors. There until the run has made its last step (`RunChoice::on_over`).
class LiveRun {
 public:
  /// @throws Error(unavailable) where the domain cannot be joined; as `SensorPublisher`
  LiveRun(const api::RunInHand& hand, const LiveSettings& settings);
  ~LiveRun();
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  /// Vehicles and their names on DDS, in the order of the run. Between steps.
  [[nodiscard]] const std::vector<std::string>& names() const noexcept;
  /// Between steps.
  [[nodiscard]] const Punctuality& punctuality() const noexcept;
  /// How its sensors fared. After the last step: waits for what they are looking at.
  [[nodiscard]] std::vector<SensorTold> end_sensors();
  /// What became of the bags of commands so far. Between steps.
  [[nodiscard]] std::vector<PlayedBag> played() const;
  /// Of a run that is made again: what was told of its record so far. Between steps.
  [[nodiscard]] const RecordTold& record_told() const noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace slackwater::live
