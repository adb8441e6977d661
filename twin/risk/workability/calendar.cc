#include "twin/risk/workability/calendar.h"

#include <charconv>
#include <string_view>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

/// The local times of a series' steps, asked for in order.
class LocalClock {
 public:
  LocalClock(const StepClock& clock, const std::optional<TimeZone>& zone) : clock_(clock) {
    if (zone && clock.steps > 0) changes_ = zone->changes(clock.first, clock.end());
  }
  /// @param i  no smaller than at the call before
  UtcTime operator()(std::size_t i) {
    const UtcTime time = clock_.time_of(i);
    if (changes_.empty()) return time;
    while (next_ < changes_.size() && changes_[next_].at <= time) ++next_;
    return time + changes_[next_ - 1].offset;
  }

 private:
  StepClock clock_;
  std::vector<ClockChange> changes_;
  std::size_t next_ = 1;
};

std::chrono::year_month month_of(UtcTime local) {
  const std::chrono::year_month_day date{day_of(local)};
  return date.year() / date.month();
}

/// "6" or "06:30" in minutes; nothing for anything else, or beyond 24:00.
std::optional<std::chrono::minutes> time_of_day(std::string_view text) {
  const auto number = [](std::string_view digits) -> std::optional<int> {
    int value = 0;
    const auto [stop, problem] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (problem != std::errc{} || stop != digits.data() + digits.size() || digits.size() > 2)
      return std::nullopt;
    return value;
  };
  const std::size_t colon = text.find(':');
  const auto hour = number(text.substr(0, colon));
  const auto minute = colon == std::string_view::npos ? 0 : number(text.substr(colon + 1));
  if (!hour || !minute || *hour < 0 || *hour > 24 || *minute < 0 || *minute > 59 ||
      (*hour == 24 && *minute > 0))
    return std::nullopt;
  return std::chrono::minutes(60 * *hour + *minute);
}

std::string clock_text(std::chrono::minutes minutes) {
  return formatted("{:02}:{:02}", minutes.count() / 60, minutes.count() % 60);
}

}  // namespace

std::vector<MonthSteps> months_of(const StepClock& clock, const std::optional<TimeZone>& zone) {
  std::vector<MonthSteps> months;
  LocalClock local(clock, zone);
  UtcTime next = UtcTime::min();  // local time at which the next month begins
  for (std::size_t i = 0; i < clock.steps; ++i) {
    const UtcTime time = local(i);
    if (time >= next) {
      const std::chrono::year_month month = month_of(time);
      next = std::chrono::sys_days((month + std::chrono::months(1)) / 1);
      months.push_back({static_cast<int>(month.year()),
                        static_cast<int>(static_cast<unsigned>(month.month())),
                        {i, i}});
    }
    months.back().steps.end = i + 1;
  }
  return months;
}

std::vector<YearDate> dates_of(const StepClock& clock, const std::chrono::month_day& date,
                               const std::optional<TimeZone>& zone) {
  std::vector<YearDate> dates;
  LocalClock local(clock, zone);
  const auto midnight = [&](std::chrono::year year) {
    return UtcTime(std::chrono::sys_days(year / date.month() / date.day()));
  };
  if (clock.steps == 0) return dates;
  const UtcTime begin = local(0);
  std::chrono::year year = month_of(begin).year();
  // Local midnight of the date this year lies before the series, or is where it begins.
  while (midnight(year) < begin) ++year;
  for (std::size_t i = 0; i < clock.steps; ++i) {
    if (local(i) < midnight(year)) continue;
    dates.push_back({static_cast<int>(year), i});
    ++year;
  }
  return dates;
}

DayHours parse_day_hours(const std::string& text) {
  const std::size_t dash = text.find('-');
  const auto from = time_of_day(std::string_view(text).substr(0, dash));
  const auto to = dash == std::string::npos ? std::nullopt
                                            : time_of_day(std::string_view(text).substr(dash + 1));
  if (!from || !to || *from == *to || *from == std::chrono::hours(24))
    throw Error(ErrorKind::invalid_input,
                "found '" + text +
                    "' where hours of the day were expected; write them as 6-18 or 06:30-18:00, "
                    "the end being the first minute that is too late");
  return {*from, *to};
}

std::string text_of(const DayHours& hours) {
  return clock_text(hours.from) + " to " + clock_text(hours.to);
}

StepRanges steps_at(const StepClock& clock, const DayHours& hours,
                    const std::optional<TimeZone>& zone) {
  StepRanges ranges;
  LocalClock local(clock, zone);
  for (std::size_t i = 0; i < clock.steps; ++i) {
    const UtcTime time = local(i);
    const auto minute = std::chrono::floor<std::chrono::minutes>(time - day_of(time));
    if (!hours.holds(minute)) continue;
    if (!ranges.empty() && ranges.back().end == i)
      ++ranges.back().end;
    else
      ranges.push_back({i, i + 1});
  }
  return ranges;
}

}  // namespace slackwater::twin
