#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace slackwater::ingest {

/// A number that stood where nothing was measured, and what the other values were.
struct FoundSentinel {
  double number = 0;
  std::size_t taken = 0;   ///< how many values it was
  std::size_t values = 0;  ///< of how many
  double low = 0;          ///< of the other values
  double high = -1;        ///< below `low`: there are none
  /// "5 of 480 values (1.0 %) of 'WSPD' are 99, far from the others (0 to 21 m/s); taken as ..."
  [[nodiscard]] std::string words(const std::string& name, const std::string& unit) const;
};

/// Notices numbers that files write where nothing was measured, and makes them NaN: a run of nines
/// (99, 99.9, 999, -9999 ...), -32768 and its kin, 1e20. One counts where it is the extreme of the
/// values and lies farther from all others than these span; in double or single precision. A true
/// value that is taken so is missing, and what is missing is never workable: the safe side.
[[nodiscard]] std::vector<FoundSentinel> take_sentinels(std::span<double> values);

/// Makes every value that is exactly the number NaN. @return how many
std::size_t take_number(std::span<double> values, double number) noexcept;

}  // namespace slackwater::ingest
