#include "api/show/report/time_text.h"

#include <array>

#include "fields/base/month_names.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

constexpr std::array weekdays{"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};

UtcTime to_minute(UtcTime time) { return std::chrono::round<std::chrono::minutes>(time); }

const char* weekday_of(UtcDay day) { return weekdays.at(std::chrono::weekday(day).c_encoding()); }

/// "06:30" of a time to the minute.
std::string hours_and_minutes(UtcTime time) {
  const auto whole =
      std::chrono::duration_cast<std::chrono::minutes>(time - UtcTime(day_of(time))).count();
  return formatted("{:02}:{:02}", whole / 60, whole % 60);
}

}  // namespace

std::string date_text(UtcTime time) {
  const UtcDay day = day_of(to_minute(time));
  const std::chrono::year_month_day date(day);
  return formatted("{} {} {}", weekday_of(day), static_cast<unsigned>(date.day()),
                   month_names.at(static_cast<unsigned>(date.month()) - 1));
}

std::string PageClock::local(UtcTime time) const {
  if (!zone_) return {};
  const UtcTime utc = to_minute(time);
  return " (" + local_clock(utc) + " " + zone_->abbreviation_at(utc) + ")";
}

/// With the day of the week where it is another than the UTC day's.
std::string PageClock::local_clock(UtcTime utc) const {
  const UtcTime shown = utc + zone_->offset_at(utc);
  const std::string day =
      day_of(shown) == day_of(utc) ? "" : std::string(weekday_of(day_of(shown))) + " ";
  return day + hours_and_minutes(shown);
}

std::string PageClock::clocks(UtcTime from, UtcTime to) const {
  const UtcTime a = to_minute(from);
  const UtcTime b = to_minute(to);
  const bool ends_the_day = b > a && b == UtcTime(day_of(b));
  std::string text = hours_and_minutes(a) + "–" + (ends_the_day ? "24:00" : hours_and_minutes(b));
  if (!zone_) return text;
  std::string name = zone_->abbreviation_at(a);
  if (zone_->abbreviation_at(b) != name) name += "/" + zone_->abbreviation_at(b);
  return text + " (" + local_clock(a) + "–" + hours_and_minutes(b + zone_->offset_at(b)) + " " +
         name + ")";
}

std::string PageClock::clock(UtcTime time) const {
  return hours_and_minutes(to_minute(time)) + local(time);
}

std::string PageClock::stamp(UtcTime time) const {
  return date_text(time) + " " + hours_and_minutes(to_minute(time)) + local(time);
}

std::string PageClock::note() const {
  return zone_ ? "Times are UTC, in brackets local time (" + zone_->name() + ")."
               : "Times are UTC.";
}

}  // namespace slackwater::api
