#include "ingest/quality/sentinel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fields/base/constants.h"
#include "fields/base/text.h"

namespace slackwater::ingest {
namespace {

/// Runs of nines, the ends of 16-bit numbers, the fill of climate models (CMIP: 1e20) and that of
/// the NetCDF library. The largest first: 9999 hides that 99 is far from the rest, not the other
/// way round.
constexpr std::array usual_sentinels{9.969209968386869e36,
                                     1e20,
                                     -1e20,
                                     99999.0,
                                     -99999.0,
                                     -32768.0,
                                     32767.0,
                                     -32767.0,
                                     9999.99,
                                     -9999.99,
                                     9999.9,
                                     -9999.9,
                                     9999.0,
                                     -9999.0,
                                     999.99,
                                     -999.99,
                                     999.9,
                                     -999.9,
                                     999.0,
                                     -999.0,
                                     99.99,
                                     -99.99,
                                     99.9,
                                     -99.9,
                                     99.0,
                                     -99.0};

bool is_number(double value, double number) noexcept {
  return value == number || value == static_cast<double>(static_cast<float>(number));
}

}  // namespace

std::string FoundSentinel::words(const std::string& name, const std::string& unit) const {
  const std::string others =
      low <= high ? formatted(", far from the others ({:g} to {:g} {})", low, high, unit)
                  : std::string(": there is no other value");
  return formatted(
      "{} of {} values ({:.1f} %) of '{}' are {:g}{}; taken as not measured, they "
      "count as missing",
      taken, values, 100.0 * static_cast<double>(taken) / static_cast<double>(values), name, number,
      others);
}

std::size_t take_number(std::span<double> values, double number) noexcept {
  std::size_t taken = 0;
  for (double& value : values) {
    if (!is_number(value, number)) continue;
    value = constants::nan;
    ++taken;
  }
  return taken;
}

std::vector<FoundSentinel> take_sentinels(std::span<double> values) {
  std::vector<FoundSentinel> found;
  const auto known = static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [](double value) { return !std::isnan(value); }));
  for (const double number : usual_sentinels) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    bool is_there = false;
    for (const double value : values) {
      if (std::isnan(value)) continue;
      if (is_number(value, number)) {
        is_there = true;
        continue;
      }
      low = std::min(low, value);
      high = std::max(high, value);
    }
    if (!is_there) continue;
    const double gap = number > high ? number - high : low - number;
    const bool is_alone = low > high;
    if (!is_alone && !(gap > high - low && gap > 0)) continue;
    FoundSentinel one;
    one.number = number;
    one.values = known;
    if (!is_alone) {
      one.low = low;
      one.high = high;
    }
    one.taken = take_number(values, number);
    found.push_back(one);
  }
  return found;
}

}  // namespace slackwater::ingest
