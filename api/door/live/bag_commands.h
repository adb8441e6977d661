#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/door/live/bag_clock.h"
#include "api/door/live/command_topics.h"
#include "data/bag/bag.h"

namespace slackwater::live {

/// What became of the commands of a bag.
struct PlayedBag {
  std::filesystem::path path;
  std::uint64_t handed_in = 0;
  std::uint64_t taken = 0;            ///< of them; the others were refused
  std::optional<double> left_from_s;  ///< of the first that the run did not come to; nothing: none

  /// "drive.mcap: 600 commands handed in, 598 taken; ..."
  [[nodiscard]] std::string text() const;
};

/// The commands of a bag, handed in again at the time of the run at which they came (`BagClock`):
/// `/NAME/cmd_vel`, `thrusters`, `actuators` and `waypoints` of vehicles that the run has; a
/// velocity may be stamped. They are those of a client "bag FILE", for which the same holds as for
/// any other. Commands of another type, or for other vehicles, are told of once a topic. Where the
/// bag turns out to be damaged, that is told, and the run goes on without the rest.
class BagCommands {
 public:
  /// @param names       of the run's vehicles on DDS, in the order of the run
  /// @param run_s       length of the run
  /// @param on_trouble  is told what a reader of the bag should know; may be empty
  /// @throws Error(invalid_input) for a bag without a command for any of them within the run, and
  ///         what `open_bag` throws
  BagCommands(const std::filesystem::path& bag, const std::vector<std::string>& names, double run_s,
              CommandDoor& command_door, std::function<void(const std::string&)> on_trouble);

  /// At the opening of a step: what is due at its start. @param start_s  of the run
  void hand_in(double start_s);

  /// So far.
  [[nodiscard]] PlayedBag played() const;

 private:
  struct Channel {
    std::size_t vehicle = 0;
    const CommandTopic* topic = nullptr;  ///< null: nothing of ours
    std::string unread;  ///< why it is none, though it looks like it; said with its first message
  };
  struct Due {
    double at_s = 0;
    Channel* channel = nullptr;
    dds::Bytes message;
  };
  [[nodiscard]] Channel channel_of(const bag::Channel& channel) const;
  [[nodiscard]] std::optional<Due> next();
  /// The same, and no more after the damage.
  [[nodiscard]] std::optional<Due> next_or_end();
  void expect_any(double run_s) const;
  void tell(const std::string& text) const;

  std::filesystem::path path_;
  std::string client_;
  std::vector<std::string> names_;
  CommandDoor& command_door_;
  std::function<void(const std::string&)> on_trouble_;
  std::unique_ptr<bag::Bag> bag_;
  std::vector<Channel> channels_;
  BagClock clock_;
  std::optional<Due> due_;
  PlayedBag played_;
};

}  // namespace slackwater::live
