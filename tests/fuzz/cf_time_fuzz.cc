#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "ingest/cf/time_code.h"
#include "tests/fuzz/fuzz_case.h"

namespace {

using namespace slackwater;

/// Cuts the next line off `rest`.
std::string_view line(std::string_view& rest) {
  const std::size_t end = std::min(rest.find('\n'), rest.size());
  const std::string_view found = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return found;
}

}  // namespace

/// CF time axes: a line of units, a line with the calendar, then values as doubles of 8 bytes, at
/// most 16.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest = fuzz::text_of(data, size);
  fuzz::accepts([&] {
    if (const auto date = ingest::find_date(rest)) {
      fuzz::claim(parse_utc(format_utc(*date)) == *date, "a date that was found cannot be written");
    }
  });
  fuzz::accepts([&] {
    std::vector<std::string> warnings;
    const std::string_view units = line(rest);
    const std::string_view calendar = line(rest);
    const auto code = ingest::TimeCode::parse(units, calendar, warnings);
    fuzz::claim(code.unit_ms() > 0 && std::isfinite(code.unit_ms()), "a unit without a length");
    std::vector<UtcTime> stamps;
    double last_value = 0;
    for (; rest.size() >= sizeof(double) && stamps.size() < 16;
         rest.remove_prefix(sizeof(double))) {
      double value = 0;
      std::memcpy(&value, rest.data(), sizeof value);
      fuzz::accepts([&] {
        const UtcTime time = code.decode(value);
        fuzz::claim(parse_utc(format_utc(time)) == time, "a time that cannot be written");
        if (!stamps.empty()) {
          fuzz::claim((time < stamps.back()) <= (value < last_value), "decoding turns times round");
        }
        stamps.push_back(time);
        last_value = value;
      });
    }
    ingest::check_stamps(stamps, warnings);
    for (std::size_t i = 1; i < stamps.size(); ++i) {
      fuzz::claim(stamps[i - 1] < stamps[i], "stamps that do not ascend are accepted");
    }
  });
  return 0;
}
