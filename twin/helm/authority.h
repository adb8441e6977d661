#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "twin/state/helm_rule.h"

namespace slackwater::twin {

/// Until when a client keeps a vehicle.
enum class Keeping {
  asked,      ///< until it gives it back or is gone
  renewed,    ///< while it renews velocity or thrusters
  waypoints,  ///< until its list is done
  loop        ///< as long as its list goes round
};

/// Which client holds which vehicle: at most one, for all doors. Pure: run time is passed in.
///
/// - It is got by asking, or while nobody holds it by the first valid command.
/// - While somebody holds it, nobody else gets it but by asking within `take_over_s` of the
///   holder's leave (`allow_take_over`), which goes with any change of hands. Commands are no way
///   round that.
/// - It is given back by its holder alone.
/// - It ends `renewal_s` after the last velocity or thrusters, when a list of waypoints is done,
///   and when the client is gone. A lease does not: whoever gives leases says when they are over.
class Authority {
 public:
  static constexpr double renewal_s = HelmRule{}.renewal_s;
  static constexpr double take_over_s = 10;

  explicit Authority(std::size_t vehicles) : held_(vehicles) {}

  /// One more vehicle, which nobody holds.
  void add_vehicle() { held_.emplace_back(); }

  /// Empty: nobody.
  [[nodiscard]] const std::string& holder(std::size_t vehicle) const;
  /// Nothing, or who is in the way, for people. @param name  of the vehicle
  [[nodiscard]] std::optional<std::string> ask(std::string_view client, std::size_t vehicle,
                                               std::string_view name, double now_s);
  /// Whether the client may command it now. Changes nothing.
  [[nodiscard]] std::optional<std::string> refusal(std::string_view client, std::size_t vehicle,
                                                   std::string_view name, double now_s) const;
  /// A command of the client was taken; makes it the holder where nobody was.
  /// @throws ContractViolation where `refusal` speaks against it
  void note_command(std::string_view client, std::size_t vehicle, Keeping keeping, double now_s);
  /// It is leased to the client from now on, whoever had it: for doors whose roles say who may.
  void lease(std::string_view client, std::size_t vehicle, double now_s);
  [[nodiscard]] std::optional<std::string> release(std::string_view client, std::size_t vehicle,
                                                   std::string_view name, double now_s);
  [[nodiscard]] std::optional<std::string> allow_take_over(std::string_view client,
                                                           std::size_t vehicle,
                                                           std::string_view name, double now_s);
  /// What the client held. It holds nothing from now on.
  std::vector<std::size_t> lost(std::string_view client, double now_s);
  /// The list of waypoints is done, or the vehicle takes no more commands.
  void end(std::size_t vehicle);

  /// By what its holder told it last.
  [[nodiscard]] Keeping keeping(std::size_t vehicle) const { return held_.at(vehicle).keeping; }
  [[nodiscard]] bool is_leased(std::size_t vehicle) const { return held_.at(vehicle).is_leased; }
  /// What time makes of it: call before anything else at a time. Times never fall.
  void look(double now_s);

 private:
  struct Held {
    std::string client;  ///< empty: nobody
    Keeping keeping = Keeping::asked;
    double renewed_s = 0;
    double leave_until_s = -1;  ///< of a take-over
    bool is_leased = false;
  };
  [[nodiscard]] static bool is_over(const Held& held, double now_s) noexcept;

  std::vector<Held> held_;
};

}  // namespace slackwater::twin
