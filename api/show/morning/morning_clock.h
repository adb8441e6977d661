#pragma once
#include <string>

#include "api/ask/morning/morning.h"
#include "api/show/report/time_text.h"

namespace slackwater::api {

/// How a morning tells its times: by the clock alone where all its starts are of one UTC day, else
/// with the day.
class MorningClock {
 public:
  explicit MorningClock(const Morning& morning)
      : MorningClock(morning, morning.windows.from, morning.windows.to) {}

  /// "06:30", "Fri 14 Mar 06:30".
  [[nodiscard]] std::string operator()(UtcTime time) const {
    return is_one_day_ ? clock_.clock(time) : clock_.stamp(time);
  }
  /// The same in UTC alone.
  [[nodiscard]] std::string utc(UtcTime time) const {
    return is_one_day_ ? PageClock().clock(time) : PageClock().stamp(time);
  }
  /// "06:30–09:30"; one start by itself "06:30".
  [[nodiscard]] std::string operator()(UtcTime first, UtcTime last) const {
    if (first == last) return (*this)(first);
    return is_one_day_ ? clock_.clocks(first, last)
                       : clock_.stamp(first) + "–" + clock_.stamp(last);
  }
  /// "on Fri 14 Mar" of a whole day, "from Fri 14 Mar 06:00 to Sat 15 Mar 18:00".
  [[nodiscard]] std::string span() const {
    const bool is_whole = from_ == UtcTime(day_of(from_)) && to_ - from_ == std::chrono::days(1);
    return is_whole ? "on " + date_text(from_)
                    : "from " + clock_.stamp(from_) + " to " + clock_.stamp(to_);
  }
  [[nodiscard]] std::string note() const { return clock_.note(); }

 private:
  MorningClock(const Morning& morning, UtcTime from, UtcTime to)
      : clock_(morning.question.windows.zone),
        from_(from),
        to_(to),
        is_one_day_(day_of(from) == day_of(to - Duration(1))) {}
  PageClock clock_;
  UtcTime from_, to_;
  bool is_one_day_;
};

}  // namespace slackwater::api
