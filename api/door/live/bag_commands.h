#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/door/live/command_topics.h"
#include "data/bag/bag.h"

namespace slackwater::live {

/// The commands of a bag, handed in again at the time of the run at which they came, counted from
/// the bag's first message: `/NAME/cmd_vel`, `thrusters` and `waypoints` of vehicles that the run
/// has. They are those of a client "bag FILE", for which the same holds as for any other. Where the
/// bag turns out to be damaged, that is told, and the run goes on without the rest.
class BagCommands {
 public:
  /// @param names       of the run's vehicles on DDS, in the order of the run
  /// @param on_trouble  is told what a reader of the bag should know; may be empty
  /// @throws Error(invalid_input) for a bag without a command for any of them, and what `open_bag`
  ///         throws
  BagCommands(const std::filesystem::path& bag, const std::vector<std::string>& names,
              CommandDoor& command_door, std::function<void(const std::string&)> on_trouble);

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
  /// The same, and no more after the damage.
  [[nodiscard]] std::optional<Due> next_or_end();
  void tell(const std::string& text) const;

  std::filesystem::path path_;
  std::string client_;
  CommandDoor& command_door_;
  std::function<void(const std::string&)> on_trouble_;
  std::unique_ptr<bag::Bag> bag_;
  std::vector<std::optional<Target>> targets_;  ///< of the bag's channels
  std::optional<std::int64_t> first_ns_;
  std::optional<Due> due_;
};

}  // namespace slackwater::live
