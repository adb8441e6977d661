#pragma once
#include <string>

#include "api/door/dds/message/vehicle_messages.h"
#include "twin/agent/agent.h"

namespace slackwater::live {

/// Reckons by when a vehicle must turn for home: what is left in its battery, less its reserve and
/// the way home from here in the current of now, over the power that it draws. An observer; one for
/// each vehicle.
///
/// The way home is that of its conduct, round structures; of one without conduct the straight one
/// to where it began, at its cruising speed through the water there and the power it draws.
class ReserveAdvice {
 public:
  /// @param t_s  of the run, when it begins or the vehicle joins it
  ReserveAdvice(const twin::AgentState& at_start, double t_s);
  /// @param now  of the run
  [[nodiscard]] dds::Reserve look(const twin::Agent& agent, const twin::AgentState& state,
                                  UtcTime now, double t_s);

 private:
  twin::Triple<double> start_m_;
  double looked_s_;
  double drawn_j_;
  double power_w_ = -1;  ///< below 0: not known yet
};

/// "come home by 2025-06-02T14:31:10Z", "come home now", ...
[[nodiscard]] std::string advice_of(double margin_s, UtcTime now);

}  // namespace slackwater::live
