#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "api/door/live/topics/stream.h"
#include "api/door/live/topics/vehicle_publisher.h"
#include "twin/helm/command_arbiter.h"

namespace slackwater::live {

/// What became of a command that was handed in.
struct Submitted {
  std::optional<std::string> refusal;  ///< why it was not taken, for people; nothing: it was
  std::uint64_t number = 0;  ///< of those that its vehicle has taken; see `CommandArbiter::taken`
};

/// Where all doors hand in what clients ask of vehicles. It counts for them, lets the arbiter
/// decide, and sees to it that what was heard and what was refused is told and recorded:
/// `/NAME/cmd_vel`, `thrusters`, `actuators` and `waypoints` as they were taken, and
/// `/NAME/refused`, std_msgs/msg/String with {"client", "reason", "text"}.
///
/// `speak` and `open` are for the thread of the run, all else for any thread.
class CommandDoor {
 public:
  CommandDoor(Stream& stream, twin::CommandArbiter& arbiter, const RunPlace& place);

  /// Vehicles in the order of the run.
  void open(const std::string& name, std::shared_ptr<const twin::Vehicle> model);
  /// What is known of a vehicle that was opened.
  [[nodiscard]] std::shared_ptr<const twin::Vehicle> model(std::size_t vehicle);

  /// @param heard  the message as it came, of a command topic; empty: none
  /// @param held_back_s  on its way here; velocity, thrusters and actuators of too long ago are
  /// stale
  Submitted submit(const std::string& client, std::size_t vehicle, twin::CommandWhat what,
                   const dds::Bytes& heard = {}, double held_back_s = 0);
  /// What could not even be read; counted like any other.
  void refuse(const std::string& client, std::size_t vehicle, const std::string& text);

  // Of a run that is made again from its record, on the thread of the run.
  /// What was taken, as it was heard. @return whether there is a topic for it
  bool tell_taken(std::size_t vehicle, const twin::CommandWhat& what);
  /// What was refused: the last of them, with the "count" where that is more than one.
  void tell_refused(std::size_t vehicle, const twin::RefusalCount& refusal);
  /// By its name on DDS.
  [[nodiscard]] std::optional<std::size_t> vehicle(const std::string& name);

  /// A client is gone: what it held holds, and nothing of it is kept.
  void lost(const std::string& client);

  [[nodiscard]] twin::CommandArbiter& arbiter() noexcept { return arbiter_; }
  /// Publishes what came in since the last time.
  void speak(double t_s);

 private:
  struct Vehicle {
    std::string name;
    std::shared_ptr<const twin::Vehicle> model;
    Stream::ChannelId velocity, thrusters, actuators, waypoints, refused;
  };
  struct Said {
    Stream::ChannelId channel;
    dds::Bytes message;
  };
  [[nodiscard]] std::optional<twin::Refusal> stale(const std::string& client, std::size_t vehicle,
                                                   double held_back_s, double now_s);
  using OfVehicle = Stream::ChannelId Vehicle::*;
  [[nodiscard]] static OfVehicle channel_of(const twin::CommandWhat& what) noexcept;
  void say_heard(std::size_t vehicle, OfVehicle channel, dds::Bytes heard);
  void say_refused(const std::string& client, std::size_t vehicle, const char* reason,
                   const std::string& text, std::uint64_t count = 1);

  Stream& stream_;
  twin::CommandArbiter& arbiter_;
  RunPlace place_;
  std::mutex order_;  ///< of what comes in, which may take long to look at
  std::map<std::pair<std::string, std::size_t>, std::uint64_t> counts_;
  std::mutex mutex_;  ///< of what is told, for which a barrier waits
  std::vector<Vehicle> vehicles_;
  std::vector<Said> said_;
  std::size_t refused_ = 0;                          ///< among them
  static constexpr std::size_t most_refused = 1000;  ///< between two barriers; more are not told
};

}  // namespace slackwater::live
