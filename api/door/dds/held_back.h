#pragma once
#include <limits>

namespace slackwater::dds {

/// How long each message of one writer was held back on its way: its delay less the least one of
/// the last half to whole minute. The clocks of the two need not agree, only go equally fast; one
/// that is set makes messages look held back for a minute at most.
class HeldBack {
 public:
  /// In the order in which they come.
  /// @param sent_s  by the writer's clock
  /// @param came_s  by ours, which is never set
  /// @return s
  double look(double sent_s, double came_s) noexcept;

 private:
  static constexpr double half_s = 30;
  static constexpr double none = std::numeric_limits<double>::infinity();

  double begun_s_ = -none;  ///< the half minute
  double least_s_ = none;   ///< of it
  double before_s_ = none;  ///< of the one before
};

}  // namespace slackwater::dds
