#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "twin/helm/authority.h"

namespace slackwater::twin {

/// Which client has the say over the run itself: who pauses it, steps it and lets vehicles join. At
/// most one, by the rules of `Authority`; it is kept until it is given back or the client is gone.
/// Who commands a vehicle does not have it by that, and who has it commands no vehicle.
class RunAuthority {
 public:
  /// What it is called in answers and counts; no vehicle can have that name on DDS.
  static constexpr std::string_view name = "the run";

  /// Empty: nobody.
  [[nodiscard]] const std::string& holder() const { return authority_.holder(0); }
  [[nodiscard]] std::optional<std::string> ask(std::string_view client, double now_s) {
    return authority_.ask(client, 0, name, now_s);
  }
  [[nodiscard]] std::optional<std::string> release(std::string_view client, double now_s) {
    return authority_.release(client, 0, name, now_s);
  }
  [[nodiscard]] std::optional<std::string> allow_take_over(std::string_view client, double now_s) {
    return authority_.allow_take_over(client, 0, name, now_s);
  }
  void lost(std::string_view client, double now_s) { authority_.lost(client, now_s); }
  /// The client has it from now on, whoever had it: for doors whose roles say who may.
  void take_over(std::string_view client, double now_s) { authority_.lease(client, 0, now_s); }

  /// Whether the client may pause the run, step it or let a vehicle join now. Without having asked
  /// it may only while nobody else would be held up: while nobody has the run, and no other client
  /// is at a helm. Changes nothing.
  /// @param other_at_helm  "rov is held by X", of a vehicle that another client commands; empty:
  ///                       none
  [[nodiscard]] std::optional<std::string> refusal(std::string_view client,
                                                   const std::string& other_at_helm,
                                                   double now_s) const;
  /// The same; a client that may has the run from now on.
  [[nodiscard]] std::optional<std::string> claim(std::string_view client,
                                                 const std::string& other_at_helm, double now_s);

 private:
  Authority authority_{1};
};

}  // namespace slackwater::twin
