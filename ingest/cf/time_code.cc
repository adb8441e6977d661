#include "ingest/cf/time_code.h"

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "fields/base/numbers/statistics.h"
#include "ingest/cf/text_scanner.h"

namespace slackwater::ingest {
namespace {

constexpr std::int64_t day_ms = 86'400'000;
constexpr const char* expected_form = "expected e.g. 'hours since 1950-01-01 00:00:00'";

[[noreturn]] void refuse_code(std::string_view units, const std::string& why) {
  throw Error(ErrorKind::invalid_input, "time units '" + std::string(units) + "': " + why);
}

double unit_of(std::string_view word, std::string_view units) {
  std::string name(word);
  std::transform(name.begin(), name.end(), name.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  const auto is = [&](std::initializer_list<const char*> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (is({"second", "seconds", "sec", "secs", "s"})) return 1e3;
  if (is({"minute", "minutes", "min", "mins"})) return 6e4;
  if (is({"hour", "hours", "hr", "hrs", "h"})) return 3.6e6;
  if (is({"day", "days", "d"})) return 8.64e7;
  if (is({"week", "weeks"})) return 6.048e8;
  if (is({"millisecond", "milliseconds", "msec", "msecs", "ms"})) return 1.0;
  if (is({"microsecond", "microseconds"})) return 1e-3;
  if (is({"nanosecond", "nanoseconds"})) return 1e-6;
  if (is({"month", "months", "year", "years", "common_year", "common_years"})) {
    refuse_code(units, "a " + name + " has no fixed length; rewrite the axis in days or hours");
  }
  refuse_code(units, "unknown unit '" + std::string(word) + "'; " + expected_form);
}

/// Days from 1970-01-01 (Gregorian) of a date in the Julian calendar.
/// Source: Richards, Explanatory Supplement to the Astronomical Almanac (3rd ed.), section 15.11,
/// Julian day number.
std::int64_t days_of_julian_date(int year, int month, int day) {
  const int a = (14 - month) / 12;
  const std::int64_t y = std::int64_t{year} + 4800 - a;
  const int m = month + 12 * a - 3;
  return day + (153 * m + 2) / 5 + 365 * y + y / 4 - 32083 - 2440588;
}

std::int64_t days_of_gregorian_date(int year, int month, int day, std::string_view units) {
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) refuse_code(units, std::string("no such reference date; ") + expected_form);
  return std::chrono::sys_days(date).time_since_epoch().count();
}

struct Reference {
  int year = 0, month = 1, day = 1;
  std::int64_t time_of_day_ms = 0;
};

/// "H[:M[:S[.f]]]" or "HHMM[SS]" in milliseconds; nothing if the text is no time of day.
std::optional<std::int64_t> time_of_day(TextScanner& scan) {
  const auto hour = scan.number(1, 2);
  if (!hour) return std::nullopt;
  int minute = 0;
  double second = 0;
  if (scan.take(':') || scan.at_digit()) {
    const auto found = scan.number(1, 2);
    if (!found) return std::nullopt;
    minute = *found;
    if (scan.take(':') || scan.at_digit()) {
      const auto found_s = scan.decimal();
      if (!found_s) return std::nullopt;
      second = *found_s;
    }
  }
  if (*hour > 24 || minute > 59 || second > 60.0) return std::nullopt;
  return *hour * std::int64_t{3'600'000} + minute * std::int64_t{60'000} +
         std::llround(second * 1000.0);
}

/// "Z", "UTC", "GMT", "+01:00", "-0330", "+2" in milliseconds east of Greenwich.
std::optional<std::int64_t> zone(TextScanner& scan) {
  if (scan.take_word("z") || scan.take_word("utc") || scan.take_word("gmt")) return 0;
  const int sign = scan.take('+') ? 1 : scan.take('-') ? -1 : 0;
  if (sign == 0) return std::nullopt;
  const auto digits = scan.number(1, 4);
  if (!digits) return std::nullopt;
  int hours = *digits;
  int minutes = 0;
  if (scan.take(':')) {
    const auto found = scan.number(2, 2);
    if (!found) return std::nullopt;
    minutes = *found;
  } else if (hours > 99) {
    minutes = hours % 100;
    hours /= 100;
  }
  if (hours > 14 || minutes > 59) return std::nullopt;
  return sign * (hours * std::int64_t{3'600'000} + minutes * std::int64_t{60'000});
}

Reference parse_reference(TextScanner& scan, std::string_view units) {
  Reference reference;
  const auto year = scan.number(1, 4);
  const bool dashes = year && scan.take('-');
  const auto month = dashes ? scan.number(1, 2) : std::nullopt;
  const auto day = month && scan.take('-') ? scan.number(1, 2) : std::nullopt;
  if (!day || *month < 1 || *month > 12 || *day < 1 || *day > 31) {
    refuse_code(units, std::string("no reference date; ") + expected_form);
  }
  reference = {*year, *month, *day, 0};
  const bool spaced = scan.skip_blanks();
  const bool letter = scan.take('T') || scan.take('t');
  if ((spaced || letter) && scan.at_digit()) {
    const auto time = time_of_day(scan);
    if (!time) refuse_code(units, std::string("no such reference time; ") + expected_form);
    reference.time_of_day_ms = *time;
  }
  scan.skip_blanks();
  if (!scan.at_end()) {
    const auto offset = zone(scan);
    scan.skip_blanks();
    if (!offset || !scan.at_end())
      refuse_code(units, std::string("unreadable after the date; ") + expected_form);
    reference.time_of_day_ms -= *offset;
  }
  return reference;
}

enum class Calendar { standard, proleptic };

Calendar calendar_of(std::string_view name, int reference_year,
                     std::vector<std::string>& warnings) {
  std::string word(name);
  std::transform(word.begin(), word.end(), word.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  if (word.empty() || word == "standard" || word == "gregorian") return Calendar::standard;
  if (word == "proleptic_gregorian") return Calendar::proleptic;
  if (word == "julian" || word == "noleap" || word == "365_day") {
    if (reference_year >= 1900) {
      warnings.push_back("the time axis says calendar '" + word +
                         "', read as Gregorian (reference year " + std::to_string(reference_year) +
                         ")");
      return Calendar::standard;
    }
    throw Error(ErrorKind::invalid_input,
                "calendar '" + word + "' with a reference in the year " +
                    std::to_string(reference_year) +
                    "; expected standard or proleptic_gregorian; rewrite the time axis");
  }
  throw Error(ErrorKind::invalid_input,
              "calendar '" + std::string(name) +
                  "'; expected standard, gregorian or proleptic_gregorian; model years "
                  "cannot be put on real days");
}

}  // namespace

TimeCode TimeCode::parse(std::string_view units, std::string_view calendar,
                         std::vector<std::string>& warnings) {
  TextScanner scan(units);
  scan.skip_blanks();
  const std::string_view word = scan.word();
  scan.skip_blanks();
  if (word.empty() || !scan.take_word("since"))
    refuse_code(units, std::string("no time units; ") + expected_form);
  scan.skip_blanks();
  TimeCode code;
  code.unit_ms_ = unit_of(word, units);
  const Reference reference = parse_reference(scan, units);
  const Calendar kind = calendar_of(calendar, reference.year, warnings);
  const bool before_gregory =
      reference.year < 1582 ||
      (reference.year == 1582 &&
       (reference.month < 10 || (reference.month == 10 && reference.day < 15)));
  const std::int64_t days =
      kind == Calendar::standard && before_gregory
          ? days_of_julian_date(reference.year, reference.month, reference.day)
          : days_of_gregorian_date(reference.year, reference.month, reference.day, units);
  code.reference_ms_ = days * day_ms + reference.time_of_day_ms;
  return code;
}

UtcTime TimeCode::decode(double value) const {
  const double ms = value * unit_ms_;
  constexpr double largest_ms = 1e15;  // some 30 000 years
  if (!(std::abs(ms) < largest_ms)) {
    throw Error(ErrorKind::invalid_input,
                "a time of " + std::to_string(value) +
                    " units is no date; expected a finite "
                    "number near the present; the stamp is missing or damaged");
  }
  const UtcTime time{Duration(reference_ms_ + std::llround(ms))};
  static const UtcTime earliest = parse_utc("1600-01-01T00:00:00Z");
  static const UtcTime latest = parse_utc("2500-01-01T00:00:00Z");
  if (time < earliest || time > latest) {
    throw Error(ErrorKind::invalid_input,
                "a time of " + std::to_string(value) +
                    " units lies outside the years 1600 to 2500; check its units");
  }
  return time;
}

void check_stamps(const std::vector<UtcTime>& stamps, std::vector<std::string>& warnings) {
  std::vector<Duration> steps;
  for (std::size_t t = 1; t < stamps.size(); ++t) {
    if (stamps[t] <= stamps[t - 1]) {
      const bool same = stamps[t] == stamps[t - 1];
      throw Error(
          ErrorKind::invalid_input,
          std::string(same ? "duplicate time" : "time runs backward") + " at index " +
              std::to_string(t) + ": " + format_utc(stamps[t]) + " after " +
              format_utc(stamps[t - 1]) +
              "; expected times that ascend; sort the file and drop duplicates (cdo mergetime)");
    }
    steps.push_back(stamps[t] - stamps[t - 1]);
  }
  if (steps.size() < 2) return;
  const Duration usual = lower_median(steps);
  for (std::size_t t = 0; t < steps.size(); ++t) {
    if (2 * steps[t] > 3 * usual) {
      warnings.push_back("gap in time: nothing between " + format_utc(stamps[t]) + " and " +
                         format_utc(stamps[t + 1]) + " where stamps are usually " +
                         std::to_string(usual.count() / 60000) + " min apart");
      return;  // one is enough for an operator to look
    }
  }
}

std::optional<FoundDate> find_date_and_clock(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (at > 0 && text[at - 1] >= '0' && text[at - 1] <= '9') continue;
    TextScanner scan(text.substr(at));
    const auto year = scan.number(4, 4);
    if (!year) continue;
    const bool dashed = scan.take('-');
    const auto month = scan.number(2, 2);
    if (!month || (dashed && !scan.take('-'))) continue;
    const auto day = scan.number(2, 2);
    if (!day) continue;
    const std::chrono::year_month_day date{std::chrono::year(*year),
                                           std::chrono::month(static_cast<unsigned>(*month)),
                                           std::chrono::day(static_cast<unsigned>(*day))};
    if (!date.ok() || *year < 1900) continue;
    FoundDate found{UtcTime(std::chrono::sys_days(date)), false};
    if (scan.skip_blanks() || scan.take('T') || scan.take('-')) {
      if (const auto clock = time_of_day(scan)) {
        found.time += Duration(*clock);
        found.has_clock = true;
        if (const auto offset = zone(scan)) found.time -= Duration(*offset);
      }
    }
    return found;
  }
  return std::nullopt;
}

std::optional<UtcTime> find_date(std::string_view text) {
  const auto found = find_date_and_clock(text);
  if (!found) return std::nullopt;
  return found->time;
}

}  // namespace slackwater::ingest
