#include <string_view>

#include "fields/base/time.h"
#include "tests/fuzz/fuzz_case.h"

/// ISO-8601 times, days and durations: what is read and written again is the same instant.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slackwater;
  const std::string_view text = fuzz::text_of(data, size);
  fuzz::accepts([&] {
    const UtcTime time = parse_utc(text);
    // 9999-12-31T24:00 is the first instant of a year of five digits, which the form cannot write.
    if (time < parse_utc("9999-12-31T23:59:59.999Z")) {
      fuzz::claim(parse_utc(format_utc(time)) == time,
                  "a time changes when it is written and read");
    }
  });
  fuzz::accepts([&] {
    const UtcDay day = parse_day(text);
    fuzz::claim(format_day(day) == text, "a day is not written as it was read");
    fuzz::claim(belongs_to_day(TimeCell::instant(UtcTime(day)), day),
                "midnight does not belong to its day");
  });
  fuzz::accepts([&] {
    const Duration duration = parse_duration(text);
    fuzz::claim(duration >= Duration::zero(), "a negative duration");
    const std::string minutes = std::to_string(duration.count() / 60000) + "min";
    if (duration <= std::chrono::minutes(100000)) {
      fuzz::claim(parse_duration(minutes) == duration,
                  "a duration changes when it is written in minutes");
    }
  });
  return 0;
}
