#include <cmath>
#include <string>

#include "api/door/people/station_says.h"
#include "tests/fuzz/fuzz_case.h"

namespace {

using slackwater::fuzz::accepts;
using slackwater::fuzz::claim;
using slackwater::people::StationSays;

/// Everything that anybody reads of a message, whatever it is.
void read_all(const StationSays& says) {
  accepts([&] {
    const std::int64_t whole = says.whole("number", 1, 1000);
    claim(whole >= 1 && whole <= 1000, "a whole number out of range");
  });
  accepts([&] {
    const double number = says.number("at", -10, 10);
    claim(number >= -10 && number <= 10, "a number out of range");
  });
  accepts([&] {
    const std::string text = says.text("name", 40);
    claim(!text.empty() && text.size() <= 40, "a text out of range");
  });
  accepts([&] { (void)says.flag("is_on", true); });
  accepts([&] {
    const std::optional<double> number = says.number_if("over_s", 1, 60);
    claim(!number || (*number >= 1 && *number <= 60), "a number out of range");
  });
  accepts([&] {
    const std::optional<StationSays> wind = says.object_if("wind");
    if (!wind) return;
    claim(wind->what().starts_with(says.what()), "a part that does not say whose it is");
    (void)wind->number("speed_m_s", 0, 60);
  });
  accepts([&] {
    for (const double number : says.numbers("velocity", 4))
      claim(std::isfinite(number), "a number that is none");
  });
  accepts([&] {
    for (const StationSays& place : says.list("places", 3)) {
      claim(place.what().starts_with(says.what()), "a part that does not say whose it is");
      accepts([&] { (void)place.number("east_m", -1, 1); });
      accepts([&] { (void)place.list("places", 3); });
    }
  });
}

}  // namespace

/// A message of a person's station.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  accepts([&] {
    const StationSays says(slackwater::fuzz::text_of(data, size));
    for (const char c : says.what()) claim(c >= ' ' && c <= '~', "a word that cannot be printed");
    claim(says.id().is_null() || says.id().is_number_integer(), "an id that is no number");
    read_all(says);
  });
  return 0;
}
