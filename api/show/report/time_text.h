#pragma once
#include <optional>
#include <string>
#include <utility>

#include "fields/base/local_time.h"
#include "fields/base/time.h"

namespace slackwater::api {

/// "Mon 10 Mar", of the UTC day.
[[nodiscard]] std::string date_text(UtcTime time);

/// How a page tells the time: UTC, and beside it the time of the site's clocks where the site says
/// which they are. To the nearest minute.
class PageClock {
 public:
  PageClock() = default;
  explicit PageClock(std::optional<TimeZone> zone) : zone_(std::move(zone)) {}

  /// "06:30", with a zone "06:30 (07:30 CET)".
  [[nodiscard]] std::string clock(UtcTime time) const;
  /// "06:30–07:10", with a zone "06:30–07:10 (07:30–08:10 CET)". An end at midnight is "24:00".
  [[nodiscard]] std::string clocks(UtcTime from, UtcTime to) const;
  /// "Mon 10 Mar 06:30", with a zone "Mon 10 Mar 23:30 (Tue 00:30 CET)".
  [[nodiscard]] std::string stamp(UtcTime time) const;
  /// "Times are UTC.", with a zone "Times are UTC, in brackets local time (Europe/Paris)."
  [[nodiscard]] std::string note() const;
  [[nodiscard]] const std::optional<TimeZone>& zone() const noexcept { return zone_; }

 private:
  [[nodiscard]] std::string local(UtcTime time) const;
  [[nodiscard]] std::string local_clock(UtcTime utc) const;
  std::optional<TimeZone> zone_;
};

}  // namespace slackwater::api
