#include "api/door/live/bag_clock.h"

#include "fields/base/text.h"

namespace slackwater::live {
namespace {

constexpr double rounding_s = 1e-6;

}  // namespace

double BagClock::time_s(const bag::Recorded& message, const std::string& topic, bool is_used) {
  const std::int64_t now_ns = message.log_time_ns;
  if (!first_ns_) {
    first_ns_ = now_ns;
    first_topic_ = topic;
  } else if (const double gap_s = 1e-9 * static_cast<double>(now_ns - *last_ns_);
             !has_used_ && gap_s >= run_s_ - rounding_s) {
    first_ns_ = now_ns;
    left_out_ = before_;
    gap_s_ = gap_s;
  }
  ++before_;
  last_ns_ = now_ns;
  has_used_ = has_used_ || is_used;
  return 1e-9 * static_cast<double>(now_ns - *first_ns_);
}

std::string BagClock::left_out() const {
  if (left_out_ == 0) return {};
  return formatted(
      "its first {} ({}) {} {:.0f} s before the next, no less than the run of {:g} s: times "
      "count from that one",
      left_out_ == 1 ? "message" : std::to_string(left_out_) + " messages", first_topic_,
      left_out_ == 1 ? "lies" : "lie", gap_s_, run_s_);
}

}  // namespace slackwater::live
