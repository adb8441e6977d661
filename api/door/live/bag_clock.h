#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "data/bag/bag.h"

namespace slackwater::live {

/// The times of a bag that is played to a run, counted from its first message. What lies before a
/// gap as long as the run cannot be played with what lies behind it: where nothing of it is used
/// (a few messages that were stamped 0 before the clock of a simulation was there), times count
/// from behind the gap.
class BagClock {
 public:
  /// @param run_s  length of the run
  explicit BagClock(double run_s) : run_s_(run_s) {}

  /// In the bag's order. @param is_used  by the run
  /// @return s, 0 or more; of a message that is not used nobody needs it
  double time_s(const bag::Recorded& message, const std::string& topic, bool is_used);

  /// What times do not count from, for people; empty: they count from the first message.
  [[nodiscard]] std::string left_out() const;

 private:
  double run_s_;
  std::optional<std::int64_t> first_ns_, last_ns_;
  bool has_used_ = false;
  std::uint64_t before_ = 0;    ///< messages before the last one
  std::uint64_t left_out_ = 0;  ///< of them those before the last gap
  double gap_s_ = 0;            ///< the last one
  std::string first_topic_;     ///< of the bag
};

}  // namespace slackwater::live
