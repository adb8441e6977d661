#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/base/config.h"
#include "fields/base/constants.h"
#include "fields/service/snapshot.h"

namespace slackwater::twin {

/// The bound that a table has for one sea, and what it was read with.
struct HeightBound {
  double at_most_m = 0;
  /// NaN: the table asks for it and nobody knows it. Then the worst period, or heading, counts.
  std::optional<double> peak_period_s;  ///< absent: the table does not ask
  std::optional<double> off_bow_rad;    ///< likewise
};

/// An upper bound on a significant wave height that goes by the peak period and by where the waves
/// come from, as operators have it for a vessel that pushes on a boat landing: the same height is
/// worse in a long swell, or abeam.
///
/// The angle off the bow lies between the direction of the bow and where the waves come from
/// (`sea_surface_wave_from_direction`): 0 are head seas, 90 degrees beam seas of either side, 180
/// following seas. Both sides are alike.
///
/// Linear between the nodes of both axes; beyond their ends as at them. What the table asks for and
/// nobody knows counts as its worst: the least bound along that axis.
struct HeightTable {
  std::vector<double> peak_period_s;    ///< ascending; empty: the same at all periods
  std::vector<double> off_bow_rad;      ///< ascending, in [0, pi]; empty: the same from all sides
  std::vector<double> at_most_m;        ///< for each angle all periods, one after the other
  std::optional<double> heading_rad{};  ///< of the hull, from true north; absent: the vehicle's own
  bool operator==(const HeightTable&) const = default;

  /// @param period_s  peak period, s; NaN, or not above 0: nobody knows it
  /// @param off_rad   off the bow, of either side, any number of turns; NaN: nobody knows it
  /// No allocation, thread-safe.
  [[nodiscard]] HeightBound limit_at(double period_s, double off_rad) const noexcept;
  /// @param own_rad  the vehicle's heading, from true north; NaN: nobody knows it
  [[nodiscard]] HeightBound limit_at(const SeaState& sea, double own_rad) const noexcept {
    return limit_at(sea.peak_period_s,
                    sea.from_direction_deg * constants::degree - heading_rad.value_or(own_rad));
  }
  /// Whether it goes by the vehicle's own heading.
  [[nodiscard]] bool goes_by_heading() const noexcept {
    return !off_bow_rad.empty() && !heading_rad;
  }
  [[nodiscard]] double least_m() const noexcept;
  [[nodiscard]] double greatest_m() const noexcept;
};

/// A table in the place of the number of `significant_wave_height_m`:
///
///     peak_period_s: [4, 6, 8, 10]
///     rows:                                        # one for each angle off the bow, ascending
///       - {from_bow_deg: 0, at_most: [1.8, 1.6, 1.4, 1.2]}
///       - {from_bow_deg: 90, at_most: [1.2, 1.1, 1.0, 0.8]}
///
/// by the period alone with `at_most` in the place of `rows`, by the angle alone without
/// `peak_period_s`, each row with one number.
/// @param range  of each bound
/// @throws Error(invalid_input) for axes that do not ascend, bounds that are no numbers of the
///         range or not as many as there are periods, and a table of one number
[[nodiscard]] HeightTable read_height_table(const Config& config, Range range);

/// "by peak period (4 to 10 s) and angle off the bow (0 to 90 degrees, heading 210)".
[[nodiscard]] std::string text_of(const HeightTable& table);
/// "1.2 m at a peak period of 9 s, waves 40 degrees off the bow", with what is beyond the table's
/// ends, or unknown.
[[nodiscard]] std::string text_of(const HeightTable& table, const HeightBound& bound);

}  // namespace slackwater::twin
