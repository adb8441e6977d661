#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/live/command_topics.h"
#include "data/bag/bag.h"

namespace slackwater::live {

/// The commands of a bag, handed in again at the time of the run at which they came, counted from
/// the bag's first message: `/NAME/cmd_vel`, `thrusters` and `waypoints` of vehicles that the run
/// has. They are those of a client "bag FILE", for which the same holds as for any other.
class BagCommands {
 public:
  /// @param names  of the run's vehicles on DDS, in the order of the run
  /// @throws Error(invalid_input) for a bag without a command for any of them, and what `open_bag`
  ///         throws
  BagCommands(const std::filesystem::path& bag, const std::vector<std::string>& names, Desk& desk);

  /// At the opening of a step: what is due at its start. @param start_s  of the run
  void hand_in(double start_s);

 private:
  struct Target {
    std::size_t vehicle = 0;
    twin::CommandWhat (*read)(dds::Payload) = nullptr;
  };
  struct Due {
    double at_s = 0;
    Target target;
    dds::Bytes message;
  };
  [[nodiscard]] std::optional<Due> next();

  std::string client_;
  Desk& desk_;
  std::unique_ptr<bag::Bag> bag_;
  std::vector<std::optional<Target>> targets_;  ///< of the bag's channels
  std::optional<std::int64_t> first_ns_;
  std::optional<Due> due_;
};

}  // namespace slackwater::live
